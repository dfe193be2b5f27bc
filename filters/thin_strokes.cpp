// SPDX-License-Identifier: Apache-2.0
#include "filters/thin_strokes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "filters/opencv.h"

namespace tactics {

namespace {

constexpr int kDarker = 50;  // grey levels: ink than what is beside it; a setting

constexpr std::size_t kMostStrokes = 2000;

// Of an odd size, as others would shift what they close.
cv::Mat rectangle(int width, int height) { return cv::getStructuringElement(cv::MORPH_RECT, cv::Size(width | 1, height | 1)); }

// All upright ones. Level lines that they cross do not part them.
std::vector<ThinStroke> thin_uprights(const cv::Mat& grey, int widest, int shortest) {
    cv::Mat closed, labels, boxes, middles;
    cv::morphologyEx(grey, closed, cv::MORPH_CLOSE, rectangle(widest + 1, 1));
    cv::Mat ink = closed - grey > kDarker;
    cv::morphologyEx(ink, ink, cv::MORPH_CLOSE, rectangle(1, widest + 3));
    cv::morphologyEx(ink, ink, cv::MORPH_OPEN, rectangle(1, shortest));
    const int count = cv::connectedComponentsWithStats(ink, labels, boxes, middles);
    std::vector<ThinStroke> strokes;
    for (int i = 1; i < count; ++i) {
        const int left = boxes.at<int>(i, cv::CC_STAT_LEFT), width = boxes.at<int>(i, cv::CC_STAT_WIDTH),
                  top = boxes.at<int>(i, cv::CC_STAT_TOP), height = boxes.at<int>(i, cv::CC_STAT_HEIGHT);
        if (width <= widest) strokes.push_back({top, top + height, left, left + width});
    }
    return strokes;
}

}  // namespace

ThinStrokes thin_strokes_in(const Image& picture, double shortest_mm) {
    const double mm = picture.mm_per_pixel;
    const int shortest = std::max(3, static_cast<int>(std::lround(shortest_mm / mm))),
              widest = std::max(2, static_cast<int>(std::lround(kWidestStroke / mm)));
    ThinStrokes strokes{to_grey(picture), make_image(picture.height, picture.width, 1, mm, 0), {}, {}};
    cv::transpose(view_of(std::as_const(strokes.grey)), view_of(strokes.turned));
    auto upright = thin_uprights(view_of(strokes.grey), widest, shortest),
         level = thin_uprights(view_of(strokes.turned), widest, shortest);
    if (std::max(upright.size(), level.size()) > kMostStrokes) return strokes;
    strokes.upright = std::move(upright);
    strokes.level = std::move(level);
    return strokes;
}

void take_out(Image& picture, const ThinStroke& stroke, bool level) {
    const int along = level ? picture.width : picture.height, across = level ? picture.height : picture.width;
    const int low = std::max(0, stroke.low - kStrokeHalo), high = std::min(across, stroke.high + kStrokeHalo);
    const auto pixel = [&](int at, int beside) {
        return level ? picture.row(beside) + at * picture.channels : picture.row(at) + beside * picture.channels;
    };
    for (int at = std::max(0, stroke.begin - kStrokeHalo); at < std::min(along, stroke.end + kStrokeHalo); ++at)
        for (int beside = low; beside < high; ++beside) {
            const int from = 2 * beside < low + high ? std::max(0, low - 1) : std::min(across - 1, high);
            std::copy_n(pixel(at, from), picture.channels, pixel(at, beside));
        }
}

std::array<Point, 2> ends_of(const ThinStroke& line, bool level) {
    const double begin = line.begin, end = line.end, middle = line.middle();
    if (level) return {Point{begin, middle}, Point{end, middle}};
    return {Point{middle, begin}, Point{middle, end}};
}

int grey_at(const Image& grey, int x, int y) {
    return grey.row(std::clamp(y, 0, grey.height - 1))[std::clamp(x, 0, grey.width - 1)];
}

}  // namespace tactics
