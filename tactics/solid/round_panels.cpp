// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/round_panels.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>

#include "tactics/solid/outline.h"

namespace tactics {

namespace {

constexpr int kRoundCorners = 48;
constexpr double kNarrower = 0.92;  // of the widest radius: the rim of an end that narrow has a line of its own
constexpr double kTip = 0.05;       // of the widest radius, below which an end is a point

using Ring = std::vector<Point3>;

Ring circle(const Point3& middle, const Point3& a, const Point3& b) {
    Ring ring;
    for (int i = 0; i < kRoundCorners; ++i) {
        const double angle = 2 * std::numbers::pi * i / kRoundCorners;
        ring.push_back(middle + std::cos(angle) * a + std::sin(angle) * b);
    }
    return ring;
}

double disc(double radius) { return std::numbers::pi * radius * radius; }

class RoundPanels {
public:
    RoundPanels(Panels& made, const ModelPart& part, std::uint32_t number, const ViewPlane& view)
        : made_(made), part_(part), round_(*part.round), number_(number), view_(view) {}

    void add() {
        if (round_.primitive == Primitive::sphere) return add_sphere();
        const Point3& axis = round_.axis;
        right_ = round_.handle;
        if (!round_.has_handle()) {
            right_ = view_.right - dot(view_.right, axis) * axis;
            if (length_of(right_) < 0.5) right_ = dot(view_.down, axis) * axis - view_.down;
            right_ = unit(right_);
        }
        away_ = cross(axis, right_);
        const auto high = static_cast<std::uint32_t>(made_.panels.size()), low = high + 1;
        add_end(true, low);
        add_end(false, high);
        for (const Point3& out : {-1 * away_, away_, right_, -1 * right_}) {
            // A section shows the handle.
            if (round_.has_handle() && std::abs(dot(out, right_)) > 0.5) continue;
            add_side(out, cross(axis, out), high, low);
        }
    }

private:
    void add_sphere() {
        const double radius = round_.widest;
        const Point3 middle = round_.foot + (round_.height / 2) * round_.axis;
        made_.panels.push_back({number_,
                                PanelKind::outline,
                                view_.toward,
                                {circle(middle, radius * view_.right, -radius * view_.down)},
                                disc(radius)});
    }

    // What is seen from that end; of a vessel's bottom, the circle that it stands on. `other`: the panel of the other end.
    void add_end(bool is_high, std::uint32_t other) {
        const Revolution::End& end = is_high ? round_.high : round_.low;
        const Point3 out = is_high ? round_.axis : -1 * round_.axis;
        const Point3 side = is_high ? away_ : -1 * away_;
        const Point3 middle = round_.foot + (is_high ? round_.height : 0) * round_.axis;
        Panel panel{.part = number_, .normal = out, .rings = {}};
        const bool is_bottom = round_.is_vessel() && !end.open;
        if (is_bottom) {
            panel.kind = PanelKind::bottom;
            panel.opening = other;
            if (end.radius > kTip * round_.widest) panel.rings = {circle(middle, end.radius * right_, end.radius * side)};
            panel.area = disc(end.radius);
        } else {
            panel.kind = end.open ? PanelKind::opening : end.radius > kTip * round_.widest ? PanelKind::cap : PanelKind::outline;
            panel.rings = {circle(middle, round_.widest * right_, round_.widest * side)};
            panel.area = disc(round_.widest);
            if (round_.has_handle()) {
                OutlineOfPart outline = outline_of(part_.solid, out, right_, side);
                panel.rings = std::move(outline.rings);
                panel.area = outline.area;
            }
            if (end.radius > kTip * round_.widest && (end.radius < kNarrower * round_.widest || round_.has_handle()))
                panel.lines.push_back({circle(middle, end.radius * right_, end.radius * side), true});
        }
        made_.panels.push_back(std::move(panel));
    }

