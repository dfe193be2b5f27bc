// SPDX-License-Identifier: Apache-2.0
#include "filters/inked_fills.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <map>
#include <utility>

#include "filters/darken.h"
#include "filters/opencv.h"
#include "filters/outline.h"
#include "filters/smooth.h"
#include "tactics/geometry/course.h"
#include "tactics/geometry/skeleton.h"
#include "tactics/layout/texture.h"
#include "tactics/layout/texture_choice.h"

namespace tactics {

namespace {

// Settings, in mm on the page. A surface must hold what is felt as a texture (6.4 mm) with the gap to its outline on both sides.
constexpr double kNarrowest = 11;
constexpr double kHatchGap = 4.8;   // white between the lines of a hatch; more is a ground with lines on it
constexpr double kHatchPart = 8;    // any place of a hatch has so much of it around
constexpr int kFlat = 14;           // levels that neighbours in one colour may differ by; JPEG leaves some
constexpr int kSameColour = 20;     // levels in any channel
constexpr double kMostOpen = 0.12;  // of the border of a hatch without a line
constexpr std::size_t kMostParts = 400;

using MeanColour = std::array<double, 3>;

struct FillKind {
    MeanColour colour{};  // the mean
    bool hatch = false;
    double angle = 0, order = 0;  // of a hatch: doubled, and how much all lines run one way
};

struct Part {
    cv::Rect box;
    cv::Mat mask;  // of the box
    FillKind kind;
};

// By distances: the time does not grow with the radius. Beyond the picture is nothing.
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

// As if what comes to the picture's edge went on beyond it: white below an axis is often cut close.
cv::Mat gone_on(const cv::Mat& mask, cv::Rect box, cv::Size picture, double so_far) {
    const auto beyond = [so_far](bool on_edge) { return on_edge ? static_cast<int>(std::ceil(so_far)) : 0; };
    cv::Mat wide;
    cv::copyMakeBorder(mask, wide, beyond(box.y == 0), beyond(box.br().y == picture.height), beyond(box.x == 0),
                       beyond(box.br().x == picture.width), cv::BORDER_REPLICATE);
    return wide;
}

MeanColour mean_of(const cv::Mat& pixels, const cv::Mat& mask) {
    const cv::Scalar mean = cv::mean(pixels, mask);
    return pixels.channels() == 1 ? MeanColour{mean[0], mean[0], mean[0]} : MeanColour{mean[0], mean[1], mean[2]};
}

MeanColour as_mean(const std::array<int, 3>& colour) {
    return {static_cast<double>(colour[0]), static_cast<double>(colour[1]), static_cast<double>(colour[2])};
}

// In the channel of most.
double levels_between(const MeanColour& a, const MeanColour& b) {
    return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

bool alike(const MeanColour& a, const MeanColour& b) { return levels_between(a, b) <= kSameColour; }

bool same_kind(const FillKind& a, const FillKind& b) {
    constexpr double kSameOrder = 0.25, kSameAngle = 0.7;  // 20 degrees of a line's direction, doubled
    if (a.hatch != b.hatch) return false;
    if (!a.hatch) return alike(a.colour, b.colour);
    if (std::abs(a.order - b.order) > kSameOrder) return false;
    return std::cos(a.angle - b.angle) > std::cos(kSameAngle) || std::max(a.order, b.order) < kSameOrder;
}

// Parts of one colour, with the paler pixels of their border.
cv::Mat flat_places(const cv::Mat& pixels) { return range_around(pixels) <= kFlat; }

struct Found {
    std::vector<Part> flats;  // without the ground
    cv::Mat open;             // where one colour is all around, the ground's, too
};

Found flats_of(const cv::Mat& pixels, const MeanColour& ground, double mm) {
    Found found;
    cv::Mat labels, stats, middles;
    const int count = cv::connectedComponentsWithStats(flat_places(pixels), labels, stats, middles, 4, CV_32S);
    found.open = cv::Mat::zeros(pixels.size(), CV_8U);
    const double least = kHatchGap / mm;
    std::vector<Part> parts;
    for (int i = 1; i < count; ++i) {
        const cv::Rect box = box_of_piece(stats, i);
        const bool is_cut = box.x == 0 || box.y == 0 || box.br().x == pixels.cols || box.br().y == pixels.rows;
        if ((std::min(box.width, box.height) < least && !is_cut) || parts.size() == kMostParts) continue;
        const cv::Mat own = labels(box) == i;
        const double width = widest(own);
        if (width < least && !(is_cut && widest(gone_on(own, box, pixels.size(), least)) >= least)) continue;
        Part part{box, own, {}};
        part.kind.colour = mean_of(pixels(box), own);
        cv::Mat(found.open(box)) |= own;
        if (width * mm < kNarrowest && stats.at<int>(i, cv::CC_STAT_AREA) < 0.1 * static_cast<double>(pixels.total())) continue;
        parts.push_back(std::move(part));
    }
    // Of two that are like it, as white and a pale fill are, the nearer one is the ground.
    const auto off_ground = [&](const Part& part) { return levels_between(part.kind.colour, ground); };
    const auto nearest =
        std::min_element(parts.begin(), parts.end(), [&](const Part& a, const Part& b) { return off_ground(a) < off_ground(b); });
    if (nearest != parts.end() && alike(nearest->kind.colour, ground)) {
        const MeanColour own = nearest->kind.colour;
        std::erase_if(parts, [&](const Part& part) { return alike(part.kind.colour, own); });
    }
    found.flats = std::move(parts);
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

// Each part is looked at within its own box, so that the time grows with the picture, and hardly with the number of parts.
std::vector<Part> hatches_of(const cv::Mat& pixels, const Image& ink, const Found& found, double mm) {
    const double reach = kHatchPart / 4 / mm, round = std::max(2.0, 1 / mm);
    const int margin = static_cast<int>(reach + round) + 3;
    const cv::Mat busy = ~grown(found.open, 2), core = opened(busy, kHatchPart / 2 / mm), black = view_of(ink) < 160,
                  near_ink = grown(black, 3);
    std::vector<Part> parts;
    cv::Mat labels, stats, middles;
    const int count = cv::connectedComponentsWithStats(core, labels, stats, middles, 8, CV_32S);
    for (int i = 1; i < count && parts.size() < kMostParts; ++i) {
        const cv::Rect box =
            cv::Rect(stats.at<int>(i, cv::CC_STAT_LEFT) - margin, stats.at<int>(i, cv::CC_STAT_TOP) - margin,
                     stats.at<int>(i, cv::CC_STAT_WIDTH) + 2 * margin, stats.at<int>(i, cv::CC_STAT_HEIGHT) + 2 * margin) &
            cv::Rect(0, 0, pixels.cols, pixels.rows);
        // The corners that a disc does not reach into.
        Part part{box, opened(grown(labels(box) == i, reach) & busy(box), round), {}};
        const int size = cv::countNonZero(part.mask);
        if (size == 0 || widest(part.mask) * mm < kNarrowest) continue;
        const double share = static_cast<double>(cv::countNonZero(part.mask & black(box))) / size;
        if (share < 0.05 || share > 0.8 || !is_bounded(near_ink(box), part.mask)) continue;
        part.kind.hatch = true;
        part.kind.colour = mean_of(pixels(box), part.mask);
        find_direction(view_of(ink)(box), part.mask, part.kind);
        parts.push_back(std::move(part));
    }
    return parts;
}

// Surfaces as dark as the lines of a hatch.
cv::Mat dark_places(const std::vector<Part>& flats, cv::Size size) {
    constexpr double kDark = 100;
    cv::Mat dark = cv::Mat::zeros(size, CV_8U);
    for (const Part& flat : flats)
        if (*std::max_element(flat.kind.colour.begin(), flat.kind.colour.end()) < kDark)
            cv::Mat(dark(flat.box)).setTo(255, flat.mask);
    return dark;
}

// Where the lines of a hatch are painted over: up to its outline, or to a dark surface, with which that is one.
cv::Mat within_outline(const cv::Mat& mask, const cv::Mat& dark) {
    if (cv::countNonZero(dark) == 0) return shrunk(mask, 2);
    return shrunk(mask | grown(dark, 3), 2) & ~grown(dark, 1);
}

// Its rings in mm.
Area area_of(const Part& part, double mm) {
    const cv::Mat& mask = part.mask;
    InkMap map(mask.cols, mask.rows);
    for (int y = 0; y < mask.rows; ++y)
        for (int x = 0; x < mask.cols; ++x) map.row(y)[x] = mask.at<std::uint8_t>(y, x) != 0 ? 1 : 0;
    Area area;
    for (const Outline& outline : outlines_of(map))
        for (const OutlineRing& ring : outline.rings) {
            if (ring.extent * mm < 2) continue;
            std::vector<Point> points = smooth(ring.points, true);
            points.push_back(points.front());
            points = course_of(points, 0.2 / mm);
            points.pop_back();
            if (points.size() < 3) continue;
            for (Point& p : points) p = {(p.x + part.box.x) * mm, (p.y + part.box.y) * mm};
            area.rings.push_back(std::move(points));
        }
    return area;
}

}  // namespace

std::vector<Area> take_fills(Image& picture, const std::array<int, 3>& ground) {
    const double mm = picture.mm_per_pixel;
    if (std::min(picture.width, picture.height) * mm < kNarrowest) return {};
    cv::Mat pixels = view_of(picture);
    const Image ink = ink_on_white(picture);
    Found found = flats_of(pixels, as_mean(ground), mm);
    std::vector<Part> parts = hatches_of(pixels, ink, found, mm);
    const cv::Mat dark = dark_places(found.flats, pixels.size());
    for (const Part& hatch : parts)
        pixels(hatch.box).setTo(cv::Scalar(hatch.kind.colour[0], hatch.kind.colour[1], hatch.kind.colour[2]),
                                within_outline(hatch.mask, dark(hatch.box)));
    const bool any_hatch = !parts.empty();
    parts.insert(parts.end(), std::make_move_iterator(found.flats.begin()), std::make_move_iterator(found.flats.end()));
    std::vector<FillKind> kinds;
    std::vector<std::size_t> kind_of;
    for (const Part& part : parts) {
        const auto same =
            std::find_if(kinds.begin(), kinds.end(), [&](const FillKind& kind) { return same_kind(kind, part.kind); });
        kind_of.push_back(static_cast<std::size_t>(same - kinds.begin()));
        if (same == kinds.end()) kinds.push_back(part.kind);
    }
    if (kinds.size() > textures().size() || (kinds.size() < 2 && !any_hatch)) return {};
    // The ground stays blank: it is beside all of them.
    std::vector<std::vector<double>> beside(kinds.size() + 1, std::vector<double>(kinds.size() + 1, 1));
    for (std::size_t i = 0; i <= kinds.size(); ++i) beside[i][0] = beside[0][i] = 100;
    std::vector<double> grey{255};
    for (const FillKind& kind : kinds) grey.push_back(0.299 * kind.colour[0] + 0.587 * kind.colour[1] + 0.114 * kind.colour[2]);
    const std::vector<int> chosen = choose_textures(beside, grey);
    std::vector<Area> areas;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        Area area = area_of(parts[i], mm);
        area.texture = chosen[kind_of[i] + 1];
        if (area.texture > 0 && !area.rings.empty()) areas.push_back(std::move(area));
    }
    return areas;
}

std::vector<Area> without_ground_around(std::vector<Area> areas, double width, double height) {
    constexpr double kShareOfFrame = 0.3, kOnFrame = 1.5;  // mm
    const auto on_frame = [&](Point a, Point b) {
        return (std::max(a.x, b.x) < kOnFrame) || (std::max(a.y, b.y) < kOnFrame) || (std::min(a.x, b.x) > width - kOnFrame) ||
               (std::min(a.y, b.y) > height - kOnFrame);
    };
    std::map<int, double> along;  // mm of the frame, by texture
    for (const Area& area : areas)
        for (const auto& ring : area.rings)
            for (std::size_t i = 0; i < ring.size(); ++i)
                if (const Point a = ring[i], b = ring[(i + 1) % ring.size()]; on_frame(a, b))
                    along[area.texture] += distance(a, b);
    const auto most =
        std::max_element(along.begin(), along.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    if (most != along.end() && most->second >= kShareOfFrame * 2 * (width + height))
        std::erase_if(areas, [&](const Area& area) { return area.texture == most->first; });
    return areas;
}

std::optional<Point> hatched_place(const Image& picture) {
    constexpr double kPage = 250;  // mm of the longer side
    const double mm = kPage / std::max(picture.width, picture.height);
    const cv::Mat pixels = view_of(picture);
    const Image ink = ink_on_white(picture);
    const std::vector<Part> parts = hatches_of(pixels, ink, flats_of(pixels, as_mean(ground_of(picture)), mm), mm);
    std::optional<Point> place;
    double most = 0;
    for (const Part& part : parts) {
        if (!same_kind(part.kind, parts.front().kind)) return std::nullopt;
        cv::Mat deep;
        cv::distanceTransform(part.mask, deep, cv::DIST_L2, cv::DIST_MASK_PRECISE);
        double own = 0;
        cv::Point at;
        cv::minMaxLoc(deep, nullptr, &own, nullptr, &at);
        if (own > most) {
            most = own;
            place = Point{part.box.x + at.x + 0.5, part.box.y + at.y + 0.5};
        }
    }
    return place;
}

}  // namespace tactics
