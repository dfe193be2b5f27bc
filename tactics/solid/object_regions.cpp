// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/object_regions.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "tactics/geometry/box.h"
#include "tactics/geometry/region_place.h"
#include "tactics/geometry/shape.h"
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

Phrase what_was_done(const FoldedObject& one, int held, const Phrase& seen, double scale) {
    if (one.fate == FoldedObject::Fate::small) return phrase("too small to be felt at this size");
    if (one.fate == FoldedObject::Fate::hidden) return phrase("under or behind other things");
    Phrase text;
    const auto say = [&](Phrase words) { text = text.empty() ? std::move(words) : phrase("{0}; {1}", text, std::move(words)); };
    const auto count = [&](int number, auto words) {
        if (number > 0) say(words(static_cast<std::size_t>(number)));
    };
    if (one.kept > 0) say(phrase("seen {0}", seen));
    if (one.moved > 0) say(phrase("moved by {0} off what was too close", spoken_length(one.moved * scale)));
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

namespace {

// Regions of objects, in their order; behind them those of the sections and the bottoms of vessels, where these are drawn.
class RegionPlaces {
public:
    RegionPlaces(const std::vector<FoldedObject>& objects, const std::vector<ModelPart>& felt, const Panels& panels,
                 const FlatLayout& layout)
        : felt_(felt), panels_(panels), count_(objects.size()), has_main_(count_, 0) {
        for (std::size_t i = 0; i < count_; ++i) {
            if (objects[i].object >= place_.size()) place_.resize(objects[i].object + 1, 0);
            place_[objects[i].object] = i;
        }
        for (const PlacedPanel& placed : layout.panels)
            if (!is_further(panels.panels[placed.panel])) has_main_[of_part(panels.panels[placed.panel].part)] = 1;
        for (const PlacedBar& placed : layout.bars) has_main_[of_part(panels.bars[placed.bar].part)] = 1;
    }

    std::size_t of_part(std::uint32_t part) const { return place_[felt_[part].object]; }

    std::size_t of_panel(std::uint32_t number) {
        const Panel& panel = panels_.panels[number];
        const std::size_t one = of_part(panel.part);
        // The section stands for a vessel whose opening has no room.
        if (!is_further(panel) || (panel.kind == PanelKind::section && has_main_[one] == 0)) return one;
        return further_.try_emplace({one, panel.kind}, count_ + further_.size()).first->second;
    }

    /// By object and kind.
    const std::map<std::pair<std::size_t, PanelKind>, std::size_t>& further() const { return further_; }

private:
    bool is_further(const Panel& panel) const {
        const auto& round = felt_[panel.part].round;
        return round && round->is_vessel() && (panel.kind == PanelKind::section || panel.kind == PanelKind::bottom);
    }

    const std::vector<ModelPart>& felt_;
    const Panels& panels_;
    std::size_t count_;
    std::vector<std::size_t> place_;  // of an object of the model in the list
    std::vector<char> has_main_;      // something of it is drawn that is no section nor bottom of a vessel
    std::map<std::pair<std::size_t, PanelKind>, std::size_t> further_;
};

}  // namespace

std::vector<Region> object_regions(const std::vector<FoldedObject>& objects, const std::vector<ModelPart>& felt,
                                   const Panels& panels, const FlatLayout& layout, const IntoDrawing& into, const Phrase& seen) {
    RegionPlaces places(objects, felt, panels, layout);
    std::vector<Region> regions(objects.size());
    std::vector<double> height(objects.size(), -kNowhere);
    std::vector<int> held(objects.size(), 0);
    for (const PlacedPanel& placed : layout.panels) {
        const std::size_t one = places.of_panel(placed.panel);
        if (one == regions.size()) {
            regions.emplace_back();
            height.push_back(-kNowhere);
        }
        add_shape(regions[one], placed.shape, into);
        height[one] = std::max(height[one], placed.height);
    }
    for (const PlacedBar& placed : layout.bars) {
        const Bar& bar = panels.bars[placed.bar];
        const std::size_t one = places.of_part(bar.part);
        const bool is_wedge = placed.handling == Handling::wedge;
        add_strip(regions[one], is_wedge ? in_wedge(into.of(placed.from)) : into.of(placed.from),
                  is_wedge ? in_wedge(into.of(placed.to)) : into.of(placed.to));
        height[one] = std::max(height[one], placed.height);
        if (placed.handling != Handling::flattened || bar.ends_held == 0) continue;
        if (const std::size_t holder = places.of_part(panels.panels[bar.holder].part); holder != one) ++held[holder];
    }
    for (std::size_t i = 0; i < objects.size(); ++i) {
        regions[i].name = called(objects[i]);
        regions[i].description = what_was_done(objects[i], held[i], seen, into.scale);
        regions[i].counts = counts_of(objects[i]);
        regions[i].path = objects[i].path;
    }
    for (const auto& [whose, one] : places.further()) {
        const bool is_bottom = whose.second == PanelKind::bottom;
        const Phrase& name = regions[whose.first].name;
        regions[one].name = is_bottom ? phrase("{0}: bottom", name) : phrase("{0}: section", name);
        regions[one].description = is_bottom ? phrase("the dashed circle that it stands on")
                                             : phrase("cut through along its axis; its opening is where no line is");
        regions[one].path = objects[whose.first].path;
    }
    for (Region& region : regions)
        if (!region.rings.empty()) region.at = place_in(region);
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
    if (any_object([](const FoldedObject& one) { return one.moved > 0; }))
        remarks.push_back(phrase("Things that are too close to be felt one by one are moved a little off each other."));
    if (spread > 1)
        remarks.push_back(
            phrase("Things are moved apart, {0} times as far from the middle, so that their faces have room.", numeral(spread)));
    return remarks;
}

}  // namespace tactics
