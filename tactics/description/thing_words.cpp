// SPDX-License-Identifier: Apache-2.0
#include "tactics/description/thing_words.h"

#include <cmath>
#include <utility>

#include "tactics/geometry/box.h"
#include "tactics/geometry/dashed_line.h"
#include "tactics/layout/texture.h"

namespace tactics {

namespace {

// The English name decides; other languages have none, or their own.
Phrase with_article(Phrase name) {
    const bool consonant = std::string_view("aeiou").find(name.english()[0]) == std::string_view::npos;
    return consonant ? phrase("A {0}", std::move(name)) : phrase("An {0}", std::move(name));
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
Phrase beside(const std::vector<Thing>& things) {
    const Thing& last = things.back();
    for (std::size_t i = things.size() - 1; i-- > 0;) {
        const Rect &a = things[i].box, &b = last.box;
        if (things[i].place != last.place) continue;
        const std::string number = std::to_string(i + 1);
        if (b.top >= a.top + a.height) return phrase("lies below number {0}", number);
        if (b.left >= a.left + a.width) return phrase("lies to the right of number {0}", number);
        if (b.left + b.width <= a.left) return phrase("lies to the left of number {0}", number);
    }
    return {};
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

Phrase relations_of(const std::vector<Thing>& things, const std::vector<Shape>& shapes) {
    const std::size_t at = things.size() - 1;
    std::vector<Phrase> crosses, meets;
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
            return things[at].texture > 0 ? phrase("It fills number {0}.", number)
                                          : phrase("It is the outline of number {0}.", number);
        if (things[i].texture > 0 || things[at].texture > 0) continue;
        if (cross(shapes[at], shapes[i]))
            crosses.push_back(number);
        else if (end_meets(shapes[at], shapes[i]) || end_meets(shapes[i], shapes[at]))
            meets.push_back(number);
    }
    std::vector<Phrase> parts;
    if (around != at) parts.push_back(phrase("lies inside number {0}", std::to_string(around + 1)));
    if (!crosses.empty()) parts.push_back(phrases(crosses.size(), "crosses number {1}", "crosses numbers {1}", listed(crosses)));
    if (!meets.empty()) parts.push_back(phrases(meets.size(), "meets number {1}", "meets numbers {1}", listed(meets)));
    if (Phrase other = beside(things); parts.empty() && !other.empty()) parts.push_back(std::move(other));
    return parts.empty() ? Phrase() : phrase("It {0}.", listed(parts));
}

Shape shape_of(const Page& page, const Wordless& candidate) {
    if (candidate.area) return shape_of(*longest_ring(area_of(page, candidate.index)), true);
    return shape_of(whole_line(page, candidate.index, candidate.last), page.strokes[candidate.index].closed);
}

namespace {

Phrase area_words(const Area& area, const Shape& shape) {
    Phrase name = area.texture == 0 ? phrase("filled {0}", shape.area)
                                    : phrase("{0} filled with {1}", shape.area, name_of_texture(area.texture));
    const std::size_t holes = holes_in(area, shape);
    if (holes > 20) return phrase("{0} with many holes", std::move(name));
    return holes > 0 ? phrases(holes, "{1} with {0} hole", "{1} with {0} holes", std::move(name)) : name;
}

}  // namespace

Thing thing_of(const Page& page, const Wordless& candidate, const Shape& shape, const Ninths& ninths, double thinnest) {
    Thing thing;
    thing.area = candidate.area;
    thing.index = candidate.index;
    thing.box = shape.box;
    thing.length = shape.length;
    Phrase name = shape.name;
    if (candidate.area) {
        thing.texture = area_of(page, candidate.index).texture;
        name = area_words(area_of(page, candidate.index), shape);
    } else {
        if (candidate.last > candidate.index) name = phrase("dashed {0}", std::move(name));
        if (page.strokes[candidate.index].width > 1.5 * thinnest) name = phrase("thick {0}", std::move(name));
    }
    thing.what = phrase("{0}, {1}", with_article(std::move(name)), shape.size);
    thing.place = ninths.place(shape.box);
    if (!shape.closed && !(ninths.spans(shape.box) && shape.level)) {
        const Point a = shape.corners.front(), b = shape.corners.back();
        if (ninths.of(a) != ninths.of(b)) thing.place = ninths.course(a, b);
    }
    return thing;
}

}  // namespace tactics
