// SPDX-License-Identifier: Apache-2.0
// Where else the name of a thing may be led to: the places of its border that are no other thing's border, too.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "tactics/geometry/box.h"
#include "tactics/page.h"

namespace tactics {

class ThingPlaces {
public:
    /// `regions` must outlive it.
    explicit ThingPlaces(const std::vector<Region>& regions, const std::string& language = "en");

    /// The thing that a name names: the region with that text that holds the place, the smallest of several, else the nearest
    /// within a few mm; null where no region has that text, as for words of the user's. "Cup: bottom" may be named "bottom". What
    /// else lies there is not asked: a thing may lie on top of the one that the name is of.
    const Region* thing_of(const std::string& text, Point at) const;
    /// The smallest region that holds a place.
    const Region* thing_at(Point at) const;

    enum class Border { own, any };
    /// Places on the border of that thing, the nearest first and no more than `most`. Beyond its own border lies what the thing
    /// lies on, or nothing: a line that ends there tells which of two neighbours it means.
    std::vector<Point> on_border(const Region& thing, Point from, Border border, std::size_t most) const;

    /// Words with that middle seem to belong to no other thing.
    bool is_free_of_others(const Region& thing, Point middle) const;

private:
    bool is_border(std::size_t thing, Point one, Point other, Border border) const;
    void add_places(std::size_t thing, Point a, Point b, Border border, std::vector<Point>& places) const;
    const Region* nearest_of(const std::vector<std::size_t>& regions, Point at) const;
    double apart(std::size_t region, Point at) const;
    bool holds_at(std::size_t region, Point at) const { return boxes_[region].holds(at) && holds(regions_[region], at); }

    const std::vector<Region>& regions_;
    std::vector<Box> boxes_;
    std::unordered_map<std::string, std::vector<std::size_t>> of_text_,
        of_end_;  // regions that are drawn, by all words and by those behind a colon
};

/// The closed lines of a page that a hand feels as one thing each.
class ClosedShapes {
public:
    explicit ClosedShapes(const Page& page);

    /// Whether words there would seem to name one that is not around their thing. Of very many shapes not all are known.
    bool any_around_only(Point words, Point thing) const;

private:
    struct Shape {
        Box box;
        std::vector<Point> ring;
    };
    static bool holds(const Shape& shape, Point at);

    std::vector<Shape> all_;
};

/// The box of the smallest closed line around a place, if a hand feels it as one thing and the place is near its middle.
std::optional<Box> shape_around(const Page& page, Point at);

}  // namespace tactics
