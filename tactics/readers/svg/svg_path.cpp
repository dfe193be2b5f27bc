// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/svg/svg_path.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tactics/geometry/shape.h"
#include "tactics/readers/svg/svg_numbers.h"

namespace tactics {

namespace {

constexpr double kTrue = 0.01;         // mm
constexpr double kMostPerCurve = 500;  // points

Point between(Point a, Point b, double t) { return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}; }

void close_ring(Subpath& subpath) {
    subpath.closed = true;
    const Point first = subpath.points.front(), end = subpath.points.back();
    if (subpath.points.size() > 1 && distance(first, end) < 1e-9) subpath.points.pop_back();
}

}  // namespace

void Pen::add(Point p) {
    at_ = p;
    if (!drawing_) {
        subpaths_.push_back({{transform_(start_)}, false});
        drawing_ = true;
    }
    subpaths_.back().points.push_back(transform_(p));
}

void Pen::move(Point p) {
    at_ = start_ = p;
    drawing_ = false;
}

void Pen::line(Point p) { add(p); }

void Pen::curve(Point one, Point other, Point end) {
    const Point a = transform_(at_), b = transform_(one), c = transform_(other), d = transform_(end);
    // The distance of a cubic from its chords is at most 3/4 of its greatest second difference, divided by their number squared.
    const auto bend = [](Point p, Point q, Point r) { return std::hypot(p.x - 2 * q.x + r.x, p.y - 2 * q.y + r.y); };
    const double wanted = std::ceil(std::sqrt(0.75 * std::max(bend(a, b, c), bend(b, c, d)) / kTrue));
    const double count = std::clamp(std::isfinite(wanted) ? wanted : 1.0, 1.0, kMostPerCurve);
    const Point from = at_;
    for (double i = 1; i <= count; ++i) {
        const double t = i / count;
        const Point p = between(from, one, t), q = between(one, other, t), r = between(other, end, t);
        add(i == count ? end : between(between(p, q, t), between(q, r, t), t));
    }
}

// SVG 1.1, appendix F.6: from two ends to the middle; then cubic curves of at most a quarter turn.
void Pen::arc(double rx, double ry, double degrees, bool large, bool sweep, Point end) {
    const Point from = at_;
    rx = std::abs(rx);
    ry = std::abs(ry);
    if (!(rx > 0) || !(ry > 0) || (from.x == end.x && from.y == end.y)) return line(end);
    const double phi = degrees * std::numbers::pi / 180, cosine = std::cos(phi), sine = std::sin(phi);
    const double hx = (from.x - end.x) / 2, hy = (from.y - end.y) / 2;
    const double x = cosine * hx + sine * hy, y = -sine * hx + cosine * hy;
    const double stretch = x * x / (rx * rx) + y * y / (ry * ry);
    if (stretch > 1) {
        rx *= std::sqrt(stretch);
        ry *= std::sqrt(stretch);
    }
    const double below = rx * rx * y * y + ry * ry * x * x;
    double root = below > 0 ? std::sqrt(std::max(0.0, rx * rx * ry * ry / below - 1)) : 0;
    if (large == sweep) root = -root;
    const double mx = root * rx * y / ry, my = -root * ry * x / rx;
    const Point middle{cosine * mx - sine * my + (from.x + end.x) / 2, sine * mx + cosine * my + (from.y + end.y) / 2};
    const double begin = std::atan2((y - my) / ry, (x - mx) / rx);
    double turn = std::atan2((-y - my) / ry, (-x - mx) / rx) - begin;
    if (!std::isfinite(begin) || !std::isfinite(turn)) return line(end);
    if (sweep && turn < 0) turn += 2 * std::numbers::pi;
    if (!sweep && turn > 0) turn -= 2 * std::numbers::pi;
    const int parts = std::max(1, static_cast<int>(std::ceil(std::abs(turn) / (std::numbers::pi / 2) - 1e-9)));
    const double part = turn / parts, handle = 4.0 / 3 * std::tan(part / 4);
    const auto point = [&](double u, double v) {
        return Point{middle.x + cosine * rx * u - sine * ry * v, middle.y + sine * rx * u + cosine * ry * v};
    };
    for (int i = 0; i < parts; ++i) {
        const double a = begin + i * part, b = a + part;
        curve(point(std::cos(a) - handle * std::sin(a), std::sin(a) + handle * std::cos(a)),
              point(std::cos(b) + handle * std::sin(b), std::sin(b) - handle * std::cos(b)),
              i + 1 == parts ? end : point(std::cos(b), std::sin(b)));
    }
}

