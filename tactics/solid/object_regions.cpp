// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/object_regions.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "tactics/geometry/box.h"
#include "tactics/geometry/region_place.h"
#include "tactics/geometry/triangulate.h"

namespace tactics {

namespace {

// mm: WCAG 2.2, 2.5.8, requires pointer targets of 24 CSS pixels, 96 of which are an inch.
constexpr double kTarget = 24 * 25.4 / 96;

// The first ring is the outer one and the largest; its holes run the other way.
void add_shape(Region& region, const FlatShape& shape, const IntoDrawing& into) {
    const bool turned = doubled_area(shape.rings.front()) < 0;
    for (const auto& ring : shape.rings) {
        std::vector<Point>& own = region.rings.emplace_back();
        for (const Point& at : ring) own.push_back(into.of(at));
        if (turned) std::reverse(own.begin(), own.end());
    }
}

void add_strip(Region& region, Point from, Point to) {
    const double length = distance(from, to), half = kTarget / 2;
    const Point along = length > 0 ? Point{(to.x - from.x) / length, (to.y - from.y) / length} : Point{1, 0};
    if (length < kTarget) {  // a wedge, or the end of a bar: as long as it is wide
        const Point middle{(from.x + to.x) / 2, (from.y + to.y) / 2};
        from = {middle.x - half * along.x, middle.y - half * along.y};
        to = {middle.x + half * along.x, middle.y + half * along.y};
    }
    const Point aside{-along.y * half, along.x * half};
    region.rings.push_back({{from.x - aside.x, from.y - aside.y},
                            {to.x - aside.x, to.y - aside.y},
                            {to.x + aside.x, to.y + aside.y},
                            {from.x + aside.x, from.y + aside.y}});
}

Phrase what_was_done(const FoldedObject& one, int held, const Phrase& seen) {
    if (one.fate == FoldedObject::Fate::small) return phrase("too small to be felt at this size");
    if (one.fate == FoldedObject::Fate::hidden) return phrase("under or behind other things");
    Phrase text;
    const auto say = [&](Phrase words) { text = text.empty() ? std::move(words) : phrase("{0}; {1}", text, std::move(words)); };
    const auto count = [&](int number, auto words) {
        if (number > 0) say(words(static_cast<std::size_t>(number)));
    };
    if (one.kept > 0) say(phrase("seen {0}", seen));
    count(one.straightened,
          [](std::size_t n) { return phrases(n, "a face that leant, turned upright", "{0} faces that leant, turned upright"); });
    if (one.kept > 0)
        count(one.folded, [](std::size_t n) { return phrases(n, "{0} face folded out", "{0} faces folded out"); });
    else
        count(one.folded, [](std::size_t n) { return phrases(n, "a face folded out", "{0} faces folded out"); });
    count(one.lying, [](std::size_t n) { return phrases(n, "an upright face laid down", "{0} upright faces laid down"); });
    count(one.hanging, [](std::size_t n) {
        return phrases(n, "seen from its side, beside what is over it", "seen from {0} sides, beside what is over it");
    });
    count(one.flattened, [](std::size_t n) { return phrases(n, "laid flat outward", "{0} slender parts laid flat outward"); });
    count(one.wedges,
          [](std::size_t n) { return phrases(n, "a wedge, thick where it is near", "{0} wedges, thick where they are near"); });
    count(held, [](std::size_t n) {
        return phrases(n, "{0} slender part on it laid flat outward", "{0} slender parts on it laid flat outward");
    });
    count(one.doubled, [](std::size_t n) { return phrases(n, "{0} side shown twice", "{0} sides shown twice"); });
    count(one.left_out,
          [](std::size_t n) { return phrases(n, "{0} face without room left out", "{0} faces without room left out"); });
    return text;
}

std::vector<std::pair<std::string, int>> counts_of(const FoldedObject& one) {
    std::vector<std::pair<std::string, int>> counts;
    const std::pair<const char*, int> all[] = {
        {"kept", one.kept},     {"straightened", one.straightened}, {"folded", one.folded},
        {"lying", one.lying},   {"hanging", one.hanging},           {"flattened", one.flattened},
        {"wedges", one.wedges}, {"doubled", one.doubled},           {"left_out", one.left_out}};
    for (const auto& [what, count] : all)
        if (count > 0) counts.emplace_back(what, count);
    return counts;
}

bool reads_before(const Box& a, const Box& b) {
    constexpr double kLine = 10;  // mm: about one line of braille, as names are read
    const double row_a = std::floor(a.top / kLine), row_b = std::floor(b.top / kLine);
    return row_a != row_b ? row_a < row_b : a.left < b.left;
}

}  // namespace

std::vector<Region> in_reading_order(std::vector<Region> regions, const std::vector<double>& height) {
    std::vector<std::size_t> order;
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < regions.size(); ++i) {
        boxes.push_back(box_of(regions[i]));
        if (!regions[i].rings.empty()) order.push_back(i);
    }
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return reads_before(boxes[a], boxes[b]); });
    // A thing is read when all that it lies on has been; heights go one way, so something can always be read.
    std::vector<std::size_t> waits_for(order.size(), 0);  // how many
    const auto lies_on = [&](std::size_t one, std::size_t other) {
        return height[order[other]] < height[order[one]] && meet(boxes[order[one]], boxes[order[other]]);
    };
    std::set<std::size_t> next;  // the first of those that wait for none
    for (std::size_t one = 0; one < order.size(); ++one) {
        for (std::size_t other = 0; other < order.size(); ++other) waits_for[one] += lies_on(one, other);
        if (waits_for[one] == 0) next.insert(one);
    }
    std::vector<Region> sorted;
    while (!next.empty()) {
        const std::size_t read = *next.begin();
        next.erase(next.begin());
        sorted.push_back(std::move(regions[order[read]]));
        for (std::size_t one = 0; one < order.size(); ++one)
            if (lies_on(one, read) && --waits_for[one] == 0) next.insert(one);
    }
    for (std::size_t i = 0; i < regions.size(); ++i)
        if (boxes[i].left > boxes[i].right) sorted.push_back(std::move(regions[i]));
    return sorted;
}

