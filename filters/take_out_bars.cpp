// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "filters/inked_bars.h"
#include "filters/lab.h"
#include "filters/opencv.h"

namespace tactics {

namespace {

// Pixels, levels and shares; settings, all.
constexpr int kBarBorder = 3;  // on both sides of its outline
constexpr int kOtherInk = 60;  // levels that what crosses a bar differs from it by
constexpr int kLongPiece = 8, kLongInHatch = 14;
constexpr int kOverSide = 15,
              kOverMarks = 9;                // a line goes on over a side of a bar, and over the marks of a hatch, within so much
constexpr int kClosest = 3, kFarthest = 40;  // of the marks of a hatch
constexpr double kRepeats = 0.6;             // of the marks are there again

cv::Rect box_of(const InkedBar& bar, int more, const cv::Mat& within) {
    const cv::Point first(static_cast<int>(std::floor(bar.left)) - more, static_cast<int>(std::floor(bar.top)) - more),
        last(static_cast<int>(std::ceil(bar.right)) + more, static_cast<int>(std::ceil(bar.bottom)) + more);
    return cv::Rect(first, last) & cv::Rect(0, 0, within.cols, within.rows);
}

cv::Mat far_from(const Image& picture, const PixelColour& colour) {
    cv::Mat far(picture.height, picture.width, CV_8U, cv::Scalar(0));
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            if (channels_apart(pixel_colour(picture, x, y), colour) > kOtherInk) far.at<std::uint8_t>(y, x) = 255;
    return far;
}

// Pieces of so many pixels at least.
void keep_long(cv::Mat& mask, int least) {
    cv::Mat labels, stats, middles;
    const int count = cv::connectedComponentsWithStats(mask, labels, stats, middles, 8, CV_32S);
    for (int i = 1; i < count; ++i) {
        const cv::Rect box = box_of_piece(stats, i);
        if (std::max(box.width, box.height) < least) mask(box).setTo(0, labels(box) == i);
    }
}

cv::Mat closed_by(const cv::Mat& mask, int across) {
    cv::Mat closed;
    cv::morphologyEx(mask, closed, cv::MORPH_CLOSE, cv::getStructuringElement(cv::MORPH_ELLIPSE, cv::Size(across, across)));
    return closed;
}

// How far to the right the marks repeat, in pixels; 0 where they do not.
int period_of(const cv::Mat& ink) {
    const int all = cv::countNonZero(ink);
    double best = kRepeats, before = 0;
    int period = 0;
    for (int step = kClosest; step <= std::min(kFarthest, ink.cols / 2); ++step) {
        const int wide = ink.cols - step;
        const int again = cv::countNonZero(ink(cv::Rect(0, 0, wide, ink.rows)) & ink(cv::Rect(step, 0, wide, ink.rows)));
        const double share = static_cast<double>(again) * ink.cols / wide / std::max(1, all);
        // The first peak.
        if (period > 0 && share < before) break;
        if (share > best) {
            best = share;
            period = step;
        }
        before = share;
    }
    return period;
}

// Ink that is there again a period to the left and to the right, to within a pixel; beyond an edge is as if it were.
cv::Mat repeated(const cv::Mat& ink, int period) {
    const cv::Mat near = spread(ink, 1);
    cv::Mat again = ink.clone();
    for (const int step : {-period, period}) {
        const int from = std::max(0, step), to = std::min(0, step), wide = ink.cols - std::abs(step);
        if (wide <= 0) continue;
        cv::Mat part = again(cv::Rect(-to, 0, wide, ink.rows));
        part &= near(cv::Rect(from, 0, wide, ink.rows));
    }
    return again;
}

// What of the ink of a hatch is not one of its marks: these come again across and down.
cv::Mat crosses_hatch(const cv::Mat& ink) {
    const cv::Mat turned = ink.t();
    const int across = period_of(ink), down = period_of(turned);
    if (across == 0 || down == 0) return cv::Mat::zeros(ink.size(), CV_8U);
    cv::Mat other = ink & ~(repeated(ink, across) & repeated(turned, down).t());
    other = closed_by(other, std::min(kOverMarks, std::max(across, down) + 1)) & ink;
    keep_long(other, std::max(kLongInHatch, 2 * std::max(across, down)));
    return other;
}

// Not what goes straight from one side of the bar to the other one: that is a line of a grid.
void drop_grid(cv::Mat& own) {
    constexpr int kThin = 5;  // pixels
    constexpr double kWhole = 0.9;
    cv::Mat labels, stats, middles;
    const int count = cv::connectedComponentsWithStats(own, labels, stats, middles, 8, CV_32S);
    for (int i = 1; i < count; ++i) {
        const cv::Rect box = box_of_piece(stats, i);
        if ((box.height <= kThin && box.width >= kWhole * own.cols) || (box.width <= kThin && box.height >= kWhole * own.rows))
            own(box).setTo(0, labels(box) == i);
    }
}

// What crosses a bar: in a colour it has another one, neither that of the ground.
cv::Mat crossing(const Image& picture, const cv::Mat& inked, const InkedBars& found) {
    cv::Mat kept = cv::Mat::zeros(inked.size(), CV_8U);
    for (const InkedBar& bar : found.bars) {
        const BarFill& fill = found.fills[bar.fill];
        const cv::Rect inner = box_of(bar, -kBarBorder, inked);
        if (inner.empty()) continue;
        cv::Mat own = kept(inner);
        if (fill.fill == CellFill::hatch) {
            crosses_hatch(inked(inner)).copyTo(own);
            drop_grid(own);
            continue;
        }
        for (int y = 0; y < inner.height; ++y)
            for (int x = 0; x < inner.width; ++x)
                if (channels_apart(pixel_colour(picture, inner.x + x, inner.y + y), fill.colour) > kOtherInk)
                    own.at<std::uint8_t>(y, x) = inked.at<std::uint8_t>(inner.y + y, inner.x + x);
        drop_grid(own);
    }
    keep_long(kept, kLongPiece);
    return kept;
}

}  // namespace

void take_out(Image& picture, const PixelColour& ground, const InkedBars& found) {
    const cv::Mat inked = far_from(picture, ground);
    cv::Mat gone = cv::Mat::zeros(inked.size(), CV_8U), kept = crossing(picture, inked, found);
    for (const InkedBar& bar : found.bars) gone(box_of(bar, kBarBorder, gone)) = 255;
    if (found.axis) {
        const int from = found.axis->first, wide = found.axis->second - from + 1;
        gone((found.lying ? cv::Rect(from, 0, wide, gone.rows) : cv::Rect(0, from, gone.cols, wide)) &
             cv::Rect(0, 0, gone.cols, gone.rows)) = 0;
    }
    // Over the sides of bars it goes on to what it is beyond them.
    if (cv::countNonZero(kept) > 0) kept |= closed_by(kept | (inked & ~gone), kOverSide) & inked & spread(kept, kOverSide);
    view_of(picture).setTo(cv::Scalar(ground[0], ground[1], ground[2]), gone & ~kept);
}

}  // namespace tactics
