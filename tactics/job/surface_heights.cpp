// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/surface_heights.h"

#include <algorithm>
#include <cmath>

#include "tactics/error.h"
#include "tactics/relief/found_heights.h"
#include "tactics/units.h"

namespace tactics {

namespace {

constexpr double kPitch = 0.5;       // mm: a fingertip resolves about 1 (25 dpi, TACTILE)
constexpr double kMostUneven = 4.0;  // how much wider than deep, or deeper than wide

struct Between {
    std::size_t low = 0;
    double share = 0;  // of the way to the next one
};

Between between(const std::vector<double>& samples, double place) {
    const auto above = std::upper_bound(samples.begin() + 1, samples.end() - 1, place);
    const auto low = static_cast<std::size_t>(above - samples.begin()) - 1;
    return {low, std::clamp((place - samples[low]) / (samples[low + 1] - samples[low]), 0.0, 1.0)};
}

double height_at(const PlotSurface& surface, const Between& x, const Between& y) {
    const auto mixed = [](double a, double b, double share) { return share == 0 ? a : share == 1 ? b : a + share * (b - a); };
    return mixed(mixed(surface.at(x.low, y.low), surface.at(x.low + 1, y.low), x.share),
                 mixed(surface.at(x.low, y.low + 1), surface.at(x.low + 1, y.low + 1), x.share), y.share);
}

}  // namespace

HeightFile surface_heights(const PlotSurface& surface, const HeightWish& wish) {
    const double low = wish.low.value_or(0), high = wish.high.value_or(low + kPictureHeight);
    if (!(high > low)) throw Error(Fault::usage, spelled("high"), phrase("it must be over {0} mm", to_text(low)));
    double least = INFINITY, most = -INFINITY;
    std::size_t unknown = 0;
    for (const double z : surface.z) {
        if (std::isnan(z)) {
            ++unknown;
            continue;
        }
        least = std::min(least, z);
        most = std::max(most, z);
    }
    if (!(least <= most)) throw Error(Fault::failed, "", phrase("nothing is known of the surface's heights"));
    const double wide = surface.x.back() - surface.x.front(), deep = surface.y.back() - surface.y.front();
    const double width = wish.width.value_or(kSurfaceWidth), pitch = wish.pitch.value_or(kPitch);
    const double depth = width * std::clamp(deep / wide, 1 / kMostUneven, kMostUneven);
    const double columns = std::max(2.0, std::round(width / pitch)), rows = std::max(2.0, std::round(depth / pitch));
    if (!(columns * rows <= static_cast<double>(kMostHeights)))
        throw Error(Fault::failed, "", phrase("its heights would be too many samples; take a larger {0}", spelled("pitch")));
    HeightFile file;
    file.map = {static_cast<int>(columns), static_cast<int>(rows), pitch, {}};
    file.map.heights.resize(static_cast<std::size_t>(columns * rows));
    file.low = low;
    file.high = high;
    file.format = "surface";
    const double span = most > least ? most - least : 1;
    for (int row = 0; row < file.map.rows; ++row) {
        const Between y = between(surface.y, surface.y.back() - (row + 0.5) / rows * deep);
        for (int column = 0; column < file.map.columns; ++column) {
            const double z = height_at(surface, between(surface.x, surface.x.front() + (column + 0.5) / columns * wide), y);
            const double share = std::isnan(z) ? 0 : (z - least) / span;
            file.map.at(column, row) = static_cast<float>(low + (wish.invert ? 1 - share : share) * (high - low));
        }
    }
    if (unknown > 0)
        file.notes.push_back(
            phrase("{0} of its heights are not known, and are as low as the lowest place", std::to_string(unknown)));
    return file;
}

}  // namespace tactics
