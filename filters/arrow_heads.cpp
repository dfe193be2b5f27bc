// SPDX-License-Identifier: Apache-2.0
#include "filters/arrow_heads.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "filters/opencv.h"
#include "filters/pixel_graph.h"

namespace tactics {

namespace {

constexpr int kInkOfHeads = 160;
constexpr std::size_t kMostEnds = 20000;
constexpr double kShortestBarb = 5;  // pixels of a barb; smaller heads are specks
constexpr std::array kAngles{12.0, 14.5, 17.0, 19.5, 22.0, 25.0, 28.0, 32.0, 37.0, 45.0};  // of a barb and its line, degrees

Point moved(Point p, Point along, double by) { return {p.x + along.x * by, p.y + along.y * by}; }
Point turned(Point v, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return {v.x * c - v.y * s, v.x * s + v.y * c};
}

// What each place is to the ink, asked millions of times: of how far off it is only these three answers are wanted, so that one
// byte of them is kept for each pixel.
class InkField {
public:
    explicit InkField(const Image& ink) : width_(ink.width), height_(ink.height) {
        const cv::Mat dark = view_of(ink) < kInkOfHeads;
        cv::distanceTransform(dark, deep_, cv::DIST_L2, cv::DIST_MASK_PRECISE);
        cv::Mat beside, around;
        cv::dilate(dark, beside, cv::getStructuringElement(cv::MORPH_CROSS, cv::Size(3, 3)));
        cv::dilate(dark, around, cv::getStructuringElement(cv::MORPH_RECT, cv::Size(3, 3)));
        near_ = (dark & cv::Scalar(kInk)) | (beside & cv::Scalar(kBeside)) | (around & cv::Scalar(kAround));
    }

    // How far inside the ink.
    double deep(Point p) const {
        const auto [x, y] = pixel_at(p);
        return x < 0 ? 0 : static_cast<double>(deep_.at<float>(y, x));
    }
    bool ink(Point p) const { return is(p, kInk); }
    // No pixel off it, or one to the left, the right, above or below; or also aslant. Nothing is outside the picture.
    bool beside_ink(Point p) const { return is(p, kBeside); }
    bool around_ink(Point p) const { return is(p, kAround); }

private:
    static constexpr std::uint8_t kInk = 1, kBeside = 2, kAround = 4;

    struct Pixel {
        int x = -1, y = -1;
    };
    // -1: outside.
    Pixel pixel_at(Point p) const {
        if (!(p.x >= 0) || !(p.y >= 0) || p.x >= width_ || p.y >= height_) return {};
        return {static_cast<int>(p.x), static_cast<int>(p.y)};
    }
    bool is(Point p, std::uint8_t what) const {
        const auto [x, y] = pixel_at(p);
        return x >= 0 && (near_.at<std::uint8_t>(y, x) & what) != 0;
    }

    int width_, height_;
    cv::Mat near_, deep_;
};

struct HeadFit {
    InkedHead head;
    double quality = 0;
};

// One end of a line: whether a head is on it, of any size and angle.
class HeadSearch {
public:
    // `line`: how long the line is, in pixels. Most of it is no head.
    HeadSearch(const InkField& ink, double longest, double line)
        : ink_(ink), longest_(std::min({longest, 0.75 * line, line - 6})) {}

    // `ahead`: the direction of the line at its end, of length 1.
    std::optional<HeadFit> at_end(Point end, Point ahead, double shaft) {
        best_ = std::nullopt;
        ahead_ = ahead;
        side_ = {-ahead.y, ahead.x};
        shaft_ = shaft;
        for (std::size_t i = 0; i < kAngles.size(); ++i) {
            const double angle = kAngles[i] * std::numbers::pi / 180;
            const Point back{-ahead.x, -ahead.y};
            spreads_[i] = {turned(back, angle), turned(back, -angle), std::sin(angle), std::cos(angle)};
        }
        // The thinned line may stop before the tip of a filled head, or go on into what the head touches.
        const double back = std::min(longest_, 6.0 + shaft), on = longest_;
        for (double along = -back; along <= on; along += 1) {
            const Point middle = moved(end, ahead, along);
            if (along > 0 && !ink_.ink(middle)) break;
            for (const double beside : {0.0, -1.0, 1.0}) try_tip(moved(middle, side_, beside));
        }
        return best_;
    }

private:
    // A line goes on from the end of a barb.
    bool goes_on_from(Point end, Point barb) const {
        for (const double degrees : {-50.0, -25.0, 0.0, 25.0, 50.0}) {
            const Point way = turned(barb, degrees * std::numbers::pi / 180);
            if (ink_.beside_ink(moved(end, way, 2.5)) && ink_.beside_ink(moved(end, way, 4.5))) return true;
        }
        return false;
    }