std::vector<Region> object_regions(const std::vector<FoldedObject>& objects, const std::vector<ModelPart>& felt,
                                   const Panels& panels, const FlatLayout& layout, const IntoDrawing& into, const Phrase& seen) {
    std::vector<std::size_t> place;  // of an object of the model in `objects`
    for (std::size_t i = 0; i < objects.size(); ++i) {
        if (objects[i].object >= place.size()) place.resize(objects[i].object + 1, 0);
        place[objects[i].object] = i;
    }
    // Of each object, then of the sections and the bottoms of vessels.
    const std::size_t count = objects.size();
    std::vector<Region> regions(3 * count);
    std::vector<double> height(3 * count, -kNowhere);
    std::vector<int> held(count, 0);
    for (const PlacedPanel& placed : layout.panels) {
        const Panel& panel = panels.panels[placed.panel];
        const ModelPart& part = felt[panel.part];
        std::size_t one = place[part.object];
        if (part.round && part.round->is_vessel())
            one += panel.kind == PanelKind::section ? count : panel.kind == PanelKind::bottom ? 2 * count : 0;
        add_shape(regions[one], placed.shape, into);
        height[one] = std::max(height[one], placed.height);
    }
    for (const PlacedBar& placed : layout.bars) {
        const Bar& bar = panels.bars[placed.bar];
        const std::size_t one = place[felt[bar.part].object];
        const bool is_wedge = placed.handling == Handling::wedge;
        add_strip(regions[one], is_wedge ? in_wedge(into.of(placed.from)) : into.of(placed.from),
                  is_wedge ? in_wedge(into.of(placed.to)) : into.of(placed.to));
        height[one] = std::max(height[one], placed.height);
        if (placed.handling != Handling::flattened || bar.ends_held == 0) continue;
        if (const std::size_t holder = place[felt[panels.panels[bar.holder].part].object]; holder != one) ++held[holder];
    }
    for (std::size_t i = 0; i < count; ++i) {
        Region &main = regions[i], &section = regions[count + i], &bottom = regions[2 * count + i];
        if (main.rings.empty()) {  // a vessel whose opening has no room
            std::swap(main, section);
            std::swap(height[i], height[count + i]);
        }
        main.name = called(objects[i]);
        main.description = what_was_done(objects[i], held[i], seen);
        main.counts = counts_of(objects[i]);
        section.name = phrase("{0}: section", main.name);
        section.description = phrase("cut through along its axis; its opening is where no line is");
        bottom.name = phrase("{0}: bottom", main.name);
        bottom.description = phrase("the dashed circle that it stands on");
        for (Region* one : {&main, &section, &bottom}) {
            one->path = objects[i].path;
            if (!one->rings.empty()) one->at = place_in(*one);
        }
    }
    for (std::size_t i = regions.size(); i-- > count;)
        if (regions[i].rings.empty()) {
            regions.erase(regions.begin() + static_cast<std::ptrdiff_t>(i));
            height.erase(height.begin() + static_cast<std::ptrdiff_t>(i));
        }
    return in_reading_order(std::move(regions), height);
}

std::vector<Phrase> fold_remarks(const Drawing& drawing, const std::vector<FoldedObject>& objects, const Phrase& seen,
                                 double spread) {
    std::vector<Phrase> remarks = {
        phrase("It is drawn {0} without perspective; what cannot be seen from there is folded out beside it.", seen)};
    const auto any = [&](auto which) { return std::any_of(drawing.strokes.begin(), drawing.strokes.end(), which); };
    if (any([](const Stroke& stroke) { return stroke.line == LineClass::thick; }))
        remarks.push_back(phrase("What lies on something has thick lines."));
    const auto any_object = [&](auto which) { return std::any_of(objects.begin(), objects.end(), which); };
    if (any_object([](const FoldedObject& one) { return one.doubled > 0; }))
        remarks.push_back(phrase("A dashed line is a side that is shown twice."));
    if (any_object([](const FoldedObject& one) { return one.bottom.has_value(); }))
        remarks.push_back(phrase("A dashed circle is the bottom of a vessel; its opening is a circle without gaps."));
    if (!drawing.areas.empty()) remarks.push_back(phrase("A wedge is a line towards you, thick where it is near."));
    if (spread > 1)
        remarks.push_back(
            phrase("Things are moved apart, {0} times as far from the middle, so that their faces have room.", numeral(spread)));
    return remarks;
}

}  // namespace tactics
