// SPDX-License-Identifier: Apache-2.0
// Underscores, as names in programs have them: "x_max", "_size".
#pragma once

#include <cstddef>
#include <vector>

#include "tactics/lettering/ink.h"

namespace tactics {

/// Pixels that an underscore may reach below a letter beside it, as soft ink does.
inline constexpr int kSoftInk = 1;

/// Whether a bar fills the gap between two letters at their foot or below it, as one underscore or two do. Boxes are as their
/// reader sees them.
bool is_underscore_between(const PixelBox& bar, const PixelBox& a, const PixelBox& b);

/// The underscores among boxes.
class Underscores {
public:
    explicit Underscores(const std::vector<PixelBox>& boxes);

    /// Those of a line, by their numbers: beside its letters, below their foot, and no dash of a line that goes on. `letters` are
    /// numbers of boxes.
    std::vector<std::size_t> of(const std::vector<std::size_t>& letters, int foot, int letter_height) const;

private:
    bool goes_on(const PixelBox& bar, bool to_left) const;

    const std::vector<PixelBox>& boxes_;
    std::vector<std::size_t> bars_;  // what is flat
};

}  // namespace tactics
