// SPDX-License-Identifier: Apache-2.0
#include "filters/filled_parts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <utility>

#include "filters/opencv.h"

namespace tactics {

namespace {

// Settings, in mm on the page.
constexpr double kHatchGap = 4.8;       // white between the lines of a hatch; more is a ground with lines on it
constexpr double kHatchPart = 8;        // any place of a hatch has so much of it around
constexpr double kNarrowestHatch = 11;  // it holds what is felt as a texture, 6.4 mm, with the gap to its outline on both sides
constexpr double kNarrowestFill = 3.4;  // the gap at which a finger feels two lines, here the sides
constexpr double kSmallest = 11;        // longer side; less is a point
constexpr double kSmallestCurved = 20;  // less may be the head of an arrow, unless it is a box
constexpr double kBox = 0.9;            // of the area around it
constexpr double kWidestLine = 2;       // of a hatch, or dot
constexpr int kFlatFill = 14;           // levels that neighbours in one colour may differ by; JPEG leaves some
constexpr int kOneColour = 20;          // levels in any channel
constexpr double kSeenFill = 30;        // levels off the ground, of a fill
constexpr int kWhiteOfHatch = 215;      // grey levels, of the ground between its lines, which may be grey
constexpr double kMostOpen = 0.12;      // of the border of a hatch without a line
constexpr std::size_t kMostParts = 400;

struct FoundPart {
    cv::Rect box;
    cv::Mat mask;  // of the box
    FillKind kind;
    double width = 0;
};

// By distances: the time does not grow with the radius. Beyond the mask is nothing.
cv::Mat shrunk(const cv::Mat& mask, double radius) {
    cv::Mat deep;
    cv::copyMakeBorder(mask, deep, 1, 1, 1, 1, cv::BORDER_CONSTANT, cv::Scalar(0));
    cv::distanceTransform(deep, deep, cv::DIST_L2, cv::DIST_MASK_PRECISE);
    return deep(cv::Rect(1, 1, mask.cols, mask.rows)) > radius;
}

cv::Mat grown(const cv::Mat& mask, double radius) {
    cv::Mat away;
    cv::distanceTransform(~mask, away, cv::DIST_L2, cv::DIST_MASK_PRECISE);
    return away <= radius;
}

cv::Mat opened(const cv::Mat& mask, double radius) { return grown(shrunk(mask, radius), radius) & mask; }

double widest(const cv::Mat& mask) {
    cv::Mat deep;
    cv::copyMakeBorder(mask, deep, 1, 1, 1, 1, cv::BORDER_CONSTANT, cv::Scalar(0));
    cv::distanceTransform(deep, deep, cv::DIST_L2, cv::DIST_MASK_PRECISE);
    double most = 0;
    cv::minMaxLoc(deep, nullptr, &most);
    return 2 * most;
}

MeanColour mean_of(const cv::Mat& pixels, const cv::Mat& mask) {
    const cv::Scalar mean = cv::mean(pixels, mask);
    return pixels.channels() == 1 ? MeanColour{mean[0], mean[0], mean[0]} : MeanColour{mean[0], mean[1], mean[2]};
}

// The channel that is most.
cv::Mat most_of(const cv::Mat& pixels) {
    if (pixels.channels() == 1) return pixels;
    std::array<cv::Mat, 3> planes;
    cv::split(pixels, planes.data());
    return cv::max(planes[0], cv::max(planes[1], planes[2]));
}

cv::Mat off(const cv::Mat& pixels, const MeanColour& colour) {
    cv::Mat by;
    cv::absdiff(pixels, cv::Scalar(colour[0], colour[1], colour[2]), by);
    return most_of(by);
}

// Parts of one colour, without the paler pixels of their border.
cv::Mat flat_places(const cv::Mat& pixels) {
    cv::Mat low, high, range;
    cv::erode(pixels, low, cv::Mat());
    cv::dilate(pixels, high, cv::Mat());
    cv::subtract(high, low, range);
    return most_of(range) <= kFlatFill;
}

MeanColour level_at(const cv::Mat& pixels, int x, int y) {
    const std::uint8_t* pixel = pixels.ptr(y) + static_cast<std::ptrdiff_t>(x) * pixels.channels();
    if (pixels.channels() == 1) return {double(pixel[0]), double(pixel[0]), double(pixel[0])};
    return {double(pixel[0]), double(pixel[1]), double(pixel[2])};
}

// The colour of which there is most, to an eighth of the range.
MeanColour commonest(const cv::Mat& pixels, const cv::Mat& mask) {
    constexpr int kShift = 5, kCells = 8;
    std::vector<std::pair<int, MeanColour>> cells(kCells * kCells * kCells);
    for (int y = 0; y < pixels.rows; ++y)
        for (int x = 0; x < pixels.cols; ++x) {
            if (mask.at<std::uint8_t>(y, x) == 0) continue;
            const MeanColour colour = level_at(pixels, x, y);
            std::size_t cell = 0;
            for (const double level : colour) cell = cell * kCells + static_cast<std::size_t>(static_cast<int>(level) >> kShift);
            ++cells[cell].first;
            for (std::size_t c = 0; c < 3; ++c) cells[cell].second[c] += colour[c];
        }
    auto [count, sum] =
        *std::max_element(cells.begin(), cells.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (double& level : sum) level /= std::max(1, count);
    return sum;
}

// Most of the picture, or of what is along its border, if that is lighter: large surfaces may take most of a picture that ends
// where the drawing does, but what they are drawn on is still around them.
MeanColour ground_of(const cv::Mat& pixels, double mm) {
    constexpr double kAlong = 2;  // mm
    const cv::Mat flat = flat_places(pixels);
    const MeanColour most = commonest(pixels, flat);
    const int inset = static_cast<int>(std::ceil(kAlong / mm));
    if (pixels.cols <= 2 * inset || pixels.rows <= 2 * inset) return most;
    cv::Mat along = flat.clone();
    along(cv::Rect(inset, inset, pixels.cols - 2 * inset, pixels.rows - 2 * inset)) = 0;
    const MeanColour border = commonest(pixels, along);
    return border[0] + border[1] + border[2] > most[0] + most[1] + most[2] ? border : most;
}

struct Flats {
    std::vector<FoundPart> parts;  // without the ground
    cv::Mat open;                  // where one colour is all around, the ground's, too
};

Flats flats_of(const cv::Mat& pixels, const MeanColour& ground, double mm) {
    Flats found;
    cv::Mat labels, stats, middles;
    const int count = cv::connectedComponentsWithStats(flat_places(pixels), labels, stats, middles, 4, CV_32S);
    found.open = cv::Mat::zeros(pixels.size(), CV_8U);
    for (int i = 1; i < count; ++i) {
        const int wide = stats.at<int>(i, cv::CC_STAT_WIDTH), high = stats.at<int>(i, cv::CC_STAT_HEIGHT);
        if (std::min(wide, high) * mm < kNarrowestFill || found.parts.size() == kMostParts) continue;
        const cv::Rect box(stats.at<int>(i, cv::CC_STAT_LEFT), stats.at<int>(i, cv::CC_STAT_TOP), wide, high);
        FoundPart part{box, labels(box) == i, {}};
        part.width = widest(part.mask);
        if (part.width * mm < kNarrowestFill) continue;
        part.kind.colour = part.kind.behind = mean_of(pixels(box), part.mask);
        const bool is_ground = contrast(part.kind.colour, ground) < kSeenFill;
        if (part.width * mm >= kHatchGap)
            cv::Mat(found.open(box)) |= is_ground ? part.mask : opened(part.mask, kHatchGap / 2 / mm);
        const double area = stats.at<int>(i, cv::CC_STAT_AREA), longer = std::max(wide, high) * mm;
        if (is_ground || longer < kSmallest || (longer < kSmallestCurved && area < kBox * wide * high)) continue;
        // A line that widens where others meet it is none.
        if (2 * cv::countNonZero(opened(part.mask, kNarrowestFill / 2 / mm)) > area) found.parts.push_back(std::move(part));
    }
    return found;
}

// Which way the lines run, from the products of the slopes.
void find_direction(const cv::Mat& ink, const cv::Mat& mask, FillKind& kind) {
    cv::Mat dx, dy;
    cv::Sobel(ink, dx, CV_32F, 1, 0);
    cv::Sobel(ink, dy, CV_32F, 0, 1);
    const double xx = cv::mean(dx.mul(dx), mask)[0], yy = cv::mean(dy.mul(dy), mask)[0], xy = cv::mean(dx.mul(dy), mask)[0];
    kind.angle = std::atan2(2 * xy, xx - yy);
    kind.order = xx + yy > 0 ? std::hypot(xx - yy, 2 * xy) / (xx + yy) : 0;
}

// Nearly all of its border is a line: a row of things beside each other has none around it.
bool is_bounded(const cv::Mat& near_ink, const cv::Mat& mask) {
    const cv::Mat border = mask & ~shrunk(mask, 2);
    const int all = cv::countNonZero(border);
    return all > 0 && cv::countNonZero(border & ~near_ink) <= kMostOpen * all;
}

// Hatches on a ground of their own, or on that of the picture.
class Hatches {
public:
    Hatches(const cv::Mat& pixels, double mm) : pixels_(pixels), mm_(mm) {}

    // Each part is looked at within its own box, so that the time grows with the picture, and hardly with the number of parts.
    void look(const cv::Mat& busy, const cv::Mat& behind, bool coloured) {
        const double reach = kHatchPart / 4 / mm_, round = std::max(2.0, 1 / mm_);
        const int margin = static_cast<int>(reach + round) + 3;
        cv::Mat ink;
        cv::absdiff(pixels_, behind, ink);
        ink = most_of(ink);
        const cv::Mat core = opened(busy, kHatchPart / 2 / mm_), lines = ink > 255 - kWhiteOfHatch, near_lines = grown(lines, 3);
        cv::Mat labels, stats, middles;
        const int count = cv::connectedComponentsWithStats(core, labels, stats, middles, 8, CV_32S);
        for (int i = 1; i < count && parts.size() < kMostParts; ++i) {
            const cv::Rect box =
                cv::Rect(stats.at<int>(i, cv::CC_STAT_LEFT) - margin, stats.at<int>(i, cv::CC_STAT_TOP) - margin,
                         stats.at<int>(i, cv::CC_STAT_WIDTH) + 2 * margin, stats.at<int>(i, cv::CC_STAT_HEIGHT) + 2 * margin) &
                cv::Rect(0, 0, pixels_.cols, pixels_.rows);
            // The corners that a disc does not reach into.
            FoundPart part{box, opened(grown(labels(box) == i, reach) & busy(box), round), {}};
            const int size = cv::countNonZero(part.mask);
            if (size == 0) continue;
            part.width = widest(part.mask);
            if (part.width * mm_ < kNarrowestHatch) continue;
            const double share = static_cast<double>(cv::countNonZero(part.mask & lines(box))) / size;
            if (share < 0.05 || share > 0.85 || !(coloured || is_bounded(near_lines(box), part.mask))) continue;
            part.kind.hatch = true;
            part.kind.colour = mean_of(pixels_(box), part.mask);
            part.kind.behind = mean_of(behind(box), part.mask);
            find_direction(ink(box), part.mask, part.kind);
            parts.push_back(std::move(part));
        }
    }

    std::vector<FoundPart> parts;

private:
    const cv::Mat& pixels_;
    double mm_;
};

// Dark lines are filled with what is beside them, and then light ones.
cv::Mat without_lines(const cv::Mat& pixels, double mm) {
    const int side = 2 * static_cast<int>(std::ceil(std::max(2.0, kWidestLine / mm) / 2)) + 1;
    const cv::Mat disc = cv::getStructuringElement(cv::MORPH_ELLIPSE, cv::Size(side, side));
    cv::Mat closed, both;
    cv::morphologyEx(pixels, closed, cv::MORPH_CLOSE, disc);
    cv::morphologyEx(closed, both, cv::MORPH_OPEN, disc);
    // Small dots close together leave some of their grey.
    cv::medianBlur(both, both, side);
    return both;
}

std::vector<FoundPart> hatches_of(const cv::Mat& pixels, const Flats& flats, const MeanColour& ground, double mm) {
    const cv::Mat behind = without_lines(pixels, mm);
    cv::Mat busy = ~grown(flats.open, 2);
    Hatches found(pixels, mm);
    found.look(busy & flat_places(behind) & (off(behind, ground) >= kSeenFill), behind, true);
    for (const FoundPart& part : found.parts) cv::Mat(busy(part.box)) &= ~grown(part.mask, 2);
    found.look(busy, cv::Mat(pixels.size(), pixels.type(), cv::Scalar(ground[0], ground[1], ground[2])), false);
    return std::move(found.parts);
}

}  // namespace

bool alike(const MeanColour& a, const MeanColour& b) { return contrast(a, b) <= kOneColour; }

double contrast(const MeanColour& a, const MeanColour& b) {
    return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

bool same_kind(const FillKind& a, const FillKind& b) {
    constexpr double kSameOrder = 0.25, kSameAngle = 0.7;  // 20 degrees of a line's direction, doubled
    if (a.hatch != b.hatch || !alike(a.behind, b.behind)) return false;
    if (!a.hatch) return true;
    if (std::abs(a.order - b.order) > kSameOrder) return false;
    return std::cos(a.angle - b.angle) > std::cos(kSameAngle) || std::max(a.order, b.order) < kSameOrder;
}

FilledParts filled_parts_in(const Image& picture, double mm) {
    const cv::Mat pixels = view_of(picture);
    FilledParts fills;
    fills.ground = ground_of(pixels, mm);
    // The strip of it below an axis, which may be narrow, is none between the lines of a hatch.
    const int wider = static_cast<int>(std::ceil(kHatchGap / mm)) + 3;
    cv::Mat wide;
    cv::copyMakeBorder(pixels, wide, wider, wider, wider, wider, cv::BORDER_CONSTANT,
                       cv::Scalar(fills.ground[0], fills.ground[1], fills.ground[2]));
    const Flats flats = flats_of(wide, fills.ground, mm);
    std::vector<FoundPart> found = hatches_of(wide, flats, fills.ground, mm);
    // Between the lines of a hatch there may be room for a disc, but none for a finger.
    cv::Mat hatched = cv::Mat::zeros(wide.size(), CV_8U);
    for (const FoundPart& part : found) cv::Mat(hatched(part.box)) |= part.mask;
    std::copy_if(flats.parts.begin(), flats.parts.end(), std::back_inserter(found), [&](const FoundPart& part) {
        return 2 * cv::countNonZero(hatched(part.box) & part.mask) < cv::countNonZero(part.mask);
    });
    for (const FoundPart& part : found) {
        const cv::Rect inside = part.box & cv::Rect(wider, wider, pixels.cols, pixels.rows);
        if (inside.empty()) continue;
        FilledPart own{inside.x - wider, inside.y - wider, make_image(inside.width, inside.height, 1, mm, 0),
                       part.kind,        part.width,       0};
        cv::Mat mask = view_of(own.mask);
        part.mask(inside - part.box.tl()).copyTo(mask);
        own.size = cv::countNonZero(mask);
        if (own.size > 0) fills.parts.push_back(std::move(own));
    }
    return fills;
}

}  // namespace tactics