    // How far the ink reaches to one side, so far behind the tip, seen from outside.
    double reach(Point tip, double behind, double sign, double from) const {
        const Point middle = moved(tip, ahead_, -behind);
        double out = from;
        while (out > 0 && !ink_.ink(moved(middle, side_, sign * out))) out -= 0.5;
        return out;
    }

    // Its sides are straight, as far out on the left as on the right, and nothing is close outside. Gives how far off they are.
    std::optional<double> off_sides(Point tip, double neck, double half) const {
        constexpr double kMostOff = 1.3, kOutside = 2.2;
        double off = 0;
        for (const double share : {0.4, 0.6, 0.75, 0.9})
            for (const double sign : {-1.0, 1.0}) {
                const double wanted = share * half, found = reach(tip, share * neck, sign, wanted + kOutside);
                if (std::abs(found - wanted) > kMostOff) return std::nullopt;
                off += std::abs(found - wanted) / 8;
            }
        return off;
    }

    // Filled, or two strokes with white between each of them and the line.
    bool has_inside(Point tip, double neck, double half) const {
        for (const double sign : {-1.0, 1.0}) {
            const Point middle = moved(tip, ahead_, -0.8 * neck);
            const double outer = 0.8 * half, inner = shaft_ / 2;
            int white = 0, all = 0, changes = 0;
            bool before = true;
            for (double out = inner; out <= outer - 0.5; out += 0.5, ++all) {
                const bool ink = ink_.ink(moved(middle, side_, sign * out));
                white += ink ? 0 : 1;
                changes += ink != before ? 1 : 0;
                before = ink;
            }
            if (white > 0 && (changes > 2 || !before)) return false;  // more than a line and a stroke
        }
        return true;
    }

    // It is a line that comes from behind, and only a line.
    bool has_shaft(Point tip, double neck, double half) const {
        const double reach = std::max(4.0, 0.7 * neck);
        int on = 0, all = 0;
        for (double t = neck + 1; t <= neck + 1 + reach; t += 1, ++all) on += ink_.around_ink(moved(tip, ahead_, -t)) ? 1 : 0;
        if (on < 0.8 * all) return false;
        int beside = 0;
        for (const double sign : {-1.0, 1.0})
            for (const double t : {neck + 2.5, neck + 4.0})
                beside += ink_.ink(moved(moved(tip, ahead_, -t), side_, sign * std::max(0.7 * half, shaft_ / 2 + 1.5))) ? 1 : 0;
        return beside == 0;
    }

    // A line that only goes on is no end.
    bool goes_on(Point tip, double length) const {
        int on = 0, all = 0;
        for (double t = shaft_ + 3; t <= shaft_ + 3 + std::max(4.0, 0.6 * length); t += 1, ++all) {
            const Point at = moved(tip, ahead_, t);
            const double beside = shaft_ / 2 + 2.5;
            on += ink_.around_ink(at) && !ink_.ink(moved(at, side_, beside)) && !ink_.ink(moved(at, side_, -beside)) ? 1 : 0;
        }
        return on > 0.8 * all;
    }

    bool both_on_ink(Point tip, Point left, Point right, double length) const {
        return ink_.beside_ink(moved(tip, left, length)) && ink_.beside_ink(moved(tip, right, length));
    }

