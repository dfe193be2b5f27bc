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

// Lines alone, as strong as they are darker than what is around them in any channel: between a bar and the ground a line may be
// dark in one only.
EdgeMap thin_lines_of(const Image& picture, double widest) {
    EdgeMap lines{picture.width, picture.height, picture.mm_per_pixel, false, {}, {}, {}};
    lines.strength.resize(static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height));
    // What is gone when all that is narrower than the disc is filled with its surroundings.
    cv::Mat hat = cv::Mat::zeros(picture.height, picture.width, CV_8U), of_one;
    for (const Image& ink : inks_on_white(picture)) {
        cv::morphologyEx(view_of(ink), of_one, cv::MORPH_BLACKHAT, disc(widest));
        hat = cv::max(hat, of_one);
    }
    cv::Mat strengths = view_of(lines);
    hat.convertTo(strengths, CV_32F);
    lines = keep_connected(std::move(lines), kFadesTo, kLine);
    // Nor does a disc reach into the corners of a surface.
    const Components pieces =
        find_components(lines.width, lines.height, Joined::by_corners, [&](std::size_t i) { return lines.strength[i] > 0; });
    const auto extents = pieces.extents();
    for (const Run& run : pieces.runs)
        if (static_cast<double>(extents[run.component]) < kLonger * widest)
            std::fill_n(lines.strength.begin() + static_cast<std::ptrdiff_t>(pixel_index(lines, run.begin, run.row)),
                        run.length(), 0.0f);
    return lines;
}

// Whether an edge that is kept goes on into what is near lines.
bool goes_on_near(const EdgeMap& edges, const cv::Mat& near, int x, int y) {
    for (int v = std::max(0, y - 1); v <= std::min(edges.height - 1, y + 1); ++v)
        for (int u = std::max(0, x - 1); u <= std::min(edges.width - 1, x + 1); ++u)
            if (near.at<std::uint8_t>(v, u) != 0 && edges.strength[pixel_index(edges, u, v)] > 0) return true;
    return false;
}

// Where edges of things, and no mere specks, run into what is near lines: the side of a bar that stands on an axis.
std::vector<cv::Point> edges_cut_off(const EdgeMap& edges, const cv::Mat& near, double shortest) {
    cv::Mat kept;
    view_of(edges).copyTo(kept, near == 0);
    const Components pieces =
        find_components(edges.width, edges.height, Joined::by_corners, [&](std::size_t i) { return kept.ptr<float>()[i] > 0; });
    const auto extents = pieces.extents();
    std::vector<cv::Point> ends;
    for (const Run& run : pieces.runs)
        for (int x = run.begin; x < run.end && static_cast<double>(extents[run.component]) >= shortest; ++x)
            if (goes_on_near(edges, near, x, run.row)) ends.emplace_back(x, run.row);
    return ends;
}

// The edge goes on to the middle of the line that it met, if it ran towards it and not beside it.
void lead_to_line(EdgeMap& edges, const InkMap& middles, cv::Point end, double reach) {
    constexpr double kBeside = 0.7;  // of the way there that is across the edge
    const int r = static_cast<int>(std::ceil(reach));
    double least = reach;
    cv::Point to = end;
    for (int y = std::max(0, end.y - r); y <= std::min(edges.height - 1, end.y + r); ++y)
        for (int x = std::max(0, end.x - r); x <= std::min(edges.width - 1, end.x + r); ++x) {
            const double away = std::hypot(x - end.x, y - end.y);
            if (away >= least || !middles.ink(x, y)) continue;
            least = away;
            to = {x, y};
        }
    if (to == end) return;
    const float normal = edges.normal[pixel_index(edges, end.x, end.y)];
    const cv::Point2d way((to.x - end.x) / least, (to.y - end.y) / least);
    if (std::abs(way.x * std::cos(normal) + way.y * std::sin(normal)) > kBeside) return;
    cv::Mat strength = view_of(edges);
    cv::line(strength, end, to, cv::Scalar(static_cast<double>(strength.at<float>(end))));
}

}  // namespace

void add_thin_lines(EdgeMap& edges, const Image& picture, double widest, double beside) {
    if (widest < 1 || std::max(edges.width, edges.height) < 2 * widest) return;
    const EdgeMap lines = thin_lines_of(picture, widest);
    const cv::Mat mask = view_of(lines) > 0;
    if (cv::countNonZero(mask) == 0) return;
    cv::Mat near;
    cv::dilate(mask, near, disc(2 * beside));
    const std::vector<cv::Point> cut_off = edges_cut_off(edges, near, kLonger * widest);
    view_of(edges).setTo(0, near);
    const Skeleton middles = thin(ink_of(lines));
    for (const std::uint32_t pixel : middles.pixels) {
        const std::size_t i = pixel_index(edges, middles.x_of(pixel), middles.y_of(pixel));
        edges.strength[i] = lines.strength[i];
    }
    for (const cv::Point& end : cut_off) lead_to_line(edges, middles.map, end, 2 * beside + widest + 1);
}

}  // namespace tactics
