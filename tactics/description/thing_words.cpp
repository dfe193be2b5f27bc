// SPDX-License-Identifier: Apache-2.0
#include "tactics/description/thing_words.h"

#include <cmath>

#include "tactics/geometry/box.h"
#include "tactics/geometry/dashed_line.h"
#include "tactics/layout/texture.h"

namespace tactics {

namespace {

std::string with_article(const std::string& name) {
    return (std::string_view("aeiou").find(name[0]) == std::string_view::npos ? "A " : "An ") + name;
}

// Black areas, then textured ones.
const Area& area_of(const Page& page, std::size_t index) {
    return index < page.areas.size() ? page.areas[index] : page.textured[index - page.areas.size()];
}

const std::vector<Point>* longest_ring(const Area& area) {
    const std::vector<Point>* longest = nullptr;
    double most = -1;
    for (const auto& ring : area.rings) {
        if (ring.empty()) continue;
        if (const double length = length_of(ring, true); length > most) {
            most = length;
            longest = &ring;
        }
    }
    return longest;
}

// Where the place alone does not tell two things apart.
std::string beside(const std::vector<Thing>& things) {
    const Thing& last = things.back();
    for (std::size_t i = things.size() - 1; i-- > 0;) {
        const Rect &a = things[i].box, &b = last.box;
        if (things[i].place != last.place) continue;
        const std::string number = " number " + std::to_string(i + 1);
        if (b.top >= a.top + a.height) return "lies below" + number;
        if (b.left >= a.left + a.width) return "lies to the right of" + number;
        if (b.left + b.width <= a.left) return "lies to the left of" + number;
    }
    return "";
}

bool same_place(const Rect& a, const Rect& b) {
    constexpr double kSame = 1;  // mm
    return std::abs(a.left - b.left) < kSame && std::abs(a.top - b.top) < kSame && std::abs(a.width - b.width) < kSame &&
           std::abs(a.height - b.height) < kSame;
}

std::size_t holes_in(const Area& area, const Shape& outer) {
    std::size_t holes = 0;
    const auto* longest = longest_ring(area);
    for (const auto& ring : area.rings) {
        if (ring.empty() || &ring == longest) continue;
        holes += holds(outer, ring.front()) ? 1 : 0;
        if (holes > 20) break;  // nobody counts on
    }
    return holes;
}

}  // namespace

std::vector<Wordless> candidates_of(const Page& page) {
    std::vector<Wordless> all;
    for (std::size_t i = 0; i < page.strokes.size(); ++i) {
        const PageStroke& stroke = page.strokes[i];
        if (stroke.points.empty() || !is_drawn(stroke.role)) continue;
        const std::size_t last = last_of_line(page, i);
        const std::vector<Point> points = whole_line(page, i, last);
        all.push_back({false, i, length_of(points, stroke.closed), rect_of(box_of(points)), last});
        i = last;
    }
    for (std::size_t i = 0; i < page.areas.size() + page.textured.size(); ++i)
        if (const auto* ring = longest_ring(area_of(page, i)))
            all.push_back({true, i, length_of(*ring, true), rect_of(box_of(*ring)), i});
    return all;
}

std::string relations_of(const std::vector<Thing>& things, const std::vector<Shape>& shapes) {
    const std::size_t at = things.size() - 1;
    std::vector<std::string> crosses, meets;
    std::size_t around = at;
    // A texture ends where its outline runs; neither lies inside the other.
    const auto fills = [&](std::size_t i) {
        return (things[i].texture > 0) != (things[at].texture > 0) && same_place(shapes[i].box, shapes[at].box);
    };
    for (std::size_t i = 0; i < shapes.size(); ++i)
        if (i != at && !(i < at && fills(i)) && is_inside(shapes[at], shapes[i]) &&
            (around == at || shapes[i].length < shapes[around].length))
            around = i;
    for (std::size_t i = 0; i < at; ++i) {
        const std::string number = std::to_string(i + 1);
        if (fills(i))
            return things[at].texture > 0 ? "It fills number " + number + "." : "It is the outline of number " + number + ".";
        if (things[i].texture > 0 || things[at].texture > 0) continue;
        if (cross(shapes[at], shapes[i]))
            crosses.push_back(number);
        else if (end_meets(shapes[at], shapes[i]) || end_meets(shapes[i], shapes[at]))
            meets.push_back(number);
    }
    std::vector<std::string> parts;
    if (around != at) parts.push_back("lies inside number " + std::to_string(around + 1));
    if (!crosses.empty()) parts.push_back("crosses number " + listed(crosses));
    if (!meets.empty()) parts.push_back("meets number " + listed(meets));
    if (const std::string other = beside(things); parts.empty() && !other.empty()) parts.push_back(other);
    return parts.empty() ? "" : "It " + listed(parts) + ".";
}

Shape shape_of(const Page& page, const Wordless& candidate) {
    if (candidate.area) return shape_of(*longest_ring(area_of(page, candidate.index)), true);
    return shape_of(whole_line(page, candidate.index, candidate.last), page.strokes[candidate.index].closed);
}

Thing thing_of(const Page& page, const Wordless& candidate, const Shape& shape, const Ninths& ninths, double thinnest) {
    Thing thing{candidate.area,
                candidate.index,
                shape.box,
                shape.length,
                "",
                "",
                "",
                candidate.area ? area_of(page, candidate.index).texture : 0};
    std::string name = shape.name;
    if (candidate.area) {
        constexpr std::string_view kOutline = "closed outline";
        if (const auto part = name.find(kOutline); part != std::string::npos) name.replace(part, kOutline.size(), "shape");
        const int texture = area_of(page, candidate.index).texture;
        if (texture == 0)
            name = "filled " + name;
        else
            name += " filled with " + std::string(name_of_texture(texture));
        if (const std::size_t holes = holes_in(area_of(page, candidate.index), shape); holes > 20)
            name += " with many holes";
        else if (holes > 0)
            name += " with " + counted(holes, "hole");
    } else {
        if (candidate.last > candidate.index) name = "dashed " + name;
        if (page.strokes[candidate.index].width > 1.5 * thinnest) name = "thick " + name;
    }
    thing.what = with_article(name) + ", " + shape.size;
    thing.place = ninths.place(shape.box);
    const bool spans = thing.place.starts_with("across") || thing.place.starts_with("down");
    const bool straight =
        name.find("straight horizontal") != std::string::npos || name.find("straight vertical") != std::string::npos;
    if (!shape.closed && !(spans && straight)) {
        const Point a = shape.corners.front(), b = shape.corners.back();
        if (ninths.of(a) != ninths.of(b)) thing.place = ninths.course(a, b);
    }
    return thing;
}

}  // namespace tactics