    // Counter-clockwise from outside: across, and up the axis.
    void add_side(const Point3& out, const Point3& across, std::uint32_t high, std::uint32_t low) {
        const Point3 &axis = round_.axis, foot = round_.foot + round_.widest * out;
        const auto at = [&](double x, double y) { return foot + x * across + y * axis; };
        const bool is_seen = std::abs(dot(out, view_.toward)) >= kAligned;
        Panel panel{.part = number_, .kind = PanelKind::section, .normal = out, .rings = {}};
        // To the right there is the handle, if there is one.
        const bool handle_right = round_.has_handle() && dot(across, round_.handle) > 0;
        const std::vector<ProfileLine>&right = handle_right ? round_.handled : round_.profile,
              &left = round_.has_handle() && !handle_right ? round_.handled : round_.profile;
        const std::vector<Point> silhouette = silhouette_of(right, left);
        Ring& ring = panel.rings.emplace_back();
        for (const Point& one : silhouette) {
            const Point& next = silhouette[(ring.size() + 1) % silhouette.size()];
            panel.area += (one.x * next.y - next.x * one.y) / 2;
            ring.push_back(at(one.x, one.y));
        }
        if (is_seen && !round_.is_vessel() && !round_.has_handle()) {
            panel.kind = PanelKind::outline;
            open_ends(panel, silhouette);
        } else {
            panel.is_bordered = false;
            for (const auto& [profile, sign] : {std::pair(&right, 1.0), std::pair(&left, -1.0)})
                for (const ProfileLine& line : *profile) {
                    PanelLine& own = panel.lines.emplace_back();
                    own.closed = line.closed;
                    for (const Point& one : line.points) own.points.push_back(at(sign * one.x, one.y));
                }
        }
        const auto place = static_cast<std::uint32_t>(made_.panels.size());
        made_.panels.push_back(std::move(panel));
        hinge(high, place, out, across, round_.height);
        hinge(low, place, out, -1 * across, 0);
    }

    // Open, with a rim that is hardly there.
    bool is_thin(const Revolution::End& end) const {
        const double height = &end == &round_.high ? round_.height : 0;
        return end.open && end.radius > kNarrower * reach_at(round_.profile, height);
    }

    // No line where a tube is open.
    void open_ends(Panel& panel, const std::vector<Point>& silhouette) const {
        for (std::size_t i = 0; i < silhouette.size(); ++i) {
            const Point &a = silhouette[i], &b = silhouette[(i + 1) % silhouette.size()];
            const bool at_low = a.y <= 0 && b.y <= 0, at_high = a.y >= round_.height && b.y >= round_.height;
            if ((at_low && is_thin(round_.low)) || (at_high && is_thin(round_.high)))
                panel.open_sides.push_back(static_cast<std::uint32_t>(i));
        }
    }

    std::vector<Point> silhouette_of(const std::vector<ProfileLine>& right, const std::vector<ProfileLine>& left) const {
        // Just below and just above each bend: a rim may be as wide as the disc that it ends in.
        const double within = 1e-6 * round_.height;
        std::vector<double> heights;
        for (const std::vector<ProfileLine>* profile : {&right, &left})
            for (const ProfileLine& line : *profile)
                for (const Point& at : line.points)
                    for (const double height : {at.y - within, at.y + within})
                        heights.push_back(std::clamp(height, within, round_.height - within));
        std::sort(heights.begin(), heights.end());
        std::vector<Point> ring;
        const auto take = [&](double across, double height) {
            const Point at{across, height <= within ? 0 : height >= round_.height - within ? round_.height : height};
            if (ring.empty() || distance(ring.back(), at) > 4 * within) ring.push_back(at);
        };
        for (const double height : heights) take(reach_at(right, height), height);
        for (std::size_t i = heights.size(); i-- > 0;) take(-reach_at(left, heights[i]), heights[i]);
        return ring;
    }

    // Where the box round it has an edge; the circle of a bottom hangs on the middle of it.
    void hinge(std::uint32_t end, std::uint32_t side, const Point3& out, const Point3& across, double height) {
        const Panel& panel = made_.panels[end];
        if (panel.rings.empty()) return;
        const double radius = panel.kind == PanelKind::bottom ? (height > 0 ? round_.high : round_.low).radius : round_.widest;
        const Point3 foot = round_.foot + height * round_.axis;
        const Point3 on_end = foot + radius * out, on_side = foot + round_.widest * out;
        // From the end of the axis it runs the other way.
        const Point3 half = radius * across;
        made_.hinges.push_back({end, side, on_end - half, on_end + half, on_side - half, on_side + half, true});
    }

    Panels& made_;
    const ModelPart& part_;
    const Revolution& round_;
    std::uint32_t number_;
    const ViewPlane& view_;
    Point3 right_, away_;
};

}  // namespace

void add_round(Panels& made, const ModelPart& part, std::uint32_t number, const ViewPlane& view) {
    RoundPanels(made, part, number, view).add();
}

}  // namespace tactics
