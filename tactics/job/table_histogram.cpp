// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/table_histogram.h"

#include <algorithm>
#include <cmath>

namespace tactics {

int bins_for(std::vector<double>& values) {
    const std::size_t count = values.size();
    const auto at_rank = [&](std::size_t rank) {
        const auto place = values.begin() + static_cast<std::ptrdiff_t>(rank);
        std::nth_element(values.begin(), place, values.end());
        return *place;
    };
    const double lower = at_rank(count / 4), upper = at_rank(std::min(count - 1, count * 3 / 4));
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    const double n = static_cast<double>(count);
    const double width = 2 * (upper - lower) / std::cbrt(n);
    const double bins = width > 0 ? (*high - *low) / width : 1 + std::log2(n);
    return static_cast<int>(std::ceil(std::clamp(bins, 1.0, static_cast<double>(kMostChosenBins))));
}

PlotCurve histogram_of(const std::vector<double>& values, int bins) {
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    double low = *least, high = *most;
    if (low == high) {
        low -= 0.5;
        high += 0.5;
        bins = 1;
    }
    const double width = (high - low) / bins;
    std::vector<std::size_t> counts(static_cast<std::size_t>(bins));
    for (const double value : values) ++counts[std::min(counts.size() - 1, static_cast<std::size_t>((value - low) / width))];
    PlotCurve curve;
    curve.joined = Joining::bars;
    for (std::size_t i = 0; i < counts.size(); ++i)
        curve.points.push_back({low + static_cast<double>(i) * width, static_cast<double>(counts[i])});
    curve.points.push_back({high, 0});
    return curve;
}

}  // namespace tactics
