// SPDX-License-Identifier: Apache-2.0
#include "tactics/measure/needed.h"

#include <algorithm>
#include <cmath>

namespace tactics {

std::optional<std::size_t> smallest_enough(std::span<const double> f) {
    if (f.empty()) return std::nullopt;
    const double best = *std::max_element(f.begin(), f.end());
    if (!(best > 0)) return std::nullopt;
    const auto first = std::find_if(f.begin(), f.end(), [&](double value) { return value >= kEnough * best; });
    return static_cast<std::size_t>(first - f.begin());
}

std::optional<double> needed_of(const NeededCurve& curve, std::span<const double> values) {
    const auto index = smallest_enough(curve.f);
    if (!index) return std::nullopt;
    return std::min(values[*index], curve.most);
}

Quartiles quartiles_of(std::vector<double> values) {
    if (values.empty()) return {};
    std::sort(values.begin(), values.end());
    const auto at = [&](double share) {
        return values[static_cast<std::size_t>(std::ceil(share * static_cast<double>(values.size()))) - 1];
    };
    return {at(0.25), at(0.5), at(0.75)};
}

NeededSummary summary_of(const std::vector<NeededCurve>& curves, std::span<const double> values) {
    NeededSummary summary;
    summary.pictures = curves.size();
    summary.mean_f.assign(values.size(), 0.0);
    if (curves.empty()) return summary;
    std::vector<double> needed, own;
    for (const NeededCurve& curve : curves) {
        for (std::size_t i = 0; i < values.size(); ++i) summary.mean_f[i] += curve.f[i];
        summary.best_f += *std::max_element(curve.f.begin(), curve.f.end());
        summary.own_f += curve.own_f;
        own.push_back(curve.own);
        const auto least = needed_of(curve, values);
        if (!least) {
            ++summary.nothing;
            continue;
        }
        needed.push_back(*least);
        if (curve.own > *least) ++summary.more;
    }
    const auto count = static_cast<double>(curves.size());
    for (double& f : summary.mean_f) f /= count;
    summary.best_f /= count;
    summary.own_f /= count;
    summary.needed = quartiles_of(std::move(needed));
    summary.own = quartiles_of(std::move(own));
    return summary;
}

}  // namespace tactics
