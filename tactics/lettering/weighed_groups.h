// SPDX-License-Identifier: Apache-2.0
// Values that agree, each with its weight.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace tactics {

/// Means of the groups of values that weigh most, the heaviest first, at most `most` of them. `votes` are values with their
/// weights; those of a group differ by no more than `share` of the smallest and `step` together.
std::vector<double> heaviest_groups(std::vector<std::pair<double, double>> votes, double share, double step, std::size_t most);

}  // namespace tactics
