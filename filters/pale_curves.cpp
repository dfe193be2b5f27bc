// SPDX-License-Identifier: Apache-2.0
#include "filters/pale_curves.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "filters/opencv.h"

namespace tactics {

namespace {

// Settings: levels off the ground, pixels, and shares of the longer side or of a piece.
constexpr int kFaintest = 24;
constexpr int kBesideInk = 5;      // across, in which there is no ink
constexpr int kThickestCurve = 5;  // a wider piece is a surface
constexpr double kLongPaleCurve = 0.06, kLongTogether = 0.25, kLongRun = 1.0 / 6, kMostOfRuns = 0.6;

cv::Mat box_of_ones(int across, int down) { return cv::getStructuringElement(cv::MORPH_RECT, cv::Size(across, down)); }

cv::Mat long_runs(const cv::Mat& mask) {
    const int longest = std::max(3, static_cast<int>(kLongRun * std::max(mask.cols, mask.rows)));
    cv::Mat level, upright;
    cv::morphologyEx(mask, level, cv::MORPH_OPEN, box_of_ones(longest, 1));
    cv::morphologyEx(mask, upright, cv::MORPH_OPEN, box_of_ones(1, longest));
    return level | upright;
}

// What of the pale ink is thin and by itself. `around`: the deepest ink around each place.
cv::Mat thin_pale_ink(const cv::Mat& depth, const cv::Mat& around, double cut) {
    cv::Mat wide;
    const cv::Mat pale = (depth >= kFaintest) & (around <= cut);
    cv::morphologyEx(pale, wide, cv::MORPH_OPEN, box_of_ones(kThickestCurve, kThickestCurve));
    cv::dilate(wide, wide, box_of_ones(kThickestCurve, kThickestCurve));
    return pale & ~wide;
}

// As plotting programs draw it: grain, uneven light and what JPEG leaves are off the ground, too, and would be taken for curves.
bool has_clean_ground(const cv::Mat& depth, const cv::Mat& around) {
    constexpr int kClean = 5;             // levels
    constexpr double kMostUneven = 0.01;  // of the places that are not beside ink
    const cv::Mat free = around < kFaintest;
    return cv::countNonZero(free & (depth > kClean)) <= kMostUneven * cv::countNonZero(free);
}

struct PalePiece {
    cv::Rect box;
    int label = 0;
    double deepest = 0;
};

// Of curves, which darker ones may cross; none where they are too short together.
std::vector<PalePiece> pieces_of_curves(const cv::Mat& depth, const cv::Mat& around, double cut, cv::Mat& labels) {
    cv::Mat joined, stats, middles;
    cv::dilate(thin_pale_ink(depth, around, cut), joined, box_of_ones(3, 3));
    const cv::Mat runs = long_runs(joined);
    const int count = cv::connectedComponentsWithStats(joined, labels, stats, middles, 8, CV_32S);
    const double side = std::max(depth.cols, depth.rows);
    std::vector<PalePiece> pieces;
    double together = 0;
    for (int i = 1; i < count; ++i) {
        const cv::Rect box = box_of_piece(stats, i);
        const double length = std::hypot(box.width, box.height);
        if (length < kLongPaleCurve * side || std::min(box.width, box.height) <= kThickestCurve) continue;
        const cv::Mat own = labels(box) == i;
        if (cv::countNonZero(own & runs(box)) > kMostOfRuns * cv::countNonZero(own)) continue;
        PalePiece piece{box, i, 0};
        cv::minMaxLoc(depth(box), nullptr, &piece.deepest, nullptr, nullptr, own);
        if (piece.deepest > cut) continue;
        together += length;
        pieces.push_back(piece);
    }
    return together >= kLongTogether * side ? pieces : std::vector<PalePiece>{};
}

}  // namespace

void deepen_pale_curves(Image& picture, const Image& ink, const std::array<int, 3>& ground) {
    const cv::Mat depth = 255 - view_of(ink);
    cv::Mat around, inked, labels;
    cv::dilate(depth, around, box_of_ones(kBesideInk, kBesideInk));
    if (!has_clean_ground(depth, around)) return;
    const double cut = cv::threshold(depth, inked, 0, 255, cv::THRESH_BINARY | cv::THRESH_OTSU);
    for (const PalePiece& piece : pieces_of_curves(depth, around, cut, labels)) {
        const double times = 255 / piece.deepest;
        for (int y = piece.box.y; y < piece.box.br().y; ++y)
            for (int x = piece.box.x; x < piece.box.br().x; ++x) {
                if (labels.at<int>(y, x) != piece.label) continue;
                std::uint8_t* const pixel = picture.row(y) + x * picture.channels;
                for (int c = 0; c < picture.channels; ++c) {
                    const int of_ground = ground[static_cast<std::size_t>(c)];
                    pixel[c] = static_cast<std::uint8_t>(std::clamp(of_ground + times * (pixel[c] - of_ground), 0.0, 255.0));
                }
            }
    }
}

}  // namespace tactics
