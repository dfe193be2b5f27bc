// SPDX-License-Identifier: Apache-2.0
#include "filters/pale_strokes.h"

#include <algorithm>

#include "filters/darken.h"
#include "filters/opencv.h"

namespace tactics {

namespace {

constexpr int kFaintInk = 24, kMiddleInk = 40;      // levels of ink: a line's edge, and its middle
constexpr int kAsDark = 16, kHardly = 40;           // levels from the darkest place around: a middle, and what may be one
constexpr int kNearby = 5;                          // pixels
constexpr int kShortestRun = 9, kPartsOfSide = 20;  // pixels, and parts of a side, from which on a run is a level line

cv::Mat runs_in(const cv::Mat& mask, bool level) {
    const int longest = std::max(kShortestRun, (level ? mask.cols : mask.rows) / kPartsOfSide);
    cv::Mat runs;
    cv::morphologyEx(mask, runs, cv::MORPH_OPEN,
                     cv::getStructuringElement(cv::MORPH_RECT, level ? cv::Size(longest, 1) : cv::Size(1, longest)));
    return runs;
}

}  // namespace

double pale_strokes(const Image& picture) {
    const Image darkened = ink_on_white(picture);
    cv::Mat ink, around, inked;
    cv::bitwise_not(view_of(darkened), ink);
    const double cut = cv::threshold(ink, inked, 0, 255, cv::THRESH_BINARY | cv::THRESH_OTSU);
    cv::dilate(ink, around, cv::getStructuringElement(cv::MORPH_RECT, cv::Size(kNearby, kNearby)));
    const cv::Mat from_darkest = around - ink;
    const cv::Mat may_be_middle = (from_darkest < kHardly) & (ink >= kFaintInk) & (ink <= cut);
    const cv::Mat square = cv::getStructuringElement(cv::MORPH_RECT, cv::Size(3, 3));
    cv::Mat grid = runs_in(may_be_middle, true) | runs_in(may_be_middle, false);
    cv::dilate(grid, grid, square);
    const cv::Mat lost = (from_darkest <= kAsDark) & (ink >= kMiddleInk) & (ink <= cut) & (grid == 0);
    return static_cast<double>(cv::countNonZero(lost)) / std::max(picture.width, picture.height);
}

}  // namespace tactics
