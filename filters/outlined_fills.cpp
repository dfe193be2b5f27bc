// SPDX-License-Identifier: Apache-2.0
#include "filters/outlined_fills.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "filters/opencv.h"

namespace tactics {

namespace {

// mm on the page; pixels where those are larger.
constexpr double kBesideFill = 0.6;   // so far from a part reach the paler pixels of its border, or half of the line around it
constexpr double kFillOutline = 0.5;  // width, as that of curves of charts
constexpr double kCoarsestOutline = 0.7;  // a pixel, so that a line of one is no surface
constexpr double kLineLevels = 100;       // off the ground: as dark as a line that is drawn by its middle
constexpr double kGroundLevels = 20;      // levels in any channel
constexpr int kUnfilled = 0, kGroundFill = 1, kFirstFill = 2;

MeanColour level_of(const cv::Mat& pixels, int x, int y) {
    const std::uint8_t* pixel = pixels.ptr(y, x);
    if (pixels.channels() == 1) return {double(pixel[0]), double(pixel[0]), double(pixel[0])};
    return {double(pixel[0]), double(pixel[1]), double(pixel[2])};
}

cv::Mat highest(const cv::Mat& pixels) {
    cv::Mat most;
    cv::reduce(pixels.reshape(1, static_cast<int>(pixels.total())), most, 1, cv::REDUCE_MAX);
    return most.reshape(1, pixels.rows);
}

// The part or ground that is nearest, within that distance, and its colour.
class Nearest {
public:
    Nearest(const cv::Mat& pixels, const FilledParts& fills, double most)
        : pixels_(pixels), colours_(pixels.clone()), most_(most) {
        const auto& [red, green, blue] = fills.ground;
        const cv::Scalar ground(red, green, blue), same(kGroundLevels, kGroundLevels, kGroundLevels);
        cv::Mat on_ground;
        cv::inRange(pixels, ground - same, ground + same, on_ground);
        own_ = cv::Mat::zeros(pixels.size(), CV_32S);
        own_.setTo(kGroundFill, on_ground);
        int number = kFirstFill;
        for (const FilledPart& part : fills.parts)
            own_(cv::Rect(part.left, part.top, part.mask.width, part.mask.height)).setTo(number++, view_of(part.mask));
        find_places();
        add_scraps(fills.ground, 3 * most);
        find_places();
    }

    const cv::Mat& own() const { return own_; }
    bool is_own(int x, int y) const { return own_.at<int>(y, x) != kUnfilled; }
    int at(int x, int y) const { return away_.at<float>(y, x) > most_ ? kUnfilled : own_.at<int>(place(x, y)); }
    MeanColour colour(int x, int y) const { return level_of(colours_, place(x, y).x, place(x, y).y); }

private:
    void find_places() {
        cv::distanceTransform(own_ == kUnfilled, away_, label_, cv::DIST_L2, cv::DIST_MASK_5, cv::DIST_LABEL_PIXEL);
        places_.assign(pixels_.total() + 1, {});
        for (int y = 0; y < pixels_.rows; ++y)
            for (int x = 0; x < pixels_.cols; ++x)
                if (own_.at<int>(y, x) != kUnfilled) places_[static_cast<std::size_t>(label_.at<int>(y, x))] = {x, y};
    }
    // JPEG leaves waves of nearly one colour beside a line.
    void add_scraps(const MeanColour& ground, double most) {
        constexpr double kNearlyOne = 45, kShare = 0.4;  // levels; of the contrast to the ground
        cv::Mat more = own_.clone();
        for (int y = 0; y < pixels_.rows; ++y)
            for (int x = 0; x < pixels_.cols; ++x)
                if (const cv::Point near = place(x, y); !is_own(x, y) && away_.at<float>(y, x) <= most) {
                    const MeanColour fill = colour(x, y);
                    const bool is_ground = own_.at<int>(near) == kGroundFill;
                    const double nearly = is_ground ? kGroundLevels : std::min(kNearlyOne, kShare * contrast(fill, ground));
                    if (contrast(level_of(pixels_, x, y), fill) >= nearly) continue;
                    more.at<int>(y, x) = own_.at<int>(near);
                    std::copy_n(pixels_.ptr(near.y, near.x), pixels_.channels(), colours_.ptr(y, x));
                }
        own_ = more;
    }
    cv::Point place(int x, int y) const { return places_[static_cast<std::size_t>(label_.at<int>(y, x))]; }

