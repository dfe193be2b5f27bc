// SPDX-License-Identifier: Apache-2.0
#include "filters/open_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "filters/opencv.h"
#include "filters/outline_lines.h"
#include "tactics/geometry/shape.h"

namespace tactics {

namespace {

// How far each place of a drawing is from its lines, on pixels.
class InkRoom {
public:
    InkRoom(int width, int height, double mm)
        : width_(width), height_(height), mm_(mm), free_(height, width, CV_8U, cv::Scalar(1)) {}

    // Points of a line, in mm.
    void draw(const std::vector<Point>& points, bool closed) {
        for (std::size_t i = 0; i + (closed ? 0 : 1) < points.size(); ++i) {
            const Point a = points[i], b = points[(i + 1) % points.size()];
            const int steps = std::max(1, static_cast<int>(std::ceil(2 * distance(a, b) / mm_)));
            for (int k = 0; k <= steps; ++k)
                free_.at<std::uint8_t>(row(a.y + (b.y - a.y) * k / steps), column(a.x + (b.x - a.x) * k / steps)) = 0;
        }
    }

    void measure() { cv::distanceTransform(free_, away_, cv::DIST_L2, cv::DIST_MASK_PRECISE); }

    // mm from the nearest line.
    double away(Point p) const {
        return away_.empty() ? width_ + height_ : static_cast<double>(away_.at<float>(row(p.y), column(p.x))) * mm_;
    }

    double from_frame(Point p) const { return std::min({p.x, p.y, width_ * mm_ - p.x, height_ * mm_ - p.y}); }

private:
    int column(double x) const { return std::clamp(static_cast<int>(x / mm_), 0, width_ - 1); }
    int row(double y) const { return std::clamp(static_cast<int>(y / mm_), 0, height_ - 1); }

    int width_, height_;
    double mm_;
    cv::Mat free_, away_;
};

// The longest run of a line that keeps apart from what is drawn; its ends are led on to what they come near.
struct LineCut {
    std::vector<Point> points;
    double apart = 0;  // mm of it that keep apart
    int attached = 0;  // ends
};

// Where to go on from the end of a run, in the order of the way, until a line or the frame is met: along the line itself and what
// it leads to, but not beside another for long, then straight on for no more than the gap. Empty if nothing is met.
std::vector<Point> way_to_line(const InkRoom& room, const std::vector<Point>& points, std::size_t end, int step, double gap,
                               double touches) {
    constexpr std::ptrdiff_t kBack = 8;  // points that tell the direction
    const auto size = static_cast<std::ptrdiff_t>(points.size());
    std::vector<Point> way{points[end]};
    Point ahead{};
    double straight = 0, beside = 0;
    for (auto i = static_cast<std::ptrdiff_t>(end) + step; straight < gap && beside < 2 * gap; i += step) {
        const Point at = way.back();
        if (way.size() > 1 && (room.away(at) < touches || room.from_frame(at) < touches)) return way;
        if (i >= 0 && i < size) {
            way.push_back(points[static_cast<std::size_t>(i)]);
            if (room.away(at) < gap || room.from_frame(at) < gap) beside += distance(at, way.back());
            continue;
        }
        if (straight == 0) {
            const Point from = points[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(i - step * (kBack + 1), 0, size - 1))];
            const double far = std::max(distance(from, at), 1e-9);
            ahead = {(at.x - from.x) / far * touches / 2, (at.y - from.y) / far * touches / 2};
        }
        way.push_back({at.x + ahead.x, at.y + ahead.y});
        straight += touches / 2;
    }
    return {};
}

// `leads`: as of a RegionLine.
LineCut cut_apart(const InkRoom& room, const std::vector<Point>& points, std::array<std::size_t, 2> leads, bool lead, double gap,
                  double touches) {
    std::size_t best = 0, length = 0;
    const std::size_t last = points.size() - leads[1];
    for (std::size_t i = leads[0], end; i < last; i = end + 1) {
        for (end = i; end < last && room.away(points[end]) >= gap && room.from_frame(points[end]) >= gap;) ++end;
        if (end - i > length) {
            best = i;
            length = end - i;
        }
    }
    if (length < 2) return {};
    const auto first = points.begin() + static_cast<std::ptrdiff_t>(best);
    std::vector<Point> run(first, first + static_cast<std::ptrdiff_t>(length));
    const double apart = length_of(run, false);
    if (!lead) return {std::move(run), apart, 0};
    const std::vector<Point> before = way_to_line(room, points, best, -1, gap, touches);
    const std::vector<Point> after = way_to_line(room, points, best + length - 1, 1, gap, touches);
    LineCut cut{{}, apart, (before.empty() ? 0 : 1) + (after.empty() ? 0 : 1)};
    if (!before.empty()) cut.points.assign(before.rbegin(), before.rend() - 1);
    cut.points.insert(cut.points.end(), run.begin(), run.end());
    if (!after.empty()) cut.points.insert(cut.points.end(), after.begin() + 1, after.end());
    return cut;
}

// Whether a line goes on where another ends; then it is lengthened by that.
bool lengthens(Stroke& stroke, const Stroke& by, double touches) {
    if (stroke.closed || stroke.line != by.line || stroke.points.empty() || by.points.empty()) return false;
    const auto near = [&](Point a, Point b) { return distance(a, b) <= touches; };
    std::vector<Point> more = by.points;
    std::vector<Point>& points = stroke.points;
    if (near(points.front(), more.front()) || near(points.front(), more.back())) std::reverse(points.begin(), points.end());
    if (near(points.back(), more.back())) std::reverse(more.begin(), more.end());
    if (!near(points.back(), more.front())) return false;
    points.insert(points.end(), more.begin() + 1, more.end());
    return true;
}

}  // namespace

