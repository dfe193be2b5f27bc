// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/svg/svg_marker.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tactics/readers/svg/clip.h"
#include "tactics/readers/svg/svg_numbers.h"
#include "tactics/units.h"

namespace tactics {

std::optional<std::pair<LineEnd, LineEnd>> ends_of(const std::vector<Subpath>& subpaths) {
    if (subpaths.empty() || subpaths.front().points.size() < 2 || subpaths.back().points.size() < 2) return std::nullopt;
    const auto& first = subpaths.front().points;
    const auto& last = subpaths.back().points;
    const auto direction = [](Point from, Point to) { return std::atan2(to.y - from.y, to.x - from.x); };
    const bool closed = subpaths.back().closed;
    const Point end = closed ? last[0] : last.back(), before = closed ? last.back() : last[last.size() - 2];
    return std::pair{LineEnd{first[0], direction(first[0], first[1]), true}, LineEnd{end, direction(before, end), false}};
}

Transform marker_place(const Element& marker, const LineEnd& end, double width, double scale) {
    const auto length = [&](std::string_view name, double fallback) {
        const auto text = marker.attribute(name);
        return text.empty() ? fallback : parse_svg_length(text, 0).value_or(fallback);
    };
    const std::string_view orient = marker.attribute("orient");
    double angle = end.angle;
    if (orient == "auto-start-reverse")
        angle += end.start ? std::numbers::pi : 0;
    else if (orient != "auto")
        angle = parse_number(orient.substr(0, orient.find("deg"))).value_or(0) * std::numbers::pi / 180;
    const double size = marker.attribute("markerUnits") == "userSpaceOnUse" ? scale : width;
    double view[4];
    std::string_view box = marker.attribute("viewBox");
    bool has_view = true;
    for (double& number : view) {
        const auto taken = take_svg_number(box);
        has_view = has_view && taken.has_value();
        number = taken.value_or(0);
    }
    const Transform content =
        has_view && view[2] > 0 && view[3] > 0
            ? fit_view(view, length("markerWidth", 3), length("markerHeight", 3), marker.attribute("preserveAspectRatio"))
            : Transform();
    const Point reference = content({length("refX", 0), length("refY", 0)});
    const double c = size * std::cos(angle), s = size * std::sin(angle);
    return Transform{c, s, -s, c, end.at.x, end.at.y} * Transform{1, 0, 0, 1, -reference.x, -reference.y} * content;
}

bool is_head(const std::vector<Point>& ring) {
    if (ring.size() <= 3) return true;
    if (ring.size() > 4) return false;
    int left = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        const Point a = ring[i], b = ring[(i + 1) % 4], c = ring[(i + 2) % 4];
        left += (b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x) > 0 ? 1 : 0;
    }
    return left == 1 || left == 3;
}

void tell_marker(Page& page, std::size_t strokes, std::size_t areas) {
    const bool head = [&] {
        if (page.strokes.size() > strokes + 1 || page.areas.size() > areas + 1) return false;
        if (page.strokes.size() == strokes && page.areas.size() == areas) return false;
        if (page.areas.size() > areas) return page.areas.back().rings.size() == 1 && is_head(page.areas.back().rings[0]);
        const PageStroke& stroke = page.strokes.back();
        return stroke.points.size() == 3 || (stroke.closed && stroke.points.size() == 4);
    }();
    for (std::size_t i = strokes; i < page.strokes.size(); ++i) page.strokes[i].role = head ? Role::arrow : Role::symbol;
    for (std::size_t i = areas; i < page.areas.size(); ++i) page.areas[i].role = head ? Role::arrow : Role::symbol;
}

bool is_sign(const std::vector<Subpath>& subpaths) {
    constexpr double kSign = 12;  // mm; a setting
    if (subpaths.size() != 1) return false;
    Extent extent;
    add_all(extent, subpaths);
    if (std::max(extent.box.width, extent.box.height) > kSign) return false;
    const std::vector<Point>& points = subpaths[0].points;
    bool upright = true;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Point a = points[i], b = points[(i + 1) % points.size()];
        upright = upright && std::min(std::abs(a.x - b.x), std::abs(a.y - b.y)) < 0.01;
    }
    return !upright;
}

bool takes_markers(const Element& element) {
    return element.name == "path" || element.name == "line" || element.name == "polyline" || element.name == "polygon";
}

}  // namespace tactics
