// SPDX-License-Identifier: Apache-2.0
#include "filters/dash_pieces.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace tactics {

std::optional<InkedDash> inked_dash(const std::vector<const Run*>& runs, double longest, double widest) {
    double n = 0, sx = 0, sy = 0, sxx = 0, syy = 0, sxy = 0;
    for (const Run* run : runs)
        for (int x = run->begin; x < run->end; ++x) {
            const double px = x + 0.5, py = run->row + 0.5;
            ++n;
            sx += px;
            sy += py;
            sxx += px * px;
            syy += py * py;
            sxy += px * py;
        }
    const double mx = sx / n, my = sy / n, cxx = sxx / n - mx * mx + 1.0 / 12, cyy = syy / n - my * my + 1.0 / 12,
                 cxy = sxy / n - mx * my;
    const double mean = (cxx + cyy) / 2, off = std::hypot((cxx - cyy) / 2, cxy);
    // A bar of length l has a variance of l^2 / 12.
    const double length = std::sqrt(12 * (mean + off)), width = std::sqrt(12 * std::max(0.0, mean - off));
    const bool clear = length > 2 * width && width <= 1.4 * widest;  // no letter, no point
    if (length > longest || (width > widest && !clear)) return std::nullopt;
    const double angle = std::atan2(2 * cxy, cxx - cyy) / 2, half = std::max(0.0, length - width) / 2;
    const Point along{half * std::cos(angle), half * std::sin(angle)};
    return InkedDash{{{mx - along.x, my - along.y}, {mx + along.x, my + along.y}}, width};
}

InkHue hue_of(const Image& picture, const std::vector<const Run*>& runs) {
    InkHue hue{};
    for (const Run* run : runs)
        for (int x = run->begin; x < run->end; ++x)
            for (std::size_t c = 0; c < 3; ++c)
                hue[c] += 255 - picture.row(run->row)[x * picture.channels + (picture.channels == 3 ? static_cast<int>(c) : 0)];
    const double size = std::sqrt(hue[0] * hue[0] + hue[1] * hue[1] + hue[2] * hue[2]);
    for (double& channel : hue) channel = size > 0 ? channel / size : 1 / std::sqrt(3.0);
    return hue;
}

bool have_one_hue(const InkedDash& a, const InkedDash& b) {
    constexpr double kOneHue = 0.93;  // cosine; red and black have 0.82, blue and green 0.5
    return a.hue[0] * b.hue[0] + a.hue[1] * b.hue[1] + a.hue[2] * b.hue[2] >= kOneHue;
}

}  // namespace tactics
