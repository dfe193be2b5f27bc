// SPDX-License-Identifier: Apache-2.0
#include "tactics/layout/thing_places.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "tactics/geometry/course.h"
#include "tactics/geometry/distance.h"
#include "tactics/text/utf8.h"

namespace tactics {

namespace {

// A shape within the span of a hand names itself by words beside it; own choice.
constexpr double kLargestShape = 45;      // mm
constexpr double kInMiddle = 0.2;         // of its sides: so near to its middle stands what names it
constexpr double kAtThing = 5;            // mm: what files and other sizes leave of a place on its border, and more
constexpr double kEitherSide = 0.5;       // mm from a border to what lies on either side of it
constexpr double kBorderStep = 2;         // mm along a border
constexpr int kMostSteps = 200;           // along one side
constexpr double kShortestStretch = 2;    // mm: what ends at a shorter stretch seems to end at its neighbours, too
constexpr double kPlacesApart = 15;       // mm
constexpr double kUneven = 0.137;         // nobody builds by it, so that last digits do not decide a count
constexpr std::size_t kMostSides = 1000;  // of a thing; a mesh has more, but no finger feels them one by one

}  // namespace

ThingPlaces::ThingPlaces(const std::vector<Region>& regions, const std::string& language) : regions_(regions) {
    for (std::size_t i = 0; i < regions.size(); ++i) {
        boxes_.push_back(box_of(regions[i]));
        if (regions[i].rings.empty()) continue;
        const std::string text = to_line(regions[i].name.in(language));
        of_text_[text].push_back(i);
        if (const std::size_t end = text.rfind(": "); end != text.npos) of_end_[text.substr(end + 2)].push_back(i);
    }
}

double ThingPlaces::apart(std::size_t region, Point at) const {
    if (holds_at(region, at)) return 0;
    double least = std::numeric_limits<double>::infinity();
    for (const auto& ring : regions_[region].rings)
        for (std::size_t i = 0; i < ring.size(); ++i)
            least = std::min(least, distance_to_segment(at, ring[i], ring[(i + 1) % ring.size()]));
    return least;
}

const Region* ThingPlaces::nearest_of(const std::vector<std::size_t>& regions, Point at) const {
    const Region* thing = nullptr;
    std::pair<double, double> best;
    for (const std::size_t i : regions) {
        if (!grown(boxes_[i], kAtThing).holds(at)) continue;
        const std::pair<double, double> far{apart(i, at), boxes_[i].width() * boxes_[i].height()};
        if (far.first > kAtThing || (thing != nullptr && far >= best)) continue;
        best = far;
        thing = &regions_[i];
    }
    return thing;
}

const Region* ThingPlaces::thing_of(const std::string& text, Point at) const {
    for (const auto* texts : {&of_text_, &of_end_})
        if (const auto found = texts->find(text); found != texts->end())
            if (const Region* thing = nearest_of(found->second, at)) return thing;
    return nullptr;
}

const Region* ThingPlaces::thing_at(Point at) const {
    std::size_t thing = regions_.size();
    for (std::size_t i = 0; i < regions_.size(); ++i) {
        const auto area = [this](std::size_t region) { return boxes_[region].width() * boxes_[region].height(); };
        if (holds_at(i, at) && (thing == regions_.size() || area(i) < area(thing))) thing = i;
    }
    return thing < regions_.size() ? &regions_[thing] : nullptr;
}

// On one side of it is the thing, on the other it is not; and nothing else begins or ends there.
bool ThingPlaces::is_border(std::size_t thing, Point one, Point other, Border border) const {
    if (holds_at(thing, one) == holds_at(thing, other)) return false;
    if (border == Border::any) return true;
    for (std::size_t i = 0; i < regions_.size(); ++i)
        if (i != thing && holds_at(i, one) != holds_at(i, other)) return false;
    return true;
}

// The middle of each stretch of that side which is border; of a long one, several places.
void ThingPlaces::add_places(std::size_t thing, Point a, Point b, Border border, std::vector<Point>& places) const {
    const double side = distance(a, b);
    if (side < kShortestStretch) return;
    const auto at = [&](double t) { return Point{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}; };
    const Point aside{kEitherSide * (b.y - a.y) / side, -kEitherSide * (b.x - a.x) / side};
    const int steps = std::min(kMostSteps, 1 + static_cast<int>(side / kBorderStep + kUneven));
    int first = -1;  // of the stretch
    for (int step = 0; step <= steps; ++step) {
        const Point here = at((step + 0.5) / steps);
        const bool is_one =
            step < steps && is_border(thing, {here.x + aside.x, here.y + aside.y}, {here.x - aside.x, here.y - aside.y}, border);
        if (is_one && first < 0) first = step;
        if (is_one || first < 0) continue;
        const double length = side * (step - first) / steps;
        const int count = length < kShortestStretch ? 0 : std::max(1, static_cast<int>(length / kPlacesApart + kUneven));
        for (int k = 0; k < count; ++k) places.push_back(at((first + (step - first) * (k + 0.5) / count) / steps));
        first = -1;
    }
}

std::vector<Point> ThingPlaces::on_border(const Region& thing, Point from, Border border, std::size_t most) const {
    const auto own = static_cast<std::size_t>(&thing - regions_.data());
    std::vector<Point> places;
    std::size_t sides = 0;
    for (const auto& ring : thing.rings)
        for (std::size_t i = 0; i < ring.size() && sides < kMostSides; ++i, ++sides)
            add_places(own, ring[i], ring[(i + 1) % ring.size()], border, places);
    // Of two that are as far, the right and the lower one, whatever the last digits say.
    const auto far = [&](Point at) { return distance(at, from) - 0.05 * (at.x - from.x) - 0.02 * (at.y - from.y); };
    std::stable_sort(places.begin(), places.end(), [&](Point a, Point b) { return far(a) < far(b); });
    if (places.size() > most) places.resize(most);
    return places;
}

bool ThingPlaces::is_free_of_others(const Region& thing, Point middle) const {
    // What holds the thing holds a place of it.
    for (std::size_t i = 0; i < regions_.size(); ++i)
        if (&regions_[i] != &thing && holds_at(i, middle) && !holds_at(i, thing.at)) return false;
    return true;
}

ClosedShapes::ClosedShapes(const Page& page) {
    constexpr std::size_t kMostShapes = 400, kMostCorners = 200;
    for (const PageStroke& stroke : page.strokes) {
        if (!stroke.closed || stroke.points.size() < 3 || stroke.points.size() > kMostCorners) continue;
        const Box box = box_of(stroke.points);
        if (std::max(box.width(), box.height()) <= kLargestShape && all_.size() < kMostShapes)
            all_.push_back({box, stroke.points});
    }
}

bool ClosedShapes::holds(const Shape& shape, Point at) {
    bool inside = false;
    for (std::size_t i = 0; shape.box.holds(at) && i < shape.ring.size(); ++i)
        if (ray_meets(at, shape.ring[i], shape.ring[(i + 1) % shape.ring.size()])) inside = !inside;
    return inside;
}

bool ClosedShapes::any_around_only(Point words, Point thing) const {
    return std::any_of(all_.begin(), all_.end(), [&](const Shape& shape) { return holds(shape, words) && !holds(shape, thing); });
}

std::optional<Box> shape_around(const Page& page, Point at) {
    std::optional<Box> best;
    for (const PageStroke& stroke : page.strokes) {
        if (!stroke.closed || stroke.points.size() < 3) continue;
        const Box box = box_of(stroke.points);
        if (!box.holds(at) || std::max(box.width(), box.height()) > kLargestShape) continue;
        const Point middle{(box.left + box.right) / 2, (box.top + box.bottom) / 2};
        if (std::abs(at.x - middle.x) > kInMiddle * box.width() || std::abs(at.y - middle.y) > kInMiddle * box.height()) continue;
        if (!best || box.width() * box.height() < best->width() * best->height()) best = box;
    }
    return best;
}

}  // namespace tactics
