// SPDX-License-Identifier: Apache-2.0
#include "filters/pale_fills.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "filters/darken.h"
#include "filters/opencv.h"
#include "filters/straight_lines.h"

namespace tactics {

namespace {

constexpr int kPalest = 12, kInkFrom = 79;  // levels off the ground: less is grain, more is a line's colour
constexpr int kOneColour = 10;
constexpr double kLeastPale = 0.02;    // of the picture
constexpr double kNoRoomBeside = 4.2;  // mm from the middle of a line to the next: 3.2 of ground, and the lines themselves
// Of its border: hidden by lines; that or too near them; neither, so that it would be drawn.
constexpr double kUnderCurves = 0.5, kBesideCurves = 0.78, kStillSeen = 0.05;

constexpr double kMostInk = 0.15;  // of the place that it takes: of more it is a part of a picture

using PaleColour = std::array<double, 3>;

cv::Mat off_ground(const Image& picture) {
    const std::array<int, 3> ground = ground_of(picture);
    cv::Mat strength(picture.height, picture.width, CV_8U);
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            int most = 0;
            for (int c = 0; c < picture.channels; ++c)
                most = std::max(most, std::abs(ground[static_cast<std::size_t>(c)] - picture.row(y)[x * picture.channels + c]));
            strength.at<std::uint8_t>(y, x) = static_cast<std::uint8_t>(most);
        }
    return strength;
}

cv::Mat widened_by(const cv::Mat& mask, int reach) {
    cv::Mat grown;
    cv::dilate(mask, grown, cv::getStructuringElement(cv::MORPH_RECT, cv::Size(2 * reach + 1, 2 * reach + 1)));
    return grown;
}

// One mask a colour.
std::vector<cv::Mat> pale_surfaces(const cv::Mat& pixels, const cv::Mat& strength) {
    cv::Mat pale = (strength >= kPalest) & (strength < kInkFrom), labels, stats, middles;
    cv::morphologyEx(pale, pale, cv::MORPH_OPEN, cv::getStructuringElement(cv::MORPH_RECT, cv::Size(5, 5)));
    const int count = cv::connectedComponentsWithStats(pale, labels, stats, middles, 4, CV_32S);
    struct Surface {
        PaleColour colour{};
        int size = 0;
        std::vector<int> labels;
    };
    std::vector<Surface> surfaces;
    for (int i = 1; i < count; ++i) {
        const cv::Rect box = box_of_piece(stats, i);
        const cv::Scalar mean = cv::mean(pixels(box), labels(box) == static_cast<double>(i));
        const PaleColour colour{mean[0], mean[1], mean[2]};
        auto same = std::find_if(surfaces.begin(), surfaces.end(), [&](const Surface& other) {
            for (std::size_t c = 0; c < 3; ++c)
                if (std::abs(other.colour[c] - colour[c]) > kOneColour) return false;
            return true;
        });
        if (same == surfaces.end()) same = surfaces.insert(same, {colour, 0, {}});
        same->size += stats.at<int>(i, cv::CC_STAT_AREA);
        same->labels.push_back(i);
    }
    std::vector<cv::Mat> masks;
    for (const Surface& surface : surfaces) {
        if (surface.size < kLeastPale * static_cast<double>(pixels.total())) continue;
        std::vector<bool> own(static_cast<std::size_t>(count), false);
        for (const int label : surface.labels) own[static_cast<std::size_t>(label)] = true;
        cv::Mat mask = cv::Mat::zeros(labels.size(), CV_8U);
        for (int y = 0; y < labels.rows; ++y)
            for (int x = 0; x < labels.cols; ++x)
                if (own[static_cast<std::size_t>(labels.at<int>(y, x))]) mask.at<std::uint8_t>(y, x) = 255;
        masks.push_back(mask);
    }
    return masks;
}

}  // namespace

std::size_t leave_out_pale_fills(Image& picture) {
    const double mm = picture.mm_per_pixel;
    cv::Mat pixels = view_of(picture);
    const cv::Mat strength = off_ground(picture), ink = strength >= kInkFrom;
    const std::vector<cv::Mat> surfaces = pale_surfaces(pixels, strength);
    if (surfaces.empty()) return 0;
    cv::Mat curves = ink.clone();
    take_straight_lines({curves.data, curves.total()}, curves.cols);
    const cv::Mat beside_axes = widened_by(ink & ~curves, 3), on_curves = widened_by(curves, 2),
                  near_curves = widened_by(curves, static_cast<int>(std::ceil(kNoRoomBeside / mm)));
    const std::array<int, 3> ground = ground_of(picture);
    std::size_t left_out = 0;
    for (const cv::Mat& surface : surfaces) {
        const cv::Rect box = cv::boundingRect(surface);
        // What goes on beyond the picture is a ground, too.
        if (box.x == 0 || box.y == 0 || box.br().x == surface.cols || box.br().y == surface.rows) continue;
        if (cv::countNonZero(ink(box)) > kMostInk * box.area()) continue;
        const cv::Mat border = widened_by(surface, 2) & ~surface & ~beside_axes;
        const double all = cv::countNonZero(border), hidden = cv::countNonZero(border & on_curves),
                     near = cv::countNonZero(border & near_curves & ~on_curves);
        if (hidden < kUnderCurves * all || hidden + near < kBesideCurves * all || all - hidden < kStillSeen * all) continue;
        ++left_out;
        // Slivers between the curve and the border, too.
        const cv::Scalar own = cv::mean(pixels, surface), off = cv::Scalar::all(kOneColour);
        cv::Mat alike;
        cv::inRange(pixels, own - off, own + off, alike);
        pixels.setTo(cv::Scalar(ground[0], ground[1], ground[2]), (widened_by(surface, 2) | alike) & ~ink);
    }
    return left_out;
}

}  // namespace tactics
