// SPDX-License-Identifier: Apache-2.0
#include "filters/noisy_curves.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "filters/ink_hues.h"
#include "filters/opencv.h"
#include "filters/straight_lines.h"
#include "tactics/geometry/ink_columns.h"

namespace tactics {

namespace {

constexpr double kLeastCurve = 40;     // mm; less is a sample of a legend
constexpr double kBreak = 3;           // mm of ground in a curve
constexpr double kBehind = 8;          // mm of a curve that others may cover
constexpr double kOneValue = 0.6;      // of the height of a column that its ink fills
constexpr double kMostColumns = 0.85;  // that have one value
constexpr double kSpecks = 0.03;       // of the ink that may stand alone: more is a cloud of points
constexpr double kMostOthers = 0.15;   // of the place that it takes, in other colours: more is a picture
constexpr double kFringe = 0.7;        // of a piece that is near a curve: a mixture of its colour with what it crosses
constexpr double kMostLost = 0.3;      // of the variance of a curve, which its course does not show; a setting
constexpr double kOneSide = 0.4;       // of that, which is off on the same side a millimetre on; a setting

// With what touches it above and below: one line along another hides a part of it here and there.
std::vector<InkColumn> widened(std::vector<InkColumn> columns, const cv::Mat& others, double most) {
    for (InkColumn& column : columns) {
        const int reach = static_cast<int>(most);
        for (int k = 0; k < reach && column.top > 0 && others.at<std::uint8_t>(column.top - 1, column.x) != 0; ++k) --column.top;
        for (int k = 0; k < reach && column.bottom + 1 < others.rows && others.at<std::uint8_t>(column.bottom + 1, column.x) != 0;
             ++k)
            ++column.bottom;
    }
    return columns;
}

std::vector<InkColumn> columns_of(const cv::Mat& mask, const cv::Rect& box) {
    std::vector<InkColumn> columns;
    for (int x = box.x; x < box.x + box.width; ++x) {
        InkColumn column{x, -1, -1, 0};
        for (int y = box.y; y < box.y + box.height; ++y)
            if (mask.at<std::uint8_t>(y, x) != 0) {
                if (column.ink++ == 0) column.top = y;
                column.bottom = y;
            }
        if (column.ink > 0) columns.push_back(column);
    }
    return columns;
}

cv::Mat long_ones(const cv::Mat& ink, double least) {
    cv::Mat labels, stats, middles, found = cv::Mat::zeros(ink.size(), CV_8U);
    const int count = cv::connectedComponentsWithStats(ink, labels, stats, middles, 8, CV_32S);
    std::vector<bool> is_long(static_cast<std::size_t>(count), false);
    for (int i = 1; i < count; ++i)
        is_long[static_cast<std::size_t>(i)] =
            std::max(stats.at<int>(i, cv::CC_STAT_WIDTH), stats.at<int>(i, cv::CC_STAT_HEIGHT)) > least;
    for (int y = 0; y < ink.rows; ++y)
        for (int x = 0; x < ink.cols; ++x)
            if (is_long[static_cast<std::size_t>(labels.at<int>(y, x))]) found.at<std::uint8_t>(y, x) = 255;
    return found;
}

// Pixels of specks that touch no other line: points of a cloud, letters.
double share_alone(const cv::Mat& own, const cv::Mat& others, double mm) {
    cv::Mat labels, stats, middles, near;
    const int count = cv::connectedComponentsWithStats(own, labels, stats, middles, 8, CV_32S);
    cv::dilate(long_ones(others, kLeastCurve / 2 / mm), near, cv::getStructuringElement(cv::MORPH_RECT, cv::Size(5, 5)));
    std::vector<bool> touches(static_cast<std::size_t>(count), false);
    for (int y = 0; y < labels.rows; ++y)
        for (int x = 0; x < labels.cols; ++x)
            if (near.at<std::uint8_t>(y, x) != 0) touches[static_cast<std::size_t>(labels.at<int>(y, x))] = true;
    double alone = 0, all = 0;
    for (int i = 1; i < count; ++i) {
        const int size = stats.at<int>(i, cv::CC_STAT_AREA);
        all += size;
        const int extent = std::max(stats.at<int>(i, cv::CC_STAT_WIDTH), stats.at<int>(i, cv::CC_STAT_HEIGHT));
        if (!touches[static_cast<std::size_t>(i)] && extent * mm < kLeastCurve / 2) alone += size;
    }
    return all > 0 ? alone / all : 1;
}

void add_runs(const cv::Mat& mask, std::vector<Run>& runs) {
    for (int y = 0; y < mask.rows; ++y)
        for (int x = 0; x < mask.cols; ++x)
            if (mask.at<std::uint8_t>(y, x) != 0) {
                const bool goes_on = !runs.empty() && runs.back().row == y && runs.back().end == x;
                if (goes_on)
                    ++runs.back().end;
                else
                    runs.push_back({y, x, x + 1, 0});
            }
}

// What is left of the ink beside the curves: where they cross others or their border is of no one colour.
cv::Mat fringes(const cv::Mat& ink, const cv::Mat& taken) {
    cv::Mat labels, stats, middles, near;
    const cv::Mat rest = ink & ~taken;
    const int count = cv::connectedComponentsWithStats(rest, labels, stats, middles, 8, CV_32S);
    cv::dilate(taken, near, cv::getStructuringElement(cv::MORPH_RECT, cv::Size(5, 5)));
    std::vector<int> beside(static_cast<std::size_t>(count), 0);
    for (int y = 0; y < labels.rows; ++y)
        for (int x = 0; x < labels.cols; ++x)
            if (near.at<std::uint8_t>(y, x) != 0) ++beside[static_cast<std::size_t>(labels.at<int>(y, x))];
    cv::Mat found = cv::Mat::zeros(ink.size(), CV_8U);
    for (int y = 0; y < labels.rows; ++y)
        for (int x = 0; x < labels.cols; ++x)
            if (const int i = labels.at<int>(y, x);
                i > 0 && beside[static_cast<std::size_t>(i)] > kFringe * stats.at<int>(i, cv::CC_STAT_AREA))
                found.at<std::uint8_t>(y, x) = 255;
    return found;
}

// Waves that are drawn through every other one of them are false: then much of the curve is off its course, and a millimetre on
// it is off on the same side, as noise is not.
bool loses_waves(const std::vector<InkColumn>& columns, const std::vector<Point>& course, double mm) {
    const std::vector<double> heights = heights_along(course, columns);
    std::vector<double> off;  // of the middle of each column
    for (std::size_t i = 0; i < columns.size(); ++i) off.push_back(columns[i].middle() - heights[i]);
    const auto apart = static_cast<std::size_t>(std::max(1.0, std::round(1 / mm)));
    if (off.size() <= 2 * apart) return false;
    double sum = 0, squares = 0, lost = 0, alike = 0;
    for (std::size_t i = 0; i < off.size(); ++i) {
        const double y = columns[i].middle();
        sum += y;
        squares += y * y;
        lost += off[i] * off[i];
        if (i >= apart) alike += off[i] * off[i - apart];
    }
    const double count = static_cast<double>(off.size()), variance = squares - sum * sum / count;
    return lost > kMostLost * variance && alike > kOneSide * lost;
}

std::optional<NoisyCurve> curve_in(const cv::Mat& own, const cv::Mat& others, const cv::Mat& hued, const cv::Rect& box,
                                   double mm) {
    const std::vector<InkColumn> columns = columns_of(own, box);
    if (columns.size() < 8 || static_cast<double>(columns.size()) < kMostColumns * box.width) return std::nullopt;
    const auto one = std::count_if(columns.begin(), columns.end(), [&](const InkColumn& column) {
        int hidden = 0;
        for (int y = column.top; y <= column.bottom; ++y)
            hidden += own.at<std::uint8_t>(y, column.x) == 0 && others.at<std::uint8_t>(y, column.x) != 0 ? 1 : 0;
        return column.ink + hidden >= kOneValue * (column.bottom - column.top + 1);
    });
    if (static_cast<double>(one) < kMostColumns * static_cast<double>(columns.size())) return std::nullopt;
    if (cv::countNonZero(hued(box)) > kMostOthers * box.area()) return std::nullopt;
    if (!is_noise(columns, mm) || !is_noise(widened(columns, others, kBreak / mm), mm)) return std::nullopt;
    if (share_alone(own(box), others(box), mm) > kSpecks) return std::nullopt;
    NoisyCurve curve{followable(columns, mm), {}, {}};
    if (loses_waves(columns, curve.course, mm)) return std::nullopt;
    curve.spikes = spikes_of(columns, curve.course, mm);
    add_runs(own, curve.ink);
    return curve;
}

}  // namespace

std::vector<NoisyCurve> noisy_curves_in(const Image& picture) {
    const double mm = picture.mm_per_pixel;
    if (picture.width * mm < kLeastCurve) return {};
    const InkHues hues = ink_hues_of(picture);
    const cv::Mat labels = view_of(hues.labels);
    const auto square = [mm](double length) {
        const int side = 2 * static_cast<int>(std::ceil(length / 2 / mm)) + 1;
        return cv::getStructuringElement(cv::MORPH_RECT, cv::Size(side, side));
    };
    std::vector<NoisyCurve> curves;
    cv::Mat taken = cv::Mat::zeros(labels.size(), CV_8U);
    for (std::size_t hue = 1; hue <= hues.count; ++hue) {
        cv::Mat own = labels == static_cast<double>(hue), joined, behind, pieces;
        const cv::Mat others = (labels != 0) & ~own, hued = others & (labels <= static_cast<double>(hues.count));
        take_straight_lines({own.data, own.total()}, own.cols);
        cv::morphologyEx(own, joined, cv::MORPH_CLOSE, square(kBreak));
        cv::dilate(own, behind, square(kBehind));
        joined |= behind & others;
        const int count = cv::connectedComponents(joined, pieces, 8, CV_32S);
        pieces.setTo(0, ~own);
        std::vector<cv::Rect> boxes(static_cast<std::size_t>(count));
        for (int y = 0; y < pieces.rows; ++y)
            for (int x = 0; x < pieces.cols; ++x)
                if (const int i = pieces.at<int>(y, x); i > 0) boxes[static_cast<std::size_t>(i)] |= cv::Rect(x, y, 1, 1);
        for (int i = 1; i < count; ++i) {
            const cv::Rect box = boxes[static_cast<std::size_t>(i)];
            if (box.width * mm < kLeastCurve) continue;
            const cv::Mat part = pieces == static_cast<double>(i);
            auto curve = curve_in(part, others, hued, box, mm);
            if (!curve) continue;
            taken |= part;
            curves.push_back(std::move(*curve));
        }
    }
    if (!curves.empty()) add_runs(fringes(labels != 0, taken), curves.back().ink);
    return curves;
}

}  // namespace tactics
