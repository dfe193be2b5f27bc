// SPDX-License-Identifier: Apache-2.0
// Which of the possible folds is next.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "tactics/solid/panel.h"

namespace tactics {

/// Which of the possible folds is next.
enum class Strategy : std::uint8_t {
    longest,   ///< about the side that is longest against the panel's border
    broadest,  ///< the fewest folds from what lies where it is
    largest,   ///< of the largest panel
    nearest,   ///< of the panel nearest to the reader
    deepest,   ///< the most folds: strips
};

/// What folds of a model are worth. Folds that are worth nearly the same are worth the same, so that the last digits of a file do
/// not put one before the other.
class FoldWorth {
public:
    /// `panels` must outlive it.
    FoldWorth(const std::vector<ModelPart>& parts, const Panels& panels, const ViewPlane& view);
    /// Of folding `child` about a hinge out of a panel that was reached by that many folds.
    double of(Strategy strategy, std::uint32_t hinge, std::uint32_t child, int folds) const;

private:
    const Panels& panels_;
    std::vector<double> size_, near_;           // of each panel, how large and how near to the reader
    std::vector<std::array<double, 2>> sides_;  // of each hinge, how long it is against each of its panels
};

}  // namespace tactics
