// SPDX-License-Identifier: Apache-2.0
#include "filters/dashed_whiskers.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <optional>

#include "filters/opencv.h"
#include "tactics/geometry/skeleton.h"

namespace tactics {

namespace {

// In the colour that was at `on`.
void draw_whole(Image& picture, const Image& before, cv::Point on, cv::Point from, cv::Point to, double width) {
    cv::Mat pixels = view_of(picture);
    cv::line(pixels, from, to, colour_near(before, on), std::max(1, static_cast<int>(std::lround(width))));
}

// The longest gap between two dashes.
double gap_of(const DashRow& row) {
    double gap = 0;
    for (std::size_t i = 2; i < row.points.size(); i += 2) gap = std::max(gap, distance(row.points[i - 1], row.points[i]));
    return gap;
}

// Back from an end of a skeleton to where it forks, or so many steps.
cv::Point back_from(const Skeleton& middles, cv::Point end, int steps) {
    cv::Point at = end, before(-1, -1);
    for (int i = 0; i < steps; ++i) {
        cv::Point next(-1, -1);
        int ways = 0;
        for (const PixelStep& step : kSteps) {
            const cv::Point p(at.x + step.x, at.y + step.y);
            if (!middles.map.ink(p.x, p.y) || p == before) continue;
            next = p;
            ++ways;
        }
        if (ways != 1) break;
        before = at;
        at = next;
    }
    return at;
}

// Ways a line may end: up, down, left and right; and that of the end of another which faces it.
constexpr struct {
    char end, facing;
    int x, y;
} kWays[] = {{'u', 'd', 0, -1}, {'d', 'u', 0, 1}, {'l', 'r', -1, 0}, {'r', 'l', 1, 0}};

// At each pixel, which way a line of ink ends there, if that is level or upright.
cv::Mat ends_of(const Image& ink) {
    constexpr int kBack = 5;  // steps
    const Skeleton middles = thin(ink_of(ink));
    cv::Mat ends = cv::Mat::zeros(ink.height, ink.width, CV_8U);
    for (const std::uint32_t pixel : middles.pixels) {
        if (std::popcount(neighbours_of(middles.map.bytes.data() + pixel, middles.map.stride)) != 1) continue;
        const cv::Point at(middles.x_of(pixel), middles.y_of(pixel)), way = at - back_from(middles, at, kBack);
        if (way.x == 0 && way.y != 0) ends.at<std::uint8_t>(at) = way.y < 0 ? 'u' : 'd';
        if (way.y == 0 && way.x != 0) ends.at<std::uint8_t>(at) = way.x < 0 ? 'l' : 'r';
    }
    return ends;
}

// Straight ahead, or a pixel aside, the end of another line that points back.
std::optional<cv::Point> facing(const cv::Mat& ends, cv::Point from, int most) {
    const auto* way =
        std::find_if(std::begin(kWays), std::end(kWays), [&](const auto& one) { return one.end == ends.at<std::uint8_t>(from); });
    if (way == std::end(kWays)) return std::nullopt;
    for (int step = 1; step <= most; ++step)
        for (const int aside : {0, 1, -1}) {
            const cv::Point to(from.x + step * way->x + aside * way->y, from.y + step * way->y + aside * way->x);
            if (cv::Rect(0, 0, ends.cols, ends.rows).contains(to) && ends.at<std::uint8_t>(to) == way->facing) return to;
        }
    return std::nullopt;
}

}  // namespace

std::vector<bool> whiskers_among(const std::vector<DashRow>& rows, double longest) {
    const auto may_be = [](const DashRow& row) { return row.met == 2 && is_level(row) && is_straight(row); };
    const auto is_short = [&](const DashRow& row) { return distance(row.points.front(), row.points.back()) <= longest; };
    std::vector<bool> whiskers;
    for (const DashRow& row : rows)
        whiskers.push_back(row.leads || (may_be(row) && std::any_of(rows.begin(), rows.end(), [&](const DashRow& other) {
                                             return may_be(other) && is_short(other) && is_level(other) == is_level(row) &&
                                                    other.kind == row.kind;
                                         })));
    return whiskers;
}

void join_whiskers(Image& picture, const Image& before, const Image& ink, const std::vector<DashRow>& whiskers) {
    double gap = 0, width = 1;
    for (const DashRow& row : whiskers) {
        draw_whole(picture, before,
                   pixel_of({0.2 * row.points[0].x + 0.8 * row.points[1].x, 0.2 * row.points[0].y + 0.8 * row.points[1].y}),
                   pixel_of(row.points.front()), pixel_of(row.points.back()), row.width);
        gap = std::max(gap, gap_of(row));
        width = std::max(width, row.width);
    }
    if (gap <= 0) return;
    constexpr double kLonger = 1.25;  // a gap may be a little longer where a dash is cut short
    const cv::Mat ends = ends_of(ink);
    for (int y = 0; y < ends.rows; ++y)
        for (int x = 0; x < ends.cols; ++x)
            if (ends.at<std::uint8_t>(y, x) == 'd' || ends.at<std::uint8_t>(y, x) == 'r')
                if (const auto to = facing(ends, {x, y}, static_cast<int>(kLonger * gap)))
                    draw_whole(picture, before, {x, y}, {x, y}, *to, width);
}

}  // namespace tactics
