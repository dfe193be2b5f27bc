// SPDX-License-Identifier: Apache-2.0
#include "filters/pale_grid.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "filters/opencv.h"

namespace tactics {

namespace {

// Settings.
constexpr int kSeenDepth = 16;       // levels off the ground
constexpr double kPaler = 0.55;      // of the deepest ink's depth
constexpr int kAroundGrid = 5;       // pixels across, in which there is no darker ink: its border is as pale as a grid
constexpr double kLeastInked = 0.1;  // of the picture: a dotted line is hardly more than a fifth of its length
constexpr double kAsInked = 0.5;     // of the line with most ink
constexpr double kClosestLines = 8;  // mm on the page: closer ones are a hatch
constexpr int kWidestGridLine = 4;   // pixels

// How deep the deepest hundredth of what is not the ground is.
int deepest_of(const cv::Mat& depth) {
    std::array<int, 256> counts{};
    int all = 0;
    for (int y = 0; y < depth.rows; ++y)
        for (int x = 0; x < depth.cols; ++x)
            if (const int level = depth.at<std::uint8_t>(y, x); level >= kSeenDepth)
                ++counts[static_cast<std::size_t>(level)], ++all;
    int level = 255;
    for (int deeper = counts[255]; level > 0 && deeper < all / 100;) deeper += counts[static_cast<std::size_t>(--level)];
    return level;
}

// At least three places, whose distances are multiples of the least one: one may be missing where something covers it.
bool are_evenly_apart(std::vector<double> places, double closest) {
    constexpr std::size_t kFewest = 3;
    constexpr double kUnevenly = 0.12, kOfPixels = 1.5;
    if (places.size() < kFewest) return false;
    std::sort(places.begin(), places.end());
    double least = places.back() - places.front();
    for (std::size_t i = 1; i < places.size(); ++i) least = std::min(least, places[i] - places[i - 1]);
    if (least < closest) return false;
    for (std::size_t i = 1; i < places.size(); ++i) {
        const double steps = std::round((places[i] - places[i - 1]) / least);
        if (std::abs(places[i] - places[i - 1] - steps * least) > std::max(kOfPixels, kUnevenly * least) * steps) return false;
    }
    return true;
}

// Columns of a line: the first, and behind the last.
using Columns = std::pair<int, int>;

// How many pixels of each column are pale, or of each row.
std::vector<int> counts_along(const cv::Mat& pale, bool columns) {
    cv::Mat sums;
    cv::reduce(pale, sums, columns ? 0 : 1, cv::REDUCE_SUM, CV_32S);
    std::vector<int> counts(sums.begin<int>(), sums.end<int>());
    for (int& count : counts) count /= 255;
    return counts;
}

// Where so many of the pixels of a column are pale; none if there are surfaces or noise, too.
std::vector<Columns> upright_lines(const std::vector<int>& counts, int rows, double mm) {
    const int most = *std::max_element(counts.begin(), counts.end());
    if (most < kLeastInked * rows) return {};
    std::vector<Columns> lines;
    for (int x = 0; x < static_cast<int>(counts.size()); ++x) {
        if (counts[static_cast<std::size_t>(x)] < kAsInked * most) continue;
        if (lines.empty() || lines.back().second < x) lines.emplace_back(x, x);
        lines.back().second = x + 1;
        if (lines.back().second - lines.back().first > kWidestGridLine) return {};
    }
    std::vector<double> places;
    for (const auto& [first, last] : lines) places.push_back((first + last) / 2.0);
    return are_evenly_apart(places, kClosestLines / mm) ? lines : std::vector<Columns>{};
}

void widen_columns(std::vector<Columns>& lines, int columns) {
    for (auto& [first, last] : lines) {
        first = std::max(0, first - 1);
        last = std::min(columns, last + 1);
    }
}

}  // namespace

std::size_t leave_out_pale_grid(Image& picture, const Image& ink, const std::array<int, 3>& ground) {
    if (picture.width < kAroundGrid || picture.height < kAroundGrid || !(picture.mm_per_pixel > 0)) return 0;
    const cv::Mat depth = 255 - view_of(ink);
    const double dark = kPaler * deepest_of(depth);
    cv::Mat deepest, beside;
    cv::dilate(depth, deepest, cv::getStructuringElement(cv::MORPH_RECT, cv::Size(kAroundGrid, kAroundGrid)));
    cv::dilate(depth, beside, cv::getStructuringElement(cv::MORPH_RECT, cv::Size(3, 3)));
    const cv::Mat pale = (depth >= kSeenDepth) & (deepest < dark), free = beside < dark;
    std::vector<Columns> upright = upright_lines(counts_along(pale, true), pale.rows, picture.mm_per_pixel),
                         level = upright_lines(counts_along(pale, false), pale.cols, picture.mm_per_pixel);
    widen_columns(upright, pale.cols);
    widen_columns(level, pale.rows);
    cv::Mat grid = cv::Mat::zeros(pale.size(), CV_8U);
    for (const auto& [first, last] : upright) grid.colRange(first, last).setTo(255);
    for (const auto& [first, last] : level) grid.rowRange(first, last).setTo(255);
    if (!upright.empty() || !level.empty()) view_of(picture).setTo(cv::Scalar(ground[0], ground[1], ground[2]), grid & free);
    return upright.size() + level.size();
}

}  // namespace tactics
