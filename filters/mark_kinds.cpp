// SPDX-License-Identifier: Apache-2.0
#include "filters/mark_kinds.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "filters/lab.h"
#include "filters/line_marks.h"
#include "filters/opencv.h"

namespace tactics {

namespace {

constexpr std::size_t kMostSeeds = 4000, kMostKinds = 16;
constexpr int kMarkMargin = 7;  // pixels of ground around a form
constexpr int kMarkShift = 3;   // pixels, as a bit of a line may move its box

struct MarkSeed {
    cv::Rect box;  // of its core
    PixelColour colour{};
    cv::Mat share;  // of ink, 0 to 255, with a margin around the box
};

// What is alike so far.
struct MarkGroup {
    MarkSeed first;
    std::vector<cv::Mat> shares;  // of all, each as large as the first one
    std::vector<cv::Rect> boxes;
};

// A core with the paler pixels around it and with the corners that a round core leaves off, up to `near` pixels away; what goes
// on beyond is a line.
cv::Mat with_corners(const cv::Mat& core, const cv::Mat& ink, int near) {
    const cv::Mat close = spread(core, 1);
    if (near <= 1) return close;
    const cv::Mat beyond = spread(core, near) & ~spread(core, near - 1);
    cv::Mat labels, own = close.clone();
    const int count = cv::connectedComponents(ink & spread(core, near) & ~close, labels, 8, CV_32S);
    for (int i = 1; i < count; ++i)
        if (const cv::Mat piece = labels == i; cv::countNonZero(piece & beyond) == 0) own |= spread(piece, 1);
    return own;
}

cv::Rect with_margin(const cv::Rect& box) {
    return {box.x - kMarkMargin, box.y - kMarkMargin, box.width + 2 * kMarkMargin, box.height + 2 * kMarkMargin};
}

bool is_mark_size(const cv::Rect& box, double least, double most) {
    constexpr double kAspect = 1.6;
    const int small = std::min(box.width, box.height), large = std::max(box.width, box.height);
    return small >= least && large <= most && large <= kAspect * small;
}

// `core` and `own`: masks of the box with its margin; of the surest ink, and of all that is its.
void add_seed(const Image& picture, const cv::Mat& pale, const cv::Mat& core, const cv::Rect& box, const cv::Mat& own,
              std::vector<MarkSeed>& seeds) {
    const cv::Rect wide = with_margin(box);
    double lightest = 0;
    cv::Point deepest;
    cv::minMaxLoc(pale(wide), &lightest, nullptr, &deepest, nullptr, core);
    cv::Mat share = (255 - pale(wide)) * (255 / std::max(1.0, 255 - lightest));
    share.setTo(0, ~own);
    seeds.push_back({box, pixel_colour(picture, wide.x + deepest.x, wide.y + deepest.y), share});
}

// Its pieces of that size. `core`: what they are known by; the ink near it is theirs.
void add_seeds(const Image& picture, const Image& ink, const cv::Mat& core, int near, double least, double most, cv::Mat& known,
               std::vector<MarkSeed>& seeds) {
    cv::Mat labels, stats, middles;
    const int count = cv::connectedComponentsWithStats(core, labels, stats, middles, 8, CV_32S);
    const cv::Mat pale = view_of(ink);
    for (int i = 1; i < count && seeds.size() < kMostSeeds; ++i) {
        const cv::Rect box = box_of_piece(stats, i), wide = with_margin(box);
        if (!is_mark_size(box, least, most) || (wide & cv::Rect(0, 0, ink.width, ink.height)) != wide) continue;
        const cv::Mat own = labels(wide) == i;
        if (cv::countNonZero(own & known(wide)) > 0) continue;
        cv::Mat(known(wide)).setTo(255, own);
        add_seed(picture, pale, own, box, with_corners(own, pale(wide) < kInkOfMarks, near), seeds);
    }
}

// How much of the ink of both is in one only, at the shift of `b` where that is least.
std::pair<double, cv::Point> difference(const cv::Mat& a, const cv::Mat& b) {
    cv::Mat soft_a, soft_b;
    cv::blur(a, soft_a, cv::Size(3, 3));
    cv::blur(b, soft_b, cv::Size(3, 3));
    const cv::Size common(std::min(a.cols, b.cols) - 2 * kMarkShift, std::min(a.rows, b.rows) - 2 * kMarkShift);
    const cv::Mat inner = soft_a(cv::Rect(cv::Point(kMarkShift, kMarkShift), common));
    std::pair<double, cv::Point> least{1, {0, 0}};
    for (int dy = -kMarkShift; dy <= kMarkShift; ++dy)
        for (int dx = -kMarkShift; dx <= kMarkShift; ++dx) {
            const cv::Mat other = soft_b(cv::Rect(cv::Point(kMarkShift + dx, kMarkShift + dy), common));
            const double all = cv::sum(inner)[0] + cv::sum(other)[0],
                         off = all > 0 ? cv::norm(inner, other, cv::NORM_L1) / all : 1;
            if (off < least.first) least = {off, {dx, dy}};
        }
    return least;
}

// Where a form lies between pixels changes its border: pixels of it, of both forms together.
double border_share(const cv::Mat& share) {
    const cv::Mat body = share > 127;
    cv::Mat inner;
    cv::erode(body, inner, cv::Mat());
    const int all = cv::countNonZero(body);
    return all == 0 ? 0 : (all - cv::countNonZero(inner)) / (2.0 * all);
}

// Where its form lies in the other's, if it is the same.
std::optional<cv::Point> shift_to(const MarkSeed& seed, const MarkSeed& first) {
    if (std::abs(seed.box.width - first.box.width) > kMarkShift || std::abs(seed.box.height - first.box.height) > kMarkShift ||
        channels_apart(seed.colour, first.colour) > kMarkColour)
        return std::nullopt;
    const auto [off, shift] = difference(first.share, seed.share);
    if (off > 0.02 + 0.25 * border_share(first.share)) return std::nullopt;
    return shift;
}

// As large as the first one.
cv::Mat moved_to(const cv::Mat& share, cv::Point shift, cv::Size size) {
    cv::Mat moved = cv::Mat::zeros(size, CV_8U);
    const cv::Rect all(cv::Point(0, 0), size), there = cv::Rect(-shift, share.size()) & all;
    share(there + shift).copyTo(moved(there));
    return moved;
}

std::vector<MarkGroup> groups_among(const std::vector<MarkSeed>& seeds) {
    constexpr std::size_t kMostGroups = 256;  // of things that differ: no plot
    std::vector<MarkGroup> groups;
    for (const MarkSeed& seed : seeds) {
        bool known = false;
        for (MarkGroup& group : groups)
            if (const auto shift = shift_to(seed, group.first)) {
                group.shares.push_back(moved_to(seed.share, *shift, group.first.share.size()));
                group.boxes.push_back(seed.box);
                known = true;
                break;
            }
        if (!known && groups.size() < kMostGroups) groups.push_back({seed, {seed.share}, {seed.box}});
    }
    std::erase_if(groups, [](const MarkGroup& group) { return group.shares.size() < kFewestMarks; });
    return groups;
}

// Letters stand beside others that are not alike.
bool is_print(const MarkGroup& group, const std::vector<cv::Rect>& pieces) {
    constexpr double kNear = 0.6, kAsHigh = 2, kMost = 0.5;  // of its size; times; of the group
    const auto has_neighbour = [&](const cv::Rect& own) {
        return std::any_of(pieces.begin(), pieces.end(), [&](const cv::Rect& other) {
            if (other.height > kAsHigh * own.height || own.height > kAsHigh * other.height) return false;
            if (std::find(group.boxes.begin(), group.boxes.end(), other) != group.boxes.end()) return false;
            const int gap = std::max(other.x - own.br().x, own.x - other.br().x),
                      common = std::min(own.br().y, other.br().y) - std::max(own.y, other.y);
            return gap >= 0 && gap <= kNear * own.height && 2 * common >= std::min(own.height, other.height);
        });
    };
    const auto letters = std::count_if(group.boxes.begin(), group.boxes.end(), has_neighbour);
    return static_cast<double>(letters) > kMost * static_cast<double>(group.boxes.size());
}

std::vector<cv::Point> places_in(const cv::Mat& mask) {
    std::vector<cv::Point> places;
    if (cv::countNonZero(mask) > 0) cv::findNonZero(mask, places);
    return places;
}

double middle_level(const cv::Mat& share, const std::vector<cv::Point>& places) {
    std::vector<std::uint8_t> levels;
    for (const cv::Point& p : places) levels.push_back(share.at<std::uint8_t>(p));
    const auto middle = levels.begin() + static_cast<std::ptrdiff_t>(levels.size() / 2);
    std::nth_element(levels.begin(), middle, levels.end());
    return *middle;
}

// What half of them have in each pixel: lines that they are on go different ways.
cv::Mat typical_share(const std::vector<cv::Mat>& shares) {
    cv::Mat typical(shares.front().size(), CV_8U);
    std::vector<std::uint8_t> levels(shares.size());
    for (int y = 0; y < typical.rows; ++y)
        for (int x = 0; x < typical.cols; ++x) {
            for (std::size_t i = 0; i < shares.size(); ++i) levels[i] = shares[i].at<std::uint8_t>(y, x);
            std::nth_element(levels.begin(), levels.begin() + levels.size() / 2, levels.end());
            typical.at<std::uint8_t>(y, x) = levels[levels.size() / 2];
        }
    return typical;
}

// As if clear ink were not.
Image without_clear_ink(const cv::Mat& share) {
    const std::vector<cv::Point> body = places_in(share > 100);
    const cv::Mat full = body.empty() ? share.clone() : cv::Mat(share * (255 / std::max(1.0, middle_level(share, body))));
    return {full.cols, full.rows, 1, 0, {full.begin<std::uint8_t>(), full.end<std::uint8_t>()}};
}

// What most of them have. A thin line lies now in one pixel, now in the next: then what half of them have.
std::vector<cv::Point> sure_pixels(const MarkGroup& group, std::vector<cv::Point> body, bool thin) {
    constexpr double kSure = 0.8;
    if (!thin)
        std::erase_if(body, [&](const cv::Point& p) {
            const auto with = std::count_if(group.shares.begin(), group.shares.end(),
                                            [&](const cv::Mat& share) { return share.at<std::uint8_t>(p) > 127; });
            return static_cast<double>(with) < kSure * static_cast<double>(group.shares.size());
        });
    return body;
}

// Nothing if no plotting tool draws points so.
std::optional<MarkKind> kind_of(const MarkGroup& group) {
    constexpr double kThin = 0.22;  // of its size
    const cv::Mat typical = typical_share(group.shares), body = typical > 140;
    const auto shape = mark_form_of(without_clear_ink(typical));
    if (!shape || cv::countNonZero(body) == 0) return std::nullopt;
    MarkKind kind{group.first.colour, *shape, body.cols, body.rows, 0, 0, false, false, {}, {}, {}};
    cv::Mat deep, hull = cv::Mat::zeros(body.size(), CV_8U);
    cv::distanceTransform(body, deep, cv::DIST_L2, cv::DIST_MASK_PRECISE);
    cv::minMaxLoc(deep, nullptr, &kind.depth);
    const cv::Rect box = cv::boundingRect(body);
    kind.radius = std::max(box.width, box.height) / 2.0;
    kind.thin = kind.depth <= kThin * 2 * kind.radius;
    const std::vector<cv::Point> all = places_in(body);
    kind.body = steps_to(sure_pixels(group, all, kind.thin));
    if (kind.body.empty()) return std::nullopt;
    std::vector<cv::Point> corners;
    cv::convexHull(all, corners);
    cv::fillConvexPoly(hull, corners, cv::Scalar(255));
    kind.around = steps_to(places_in(spread(body | hull, 2) & ~spread(body, 1)));
    std::vector<std::vector<cv::Point>> rings;
    cv::findContours(spread(hull, 2), rings, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
    kind.hull = steps_to(rings.front());
    return kind;
}

// Discs of that radius, and what is made of them; empty if there are none. `deep`: how far each pixel is from the ground.
cv::Mat thicker_than(const cv::Mat& deep, double radius) {
    const cv::Mat middles = deep > radius;
    if (cv::countNonZero(middles) == 0) return {};
    cv::Mat away;
    cv::distanceTransform(~middles, away, cv::DIST_L2, cv::DIST_MASK_5);
    return (away < radius) & (deep > 0);
}

// A kind may be known once whole and once without the lines that it is on.
bool is_known(const MarkKind& kind, const std::vector<MarkKind>& kinds) {
    constexpr double kSameRadius = 1.5;  // pixels
    return std::any_of(kinds.begin(), kinds.end(), [&](const MarkKind& other) {
        return other.shape == kind.shape && channels_apart(other.colour, kind.colour) <= kMarkColour &&
               std::abs(other.radius - kind.radius) <= kSameRadius;
    });
}

}  // namespace

std::vector<MarkKind> mark_kinds_in(const Image& picture, const Image& ink, double least, double most) {
    constexpr double kMostOfLines = 0.9;
    if (most < least) return {};         // pixels are too large for marks
    constexpr int kLines[] = {9, 7, 5};  // pixels: what is not wider is taken off for a line
    const cv::Mat black = view_of(ink) < kInkOfMarks;
    std::vector<MarkSeed> seeds;
    cv::Mat known = cv::Mat::zeros(black.size(), CV_8U);
    add_seeds(picture, ink, black, 1, least, most, known, seeds);
    cv::Mat deep;
    cv::distanceTransform(black, deep, cv::DIST_L2, cv::DIST_MASK_5);
    for (const int line : kLines)
        if (const cv::Mat thick = thicker_than(deep, line / 2.0); !thick.empty())
            add_seeds(picture, ink, thick, kMarkMargin - 1, std::max<double>(least, line + 3), most, known, seeds);
    cv::Mat labels, stats, middles;
    const int count = cv::connectedComponentsWithStats(black, labels, stats, middles, 8, CV_32S);
    std::vector<cv::Rect> pieces;
    for (int i = 1; i < count && pieces.size() < kMostSeeds; ++i) pieces.push_back(box_of_piece(stats, i));
    std::vector<MarkKind> kinds;
    for (const MarkGroup& group : groups_among(seeds)) {
        if (is_print(group, pieces)) continue;
        auto kind = kind_of(group);
        if (kind && !is_known(*kind, kinds) && !(kind->thin && 2 * kind->radius > kMostOfLines * most))
            kinds.push_back(std::move(*kind));
    }
    for (MarkKind& kind : kinds_on_lines(picture, ink, least, kMostOfLines * most))
        if (!is_known(kind, kinds)) kinds.push_back(std::move(kind));
    if (kinds.size() > kMostKinds) kinds.clear();
    return kinds;
}

}  // namespace tactics
