// SPDX-License-Identifier: Apache-2.0
// The shapes of SVG as points.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "tactics/readers/svg/transform.h"

namespace tactics {

struct Subpath {
    std::vector<Point> points;  ///< a closed one does not repeat its first point
    bool closed = false;
};

/// Draws with moves, lines and curves, through a transform, into points no further than 0.01 mm from the true curve, if the
/// transform gives mm.
class Pen {
public:
    explicit Pen(const Transform& transform) : transform_(transform) {}

    void move(Point p);
    void line(Point p);
    void curve(Point one, Point other, Point end);
    void arc(double rx, double ry, double degrees, bool large, bool sweep, Point end);
    void close();

    Point at() const { return at_; }
    /// Every subpath has at least one point; one of a single point was a mere move or a line of no length.
    std::vector<Subpath> finish();

private:
    void add(Point p);

    Transform transform_;
    std::vector<Subpath> subpaths_;
    Point at_, start_;
    bool drawing_ = false;  // the last subpath takes more points
};

/// The attribute d of a path. Gives where in it the first fault is, or nothing.
std::optional<std::size_t> draw_path(std::string_view data, Pen& pen);
void draw_ellipse(Point middle, double rx, double ry, Pen& pen);
void draw_rectangle(double x, double y, double width, double height, double rx, double ry, Pen& pen);
/// The attribute points of a polyline or polygon. Gives false if it is not pairs of numbers.
bool draw_points(std::string_view points, bool closed, Pen& pen);

/// Those that have an inside: three points or more.
std::vector<std::vector<Point>> rings_of(const std::vector<Subpath>& subpaths);
/// A surface ends at a closed line, whether its path says so or not.
void close_rings(std::vector<Subpath>& subpaths);
/// How far its farthest point is from its first: about as large as it is.
double size_of(const std::vector<Subpath>& subpaths);
/// A page's lines have round ends: cut back by half its width, an open line with flat ends ends where these were. A line that is
/// too short for that stays.
void cut_flat_ends(std::vector<Point>& points, double width);

}  // namespace tactics
