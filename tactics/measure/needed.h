// SPDX-License-Identifier: Apache-2.0
// No more than needed: the least of something at which a drawing is about as good as at its best.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace tactics {

/// One picture: F at each value of a dial, and the recipe's own value.
struct NeededCurve {
    std::vector<double> f;
    double own = 0;
    double own_f = 0;
    double most = std::numeric_limits<double>::infinity();  ///< a larger value is the same as this
};

/// Within one percent of the best: a difference that nobody would feel.
inline constexpr double kEnough = 0.99;

/// Index of the first value whose F is at least kEnough of the greatest; nothing if no F is above 0.
std::optional<std::size_t> smallest_enough(std::span<const double> f);

/// The value itself, of ascending ones, at most curve.most.
std::optional<double> needed_of(const NeededCurve& curve, std::span<const double> values);

/// The least of the values that is enough for a quarter, half and three quarters of them.
struct Quartiles {
    double low = 0, middle = 0, high = 0;
};
Quartiles quartiles_of(std::vector<double> values);

struct NeededSummary {
    std::size_t pictures = 0;
    std::size_t nothing = 0;     ///< of these, without any F above 0; they have no needed value
    std::size_t more = 0;        ///< of these, where the recipe has more than needed
    std::vector<double> mean_f;  ///< at each value
    double best_f = 0;           ///< mean of the best of each picture
    double own_f = 0;            ///< mean F of the unchanged recipe
    Quartiles needed, own;
};
NeededSummary summary_of(const std::vector<NeededCurve>& curves, std::span<const double> values);

}  // namespace tactics
