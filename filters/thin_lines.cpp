// SPDX-License-Identifier: Apache-2.0
#include "filters/thin_lines.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

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

std::size_t edge_index(const EdgeMap& map, int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(map.width) + static_cast<std::size_t>(x);
}

// Where edges of things, and no mere specks, run into what is near lines: the side of a bar that stands on an axis.
std::vector<cv::Point> ends_near_lines(const EdgeMap& edges, const cv::Mat& near, double shortest) {
    const Components pieces = find_components(edges.width, edges.height, Joined::by_corners,
                                              [&](std::size_t i) { return edges.strength[i] > 0 && near.data[i] == 0; });
    const auto extents = pieces.extents();
    std::vector<cv::Point> ends;
    for (const Run& run : pieces.runs) {
        if (static_cast<double>(extents[run.component]) < shortest) continue;
        for (int x = run.begin; x < run.end; ++x) {
            bool goes_on = false;
            for (int v = std::max(0, run.row - 1); v <= std::min(edges.height - 1, run.row + 1); ++v)
                for (int u = std::max(0, x - 1); u <= std::min(edges.width - 1, x + 1); ++u)
                    goes_on = goes_on || (near.at<std::uint8_t>(v, u) != 0 && edges.strength[edge_index(edges, u, v)] > 0);
            if (goes_on) ends.emplace_back(x, run.row);
        }
    }
    return ends;
}

// The edge goes on to the middle of the line that it met, if it ran towards it and not beside it.
void lead_to_line(EdgeMap& edges, const cv::Mat& middles, cv::Point end, int reach) {
    constexpr double kBeside = 0.7;  // of the way there that is across the edge
    const float strength = edges.strength[edge_index(edges, end.x, end.y)],
                normal = edges.normal[edge_index(edges, end.x, end.y)];
    double least = reach + 1;
    cv::Point to = end;
    for (int y = std::max(0, end.y - reach); y <= std::min(edges.height - 1, end.y + reach); ++y)
        for (int x = std::max(0, end.x - reach); x <= std::min(edges.width - 1, end.x + reach); ++x) {
            const double away = std::hypot(x - end.x, y - end.y);
            if (away >= least || middles.at<std::uint8_t>(y, x) == 0) continue;
            least = away;
            to = {x, y};
        }
    if (to == end) return;
    const cv::Point2d way((to.x - end.x) / least, (to.y - end.y) / least);
    if (std::abs(way.x * std::cos(normal) + way.y * std::sin(normal)) > kBeside) return;
    const int steps = std::max(std::abs(to.x - end.x), std::abs(to.y - end.y));
    for (int k = 1; k < steps; ++k) {
        float& pixel = edges.strength[edge_index(edges, end.x + static_cast<int>(std::lround(1.0 * k * (to.x - end.x) / steps)),
                                                 end.y + static_cast<int>(std::lround(1.0 * k * (to.y - end.y) / steps)))];
        pixel = std::max(pixel, strength);
    }
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
    const std::vector<cv::Point> ends = ends_near_lines(edges, near, kLonger * widest);
    for (int y = 0; y < edges.height; ++y)
        for (int x = 0; x < edges.width; ++x)
            if (near.at<std::uint8_t>(y, x) != 0)
                edges
                    .strength[static_cast<std::size_t>(y) * static_cast<std::size_t>(edges.width) + static_cast<std::size_t>(x)] =
                    0;
    const Skeleton middles = thin(ink_of(lines));
    cv::Mat middle = cv::Mat::zeros(mask.size(), CV_8U);
    for (const std::uint32_t pixel : middles.pixels) {
        const std::size_t i = edge_index(edges, middles.x_of(pixel), middles.y_of(pixel));
        edges.strength[i] = lines.strength[i];
        middle.data[i] = 255;
    }
    const int reach = static_cast<int>(std::ceil(beside + widest)) + 1;
    for (const cv::Point& end : ends) lead_to_line(edges, middle, end, reach);
}

}  // namespace tactics