void Pen::close() {
    if (drawing_) close_ring(subpaths_.back());
    at_ = start_;
    drawing_ = false;
}

std::vector<Subpath> Pen::finish() { return std::move(subpaths_); }

namespace {

// Reads the data of a path, one command with all its numbers after the other.
class PathReader {
public:
    PathReader(std::string_view data, Pen& pen) : data_(data), rest_(data), pen_(pen) {}

    std::optional<std::size_t> run() {
        char command = 0;
        for (;;) {
            while (!rest_.empty() && is_svg_blank(rest_[0])) rest_.remove_prefix(1);
            if (rest_.empty()) return std::nullopt;
            const char letter = rest_[0];
            const bool is_letter = (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z');
            if (is_letter) {
                command = letter;
                rest_.remove_prefix(1);
            } else if (command == 0 || command == 'z' || command == 'Z') {
                return data_.size() - rest_.size();
            }
            if (!moved_ && command != 'm' && command != 'M') return data_.size() - rest_.size();
            if (!step(command)) return data_.size() - rest_.size();
            // More numbers after a move are lines.
            if (command == 'm') command = 'l';
            if (command == 'M') command = 'L';
        }
    }

private:
    bool number(double& value) {
        const auto found = take_svg_number(rest_);
        if (found) value = *found;
        return found.has_value();
    }
    bool point(Point& p) {
        if (!number(p.x) || !number(p.y)) return false;
        if (relative_) p = {p.x + pen_.at().x, p.y + pen_.at().y};
        return true;
    }

    bool step(char letter) {
        relative_ = letter >= 'a';
        const char command = relative_ ? letter : static_cast<char>(letter - 'A' + 'a');
        Point p;
        switch (command) {
            case 'c': return point(p) && cubic(p);
            case 's': return cubic(mirrored('c'));
            case 'q': return point(p) && quadratic(p);
            case 't': return quadratic(mirrored('q'));
            case 'm':
                if (!point(p)) return false;
                pen_.move(p);
                moved_ = true;
                break;
            case 'z': pen_.close(); break;
            case 'l':
                if (!point(p)) return false;
                pen_.line(p);
                break;
            case 'h':
                if (!number(p.x)) return false;
                pen_.line({relative_ ? p.x + pen_.at().x : p.x, pen_.at().y});
                break;
            case 'v':
                if (!number(p.y)) return false;
                pen_.line({pen_.at().x, relative_ ? p.y + pen_.at().y : p.y});
                break;
            case 'a':
                if (!arc()) return false;
                break;
            default: return false;
        }
        last_curve_ = 0;
        return true;
    }

    // Where a curve's first handle is that goes on smoothly from the last one, if that was of its kind.
    Point mirrored(char of) const {
        if (last_curve_ != of) return pen_.at();
        return {2 * pen_.at().x - handle_.x, 2 * pen_.at().y - handle_.y};
    }
    bool cubic(Point first) {
        Point second, end;
        if (!point(second) || !point(end)) return false;
        pen_.curve(first, second, end);
        handle_ = second;
        last_curve_ = 'c';
        return true;
    }
    bool quadratic(Point handle) {
        Point end;
        if (!point(end)) return false;
        const Point from = pen_.at();
        pen_.curve(between(from, handle, 2.0 / 3), between(end, handle, 2.0 / 3), end);
        handle_ = handle;
        last_curve_ = 'q';
        return true;
    }
    bool arc() {
        double rx = 0, ry = 0, degrees = 0;
        if (!number(rx) || !number(ry) || !number(degrees)) return false;
        const auto large = take_svg_flag(rest_), sweep = large ? take_svg_flag(rest_) : std::nullopt;
        Point end;
        if (!sweep || !point(end)) return false;
        pen_.arc(rx, ry, degrees, *large, *sweep, end);
        return true;
    }

    std::string_view data_, rest_;
    Pen& pen_;
    Point handle_;
    char last_curve_ = 0;  // the command that handle_ is of; 0: the last one was no curve
    bool relative_ = false;
    bool moved_ = false;
};

// Takes that much off the end of a line of at least two points.
void shorten(std::vector<Point>& points, double by) {
    while (points.size() > 2 && distance(points[points.size() - 2], points.back()) <= by) {
        by -= distance(points[points.size() - 2], points.back());
        points.pop_back();
    }
    const Point from = points[points.size() - 2], end = points.back();
    const double side = distance(from, end), keep = side > 0 ? std::max(0.0, 1 - by / side) : 1;
    points.back() = {from.x + (end.x - from.x) * keep, from.y + (end.y - from.y) * keep};
}

}  // namespace

std::optional<std::size_t> draw_path(std::string_view data, Pen& pen) { return PathReader(data, pen).run(); }

void draw_ellipse(Point middle, double rx, double ry, Pen& pen) {
    const Point right{middle.x + rx, middle.y}, left{middle.x - rx, middle.y};
    pen.move(right);
    pen.arc(rx, ry, 0, false, true, left);
    pen.arc(rx, ry, 0, false, true, right);
    pen.close();
}

void draw_rectangle(double x, double y, double width, double height, double rx, double ry, Pen& pen) {
    rx = std::clamp(rx, 0.0, width / 2);
    ry = std::clamp(ry, 0.0, height / 2);
    const auto corner = [&](double px, double py) {
        if (rx > 0 && ry > 0) pen.arc(rx, ry, 0, false, true, {px, py});
    };
    pen.move({x + rx, y});
    pen.line({x + width - rx, y});
    corner(x + width, y + ry);
    pen.line({x + width, y + height - ry});
    corner(x + width - rx, y + height);
    pen.line({x + rx, y + height});
    corner(x, y + height - ry);
    if (ry > 0)
        pen.line({x, y + ry});
    else
        pen.line({x, y});
    corner(x + rx, y);
    pen.close();
}

bool draw_points(std::string_view points, bool closed, Pen& pen) {
    for (bool first = true; !without_svg_blanks(points).empty(); first = false) {
        const auto x = take_svg_number(points), y = x ? take_svg_number(points) : std::nullopt;
        if (!y) return false;
        if (first)
            pen.move({*x, *y});
        else
            pen.line({*x, *y});
    }
    if (closed) pen.close();
    return true;
}

void cut_flat_ends(std::vector<Point>& points, double width) {
    if (length_of(points, false) <= 2 * width) return;
    for (int end = 0; end < 2; ++end) {
        shorten(points, width / 2);
        std::reverse(points.begin(), points.end());
    }
}

double size_of(const std::vector<Subpath>& subpaths) {
    double largest = 0;
    for (const Subpath& subpath : subpaths)
        for (const Point& p : subpath.points) largest = std::max(largest, distance(p, subpath.points.front()));
    return largest;
}

void close_rings(std::vector<Subpath>& subpaths) {
    for (Subpath& subpath : subpaths)
        if (!subpath.closed && subpath.points.size() >= 3) close_ring(subpath);
}

std::vector<std::vector<Point>> rings_of(const std::vector<Subpath>& subpaths) {
    std::vector<std::vector<Point>> rings;
    for (const Subpath& subpath : subpaths)
        if (subpath.points.size() >= 3) rings.push_back(subpath.points);
    return rings;
}

}  // namespace tactics