    void try_tip(Point tip) {
        if (!ink_.around_ink(tip)) return;
        for (const auto& [left, right, sine, cosine] : spreads_) {
            if (!both_on_ink(tip, left, right, kShortestBarb)) continue;  // as nearly all are, at once
            // How far both barbs go: they end at the same length.
            double length = 0;
            while (length < longest_ && both_on_ink(tip, left, right, length + 1)) length += 1;
            if (length < kShortestBarb || length >= longest_) continue;
            const double half = length * sine, neck = length * cosine;
            if (half < std::max(2.5, shaft_ / 2 + 1.8) || length < 1.6 * shaft_) continue;
            if (goes_on_from(moved(tip, left, length), left) || goes_on_from(moved(tip, right, length), right)) continue;
            const auto off = off_sides(tip, neck, half);
            if (!off || !has_inside(tip, neck, half) || !has_shaft(tip, neck, half) || goes_on(tip, length)) continue;
            // Of heads that fit, the one that explains most ink.
            const double quality = length / (0.5 + *off);
            if (best_ && quality <= best_->quality) continue;
            best_ = HeadFit{
                {tip, {moved(tip, left, length), moved(tip, right, length)}, moved(tip, ahead_, -neck), shaft_, false}, quality};
        }
    }

    const InkField& ink_;
    double longest_, shaft_ = 1;
    Point ahead_{}, side_{};
    struct Spread {
        Point left, right;  // the directions of the barbs
        double sine = 0, cosine = 0;
    };
    std::array<Spread, kAngles.size()> spreads_{};
    std::optional<HeadFit> best_;
};

// The place so far along a line from one of its ends.
Point place_on(const PixelChain& chain, bool from_last, std::size_t steps) {
    const std::size_t size = chain.points.size(), at = std::min(steps, size - 1);
    return chain.points[from_last ? size - 1 - at : at];
}

// Half of the ink's width in the middle of a line, as most of its places have it.
double width_of(const PixelChain& chain, const InkField& ink) {
    std::vector<double> deep;
    for (std::size_t i = 0; i < chain.points.size(); i += 1 + chain.points.size() / 32) deep.push_back(ink.deep(chain.points[i]));
    const auto half = deep.begin() + static_cast<std::ptrdiff_t>(deep.size() / 2);
    std::nth_element(deep.begin(), half, deep.end());
    return std::max(1.0, 2 * *half - 1);
}

// A course of a line near its end: where it is looked from, and which way it runs.
struct Course {
    Point at, ahead;
    // Nearly the same, so that no other head would be found.
    bool is_like(const Course& other) const {
        constexpr double kAngle = 0.02, kAside = 0.35;  // rad, pixels
        const Point way{at.x - other.at.x, at.y - other.at.y};
        return std::abs(ahead.x * other.ahead.y - ahead.y * other.ahead.x) < kAngle &&
               ahead.x * other.ahead.x + ahead.y * other.ahead.y > 0 &&
               std::abs(way.x * other.ahead.y - way.y * other.ahead.x) < kAside;
    }
};

void look_at_end(const PixelChain& chain, bool last, const PixelGraph& graph, const InkField& ink, double longest,
                 std::vector<HeadFit>& found) {
    constexpr std::array<std::size_t, 5> kBack{5, 9, 15, 24, 40};  // steps over which the direction is looked at
    const int junction = last ? chain.to : chain.from;
    const Point end = junction >= 0 ? graph.junctions[static_cast<std::size_t>(junction)].at : place_on(chain, last, 0);
    HeadSearch search(ink, longest, static_cast<double>(chain.points.size()));
    const double width = width_of(chain, ink);
    std::optional<HeadFit> best;
    std::vector<Course> tried;
    for (const std::size_t back : kBack) {
        // Near the end the line of a filled head is bent; farther back it is the shaft's.
        for (const std::size_t skip : {std::size_t{0}, back / 2}) {
            const Point near = skip == 0 ? end : place_on(chain, last, skip), from = place_on(chain, last, back + skip);
            const double length = distance(near, from);
            if (length < 3) continue;
            const Point ahead{(near.x - from.x) / length, (near.y - from.y) / length};
            const Course course{near, ahead};
            if (std::any_of(tried.begin(), tried.end(), [&](const Course& other) { return course.is_like(other); })) continue;
            tried.push_back(course);
            const auto fit = search.at_end(near, ahead, width);
            if (fit && (!best || fit->quality > best->quality)) best = fit;
        }
    }
    if (best) found.push_back(*best);
}

// With gaps of one pixel in thin lines closed: where a line and the head that was drawn behind it meet, the pixel that they share
// is pale.
Image with_seams_closed(const Image& ink) {
    constexpr int kPale = 225, kBesideLine = 5;  // a gap that somebody left is white; pixels off the middle of a line
    constexpr std::array<std::array<int, 2>, 4> kWays{{{0, 1}, {1, 0}, {1, 1}, {1, -1}}};
    const auto is_ink = [&](int x, int y) {
        return x >= 0 && y >= 0 && x < ink.width && y < ink.height && ink.row(y)[x] < kInkOfHeads;
    };
    const auto is_line = [&](int x, int y, int dx, int dy) {
        return is_ink(x, y) && !is_ink(x - kBesideLine * dy, y + kBesideLine * dx) &&
               !is_ink(x + kBesideLine * dy, y - kBesideLine * dx);
    };
    Image closed = ink;
    for (int y = 0; y < ink.height; ++y)
        for (int x = 0; x < ink.width; ++x) {
            if (ink.row(y)[x] >= kPale || is_ink(x, y)) continue;
            for (const auto& [dx, dy] : kWays)
                if (is_line(x - dx, y - dy, dx, dy) && is_line(x + dx, y + dy, dx, dy)) closed.row(y)[x] = 0;
        }
    return closed;
}

}  // namespace

std::vector<InkedHead> arrow_heads_in(const Image& given, double longest) {
    if (given.width < 2 * kShortestBarb || given.height < 2 * kShortestBarb || longest <= kShortestBarb) return {};
    const Image ink = with_seams_closed(given);
    Image black = make_image(ink.width, ink.height, 1, ink.mm_per_pixel, 255);
    std::size_t inked = 0;
    for (std::size_t i = 0; i < black.pixels.size(); ++i)
        if (ink.pixels[i] < kInkOfHeads) {
            black.pixels[i] = 0;
            ++inked;
        }
    if (2 * inked > black.pixels.size()) return {};  // a dark ground
    const InkField field(ink);
    Skeleton skeleton = thin(ink_of(black));
    const PixelGraph graph = graph_of(skeleton, 3);
    if (graph.chains.size() > kMostEnds / 2) return {};
    std::vector<HeadFit> found;
    for (const PixelChain& chain : graph.chains) {
        if (chain.closed || chain.points.size() < 12) continue;
        for (const bool last : {false, true}) look_at_end(chain, last, graph, field, longest, found);
    }
    std::stable_sort(found.begin(), found.end(), [](const HeadFit& a, const HeadFit& b) { return a.quality > b.quality; });
    std::vector<InkedHead> heads;
    for (const HeadFit& fit : found)
        if (std::none_of(heads.begin(), heads.end(), [&](const InkedHead& other) {
                return distance(other.tip, fit.head.tip) < std::max(other.length(), fit.head.length());
            }))
            heads.push_back(fit.head);
    return heads;
}

void take_out(Image& picture, const std::vector<InkedHead>& heads) {
    cv::Mat pixels = view_of(picture);
    const auto colour_at = [&](Point p) { return colour_near(picture, {static_cast<int>(p.x), static_cast<int>(p.y)}); };
    for (const InkedHead& head : heads) {
        const double length = distance(head.tip, head.neck);
        const Point ahead{(head.tip.x - head.neck.x) / length, (head.tip.y - head.neck.y) / length}, side{-ahead.y, ahead.x};
        const cv::Scalar line = colour_at(moved(head.neck, ahead, -2)),
                         ground = colour_at(moved(moved(head.tip, ahead, -0.6 * length), side, length));
        std::vector<cv::Point> ring{fine_point(moved(head.tip, side, 1.5 + head.shaft / 2)),
                                    fine_point(moved(head.tip, side, -1.5 - head.shaft / 2))};
        for (const Point& barb : head.barbs) {
            const double out = (barb.x - head.tip.x) * side.x + (barb.y - head.tip.y) * side.y > 0 ? 1 : -1;
            ring.push_back(fine_point(moved(moved(barb, side, out * 2.5), ahead, -2)));
        }
        std::vector<cv::Point> hull;
        cv::convexHull(ring, hull);
        cv::fillConvexPoly(pixels, hull, ground, cv::LINE_8, kFineShift);
        if (head.dashed) continue;
        cv::line(pixels, fine_point(moved(head.neck, ahead, -3)), fine_point(head.tip), line,
                 std::max(1, static_cast<int>(std::lround(head.shaft))), cv::LINE_8, kFineShift);
    }
}

}  // namespace tactics
