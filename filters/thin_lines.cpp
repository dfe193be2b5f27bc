// SPDX-License-Identifier: Apache-2.0
#include "filters/thin_lines.h"

#include <algorithm>
#include <cmath>

#include "filters/components.h"
#include "filters/darken.h"
#include "filters/edge_map.h"
#include "filters/opencv.h"
#include "tactics/geometry/skeleton.h"

namespace tactics {

namespace {

// Grey levels between a line's middle and what is beside it. Grids of plotting tools (b0b0b0 on white) have 79; axes, even of one
// pixel between two, have more than 100. Settings.
constexpr float kLine = 90, kFadesTo = 45;
constexpr double kLonger = 4;  // times the width: what is shorter is no line

// A disc: a line is as thin in every direction.
cv::Mat disc(double diameter) {
    const int side = 2 * static_cast<int>(std::ceil(diameter / 2)) + 1;
    return cv::getStructuringElement(cv::MORPH_ELLIPSE, cv::Size(side, side));
}

}  // namespace

void add_thin_lines(EdgeMap& edges, const Image& picture, double widest, double beside) {
    if (widest < 1 || std::max(edges.width, edges.height) < 2 * widest) return;
    const Image ink = ink_on_white(picture);
    EdgeMap lines{edges.width, edges.height, edges.mm_per_pixel, false, {}, {}, {}};
    lines.strength.resize(edges.strength.size());
    // What is gone when all that is narrower than the disc is filled with its surroundings.
    cv::Mat hat;
    cv::morphologyEx(view_of(ink), hat, cv::MORPH_BLACKHAT, disc(widest));
    cv::Mat strengths = view_of(lines);
    hat.convertTo(strengths, CV_32F);
    lines = keep_connected(std::move(lines), kFadesTo, kLine);
    // Nor does a disc reach into the corners of a surface.
    const Components pieces =
        find_components(lines.width, lines.height, Joined::by_corners, [&](std::size_t i) { return lines.strength[i] > 0; });
    const auto extents = pieces.extents();
    for (const Run& run : pieces.runs)
        if (static_cast<double>(extents[run.component]) < kLonger * widest)
            std::fill_n(lines.strength.begin() + static_cast<std::ptrdiff_t>(run.row) * lines.width + run.begin, run.length(),
                        0.0f);
    const cv::Mat mask = view_of(static_cast<const EdgeMap&>(lines)) > 0;
    if (cv::countNonZero(mask) == 0) return;
    cv::Mat near;
    cv::dilate(mask, near, disc(2 * beside));
    for (int y = 0; y < edges.height; ++y)
        for (int x = 0; x < edges.width; ++x)
            if (near.at<std::uint8_t>(y, x) != 0)
                edges
                    .strength[static_cast<std::size_t>(y) * static_cast<std::size_t>(edges.width) + static_cast<std::size_t>(x)] =
                    0;
    const Skeleton middles = thin(ink_of(lines));
    for (const std::uint32_t pixel : middles.pixels) {
        const std::size_t i = static_cast<std::size_t>(middles.y_of(pixel)) * static_cast<std::size_t>(edges.width) +
                              static_cast<std::size_t>(middles.x_of(pixel));
        edges.strength[i] = lines.strength[i];
    }
}

}  // namespace tactics
