#include "tactics/pages/figure.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "tactics/course.h"

namespace tactics {

namespace {

constexpr double kTolerance = 0.1;  // mm; half of what a fingertip feels of a step aside in a line, and less than a printer's dots
// A line's class against the widest that is common. A setting.
// Plotting tools draw data about twice as wide as axes, and no finger is to take the few error bars for beams.
constexpr double kThin = 0.7, kThick = 2.1;

// The widest of which there is at least a tenth of all line.
double common_width(const FoundPage& figure) {
    std::map<long, double> lengths;  // by hundredths of a millimetre
    double all = 0;
    for (const PageStroke& stroke : figure.page.strokes) {
        const double length = length_of(Stroke{stroke.points, stroke.closed});
        lengths[std::lround(stroke.width * 100)] += length;
        all += length;
    }
    for (auto width = lengths.rbegin(); width != lengths.rend(); ++width)
        if (width->second >= all / 10) return static_cast<double>(width->first) / 100;
    return 0;
}

std::vector<Point> scaled(const std::vector<Point>& points, double scale) {
    std::vector<Point> out;
    for (const Point& p : points) {
        const Point q{p.x * scale, p.y * scale};
        if (out.empty() || distance(out.back(), q) > 1e-6) out.push_back(q);
    }
    return out;
}

std::vector<Point> simplified(const std::vector<Point>& points) {
    if (points.size() < 3) return points;
    std::vector<bool> keep(points.size(), false);
    keep.front() = keep.back() = true;
    keep_course(points, 0, points.size() - 1, kTolerance, keep);
    std::vector<Point> out;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (keep[i]) out.push_back(points[i]);
    return out;
}

}  // namespace

Drawing drawing_of_figure(const FoundPage& figure, double width) {
    const double scale = width / figure.page.width, common = common_width(figure);
    Drawing drawing;
    drawing.width = width;
    drawing.height = figure.page.height * scale;
    for (const PageStroke& stroke : figure.page.strokes) {
        Stroke line;
        std::vector<Point> points = scaled(stroke.points, scale);
        line.closed = stroke.closed;
        if (line.closed && points.size() > 1) points.push_back(points.front());
        line.points = simplified(points);
        if (line.closed && line.points.size() > 1) line.points.pop_back();
        if (line.points.size() < 3) line.closed = false;
        if (line.points.size() < 2) continue;
        line.line = stroke.width < kThin * common ? LineClass::thin : stroke.width > kThick * common ? LineClass::thick : LineClass::normal;
        line.role = stroke.role;
        // A surface with a line around it, a frame drawn twice: the same line felt once.
        const bool twice = std::any_of(drawing.strokes.begin(), drawing.strokes.end(), [&](const Stroke& other) {
            return other.points.size() == line.points.size() && other.closed == line.closed &&
                   std::equal(line.points.begin(), line.points.end(), other.points.begin(), [](Point a, Point b) { return distance(a, b) < 0.01; });
        });
        if (!twice) drawing.strokes.push_back(std::move(line));
    }
    for (const auto* areas : {&figure.page.areas, &figure.page.textured})
        for (const Area& area : *areas) {
            Area moved = area;
            moved.rings.clear();
            for (const auto& ring : area.rings)
                if (auto points = scaled(ring, scale); points.size() > 2) moved.rings.push_back(std::move(points));
            if (!moved.rings.empty()) drawing.areas.push_back(std::move(moved));
        }
    return drawing;
}

}  // namespace tactics
