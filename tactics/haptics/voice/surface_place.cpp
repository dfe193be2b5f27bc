// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/voice/surface_place.h"

#include <algorithm>
#include <optional>

namespace tactics {

namespace {

struct Between {
    std::size_t first;  // the sample before
    double share, apart;
};
std::optional<Between> between(const std::vector<double>& samples, double at) noexcept {
    if (samples.size() < 2 || !(at >= samples.front() && at <= samples.back())) return std::nullopt;
    const auto next = std::upper_bound(samples.begin() + 1, samples.end() - 1, at);
    const double before = *(next - 1), apart = *next - before;
    if (!(apart > 0)) return std::nullopt;
    return Between{static_cast<std::size_t>(next - samples.begin()) - 1, (at - before) / apart, apart};
}

}  // namespace

SurfacePlace place_on(const PlotSurface& surface, double x, double y) noexcept {
    const auto column = between(surface.x, x), row = between(surface.y, y);
    if (!column || !row) return {};
    const double a = surface.at(column->first, row->first), b = surface.at(column->first + 1, row->first),
                 c = surface.at(column->first, row->first + 1), d = surface.at(column->first + 1, row->first + 1);
    const double low = a + column->share * (b - a), high = c + column->share * (d - c);
    const double along = (b - a) + row->share * ((d - c) - (b - a));
    return {low + row->share * (high - low), along / column->apart, (high - low) / row->apart};
}

}  // namespace tactics