void add_open_lines(Drawing& drawing, std::span<const RegionLine> lines, double mm_per_pixel, const OpenLines& wish) {
    if (drawing.strokes.empty() || lines.empty()) return;
    InkRoom room(static_cast<int>(std::lround(drawing.width / mm_per_pixel)),
                 static_cast<int>(std::lround(drawing.height / mm_per_pixel)), mm_per_pixel);
    for (const Stroke& stroke : drawing.strokes) room.draw(stroke.points, stroke.closed);
    room.measure();
    struct Smooth {
        double worth;
        std::vector<Point> points;  // mm
        const RegionLine* line;
    };
    std::vector<Smooth> smooth;
    for (const RegionLine& line : lines) {
        if (line.strength < wish.least) continue;
        std::vector<Point> points = rounded(line.points, false, wish.bend / mm_per_pixel);
        for (Point& p : points)
            p = {std::clamp(p.x * mm_per_pixel, 0.0, drawing.width), std::clamp(p.y * mm_per_pixel, 0.0, drawing.height)};
        smooth.push_back({static_cast<double>(line.strength) * length_of(points, false), std::move(points), &line});
    }
    std::stable_sort(smooth.begin(), smooth.end(), [](const Smooth& a, const Smooth& b) { return a.worth > b.worth; });
    double left = wish.most;
    for (const auto& [worth, points, line] : smooth) {
        LineCut cut = cut_apart(room, points, line->leads, wish.attached, wish.gap, mm_per_pixel);
        const double length = length_of(cut.points, false);
        // What joins two lines leads somewhere, however short.
        const double shortest = cut.attached == 2 ? wish.shortest / 2 : wish.shortest;
        if (cut.apart < shortest || (cut.attached > 0) != wish.attached || length > left) continue;
        left -= length;
        room.draw(cut.points, false);
        room.measure();
        Stroke stroke;
        stroke.line = LineClass::thin;
        stroke.strength = line->strength;
        stroke.points = std::move(cut.points);
        if (std::none_of(drawing.strokes.begin(), drawing.strokes.end(),
                         [&](Stroke& before) { return lengthens(before, stroke, 2 * mm_per_pixel); }))
            drawing.strokes.push_back(std::move(stroke));
    }
}

}  // namespace tactics
