// SPDX-License-Identifier: Apache-2.0
// The usual K-means from random starts, kept for comparison with the exact one.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace tactics {

/// Centres, rising, that OpenCV's kmeans finds from the best of `starts` random starts (k-means++, at most 100 rounds each).
/// Never more than there are different samples; samples must be finite. The answer depends on `seed`.
std::vector<double> kmeans_iterative(std::span<const float> samples, int k, int starts, std::uint64_t seed);

}  // namespace tactics