    const cv::Mat& pixels_;
    cv::Mat colours_;  // of scraps that of what they belong to
    double most_;
    cv::Mat own_, away_, label_;
    std::vector<cv::Point> places_;
};

// Where a part ends and another, or the ground, begins.
cv::Mat borders(const Nearest& nearest, const FilledParts& fills, const cv::Mat& pixels) {
    const cv::Size size = pixels.size();
    cv::Mat lines = cv::Mat::zeros(size, CV_8U);
    const auto is_hatch = [&](int number) {
        return number >= kFirstFill && fills.parts[static_cast<std::size_t>(number - kFirstFill)].kind.hatch;
    };
    const auto look = [&](int x, int y, int u, int v) {
        const int one = nearest.at(x, y), other = nearest.at(u, v);
        if (one == other || one == kUnfilled || other == kUnfilled || std::max(one, other) < kFirstFill) return;
        // Two in one colour have something else between them.
        if (!is_hatch(one) && !is_hatch(other) && alike(nearest.colour(x, y), nearest.colour(u, v)) &&
            alike(nearest.colour(x, y), level_of(pixels, x, y)) && alike(nearest.colour(x, y), level_of(pixels, u, v)))
            return;
        lines.at<std::uint8_t>(y, x) = 255;
    };
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            if (x + 1 < size.width) look(x, y, x + 1, y);
            if (y + 1 < size.height) look(x, y, x, y + 1);
        }
    // A part that goes on to the picture's border ends there.
    const auto end = [&](int x, int y) {
        if (nearest.at(x, y) >= kFirstFill) lines.at<std::uint8_t>(y, x) = 255;
    };
    for (int x = 0; x < size.width; ++x) {
        end(x, 0);
        end(x, size.height - 1);
    }
    for (int y = 0; y < size.height; ++y) {
        end(0, y);
        end(size.width - 1, y);
    }
    return lines;
}

// What is drawn between fills, and is no mixture of those around it, as their borders are.
cv::Mat drawn_between(const cv::Mat& pixels, const cv::Mat& filled, double reach) {
    constexpr double kMixed = 40;  // levels
    const int side = 2 * static_cast<int>(std::ceil(reach)) + 1;
    const cv::Mat around = cv::getStructuringElement(cv::MORPH_RECT, cv::Size(side, side));
    cv::Mat low(pixels.size(), pixels.type(), cv::Scalar::all(255)), high(pixels.size(), pixels.type(), cv::Scalar::all(0));
    pixels.copyTo(low, filled);
    pixels.copyTo(high, filled);
    cv::erode(low, low, around);
    cv::dilate(high, high, around);
    cv::subtract(low, pixels, low);
    cv::subtract(pixels, high, high);
    return highest(cv::max(low, high)) > kMixed;
}

// In their mean colour, so that they have edges as one in one colour has.
void paint_hatches(Image& picture, const FilledParts& fills) {
    cv::Mat pixels = view_of(picture);
    for (const FilledPart& part : fills.parts) {
        const cv::Rect box(part.left, part.top, part.mask.width, part.mask.height);
        const auto& [red, green, blue] = part.kind.colour;
        if (part.kind.hatch) pixels(box).setTo(cv::Scalar(red, green, blue), view_of(part.mask));
    }
}

}  // namespace

void draw_by_outlines(Image& picture, const FilledParts& fills) {
    if (fills.parts.empty()) return;
    const double mm = picture.mm_per_pixel;
    if (mm > kCoarsestOutline) return paint_hatches(picture, fills);
    const cv::Mat before = view_of(picture).clone();
    const double reach = kBesideFill / mm + 1.5;
    const Nearest nearest(before, fills, reach);
    const cv::Mat drawn = drawn_between(before, nearest.own() != kUnfilled, reach);
    cv::Mat near_fill;
    cv::distanceTransform(nearest.own() < kFirstFill, near_fill, cv::DIST_L2, cv::DIST_MASK_PRECISE);
    near_fill = near_fill <= reach;
    const bool light = fills.ground[0] + fills.ground[1] + fills.ground[2] > 1.5 * 255;
    const auto paint = [&](int x, int y, double ink) {
        std::uint8_t* pixel = picture.row(y) + static_cast<std::ptrdiff_t>(x) * picture.channels;
        for (int c = 0; c < picture.channels; ++c)
            pixel[c] = static_cast<std::uint8_t>(
                std::clamp(fills.ground[static_cast<std::size_t>(c)] + (light ? -ink : ink), 0.0, 255.0));
    };
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const int number = nearest.at(x, y);
            if (number < kFirstFill && near_fill.at<std::uint8_t>(y, x) == 0) continue;
            const bool in_hatch = number >= kFirstFill && fills.parts[static_cast<std::size_t>(number - kFirstFill)].kind.hatch;
            const bool is_line = !in_hatch && !nearest.is_own(x, y) && drawn.at<std::uint8_t>(y, x) != 0;
            paint(x, y, is_line ? contrast(level_of(before, x, y), fills.ground) : 0);
        }
    // Where a line is already, it stays as it is.
    cv::Mat lines = borders(nearest, fills, before), ink;
    cv::absdiff(view_of(picture), cv::Scalar(fills.ground[0], fills.ground[1], fills.ground[2]), ink);
    cv::dilate(highest(ink), ink, cv::getStructuringElement(cv::MORPH_RECT, cv::Size(5, 5)));
    cv::Mat missing = lines & (ink < kLineLevels);
    cv::dilate(missing, missing, cv::getStructuringElement(cv::MORPH_RECT, cv::Size(7, 7)));
    lines &= missing;
    const int side = std::max(1, static_cast<int>(std::lround(kFillOutline / mm)));
    cv::dilate(lines, lines, cv::getStructuringElement(cv::MORPH_RECT, cv::Size(side, side)));
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            if (lines.at<std::uint8_t>(y, x) != 0) paint(x, y, 255);
}

}  // namespace tactics
