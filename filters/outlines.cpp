// SPDX-License-Identifier: Apache-2.0
// A few whole outlines of what matters, under a budget of line.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "filters/arc_worth.h"
#include "filters/inner_lines.h"
#include "filters/line_budget.h"
#include "filters/open_lines.h"
#include "filters/outline_choice.h"
#include "filters/outline_lines.h"
#include "filters/page_stakes.h"
#include "filters/page_trust.h"
#include "filters/part_room.h"
#include "filters/subject_parts.h"
#include "tactics/filter.h"
#include "tactics/geometry/clipped.h"
#include "tactics/geometry/shape.h"
#include "tactics/units.h"

namespace tactics {

namespace {

constexpr Option kOutlinesOptions[] = {
    {.name = "line",
     .type = Option::Type::length,
     .fallback = kUsualLine,
     .min = 1,
     .max = 100'000,
     .unit = "mm",
     .summary =
         "maximum length of line on a square of 63 mm; on a larger drawing it grows as the side to the power 5/3. More than the "
         "default also draws less likely lines: twice the default, twice the line"},
    {.name = "sure",
     .type = Option::Type::number,
     .fallback = 0.62,
     .min = 0,
     .max = 1,
     .summary = "1: draw only the surest lines; 0: draw everything that anybody might draw, up to the budget"},
    {.name = "gap",
     .type = Option::Type::length,
     .fallback = 4.4,
     .min = 0,
     .max = 50,
     .unit = "mm",
     .summary = "minimum distance between the middles of two lines: a narrower thing gets one line, or none"},
    {.name = "inner",
     .type = Option::Type::number,
     .fallback = 0,
     .min = 0,
     .max = 1,
     .summary = "additional share of line for details inside things: eyes, a mouth, a stripe. A subject always has a few such "
                "lines"},
    {.name = "bend",
     .type = Option::Type::length,
     .fallback = 1.4,
     .min = 0.1,
     .max = 20,
     .unit = "mm",
     .summary = "length over which lines are smoothed (standard deviation)"},
    {.name = "subject",
     .type = Option::Type::spots,
     .summary = "what matters: a box around it or a point in it, from the left and the top of the picture; each names a "
                "separate thing. Its outline is drawn whole and thick; other lines are thin"},
    {.name = "leave", .type = Option::Type::spots, .summary = "boxes in which only the subject is drawn", .choices = kBoxesOnly},
    {.name = "only",
     .type = Option::Type::choice,
     .fallback = 0,
     .min = 0,
     .max = 1,
     .summary = "yes: draw only the subject, if there is one",
     .choices = "no yes"},
};

constexpr float kFull = 255;

// mm: what is shorter is felt as a mark and not as a line that leads somewhere.
constexpr double kFingertip = 8, kTwoFingertips = 16;
// Of the budget of line: what ends freely is to be the exception.
constexpr double kOpenShare = 0.2;
// How sure the map must be of one.
constexpr double kOpenLeast = 0.5;

// Of each pixel: how likely a line would be drawn along its left or upper side.
std::vector<float> worth_of_pixels(const RegionTree& tree, const std::vector<float>& chances, const Parts& parts) {
    std::vector<float> worth(tree.face.size(), 0.0f);
    for (std::size_t i = 0; i < tree.arcs.size(); ++i)
        if (parts.divides(tree.arcs[i]))
            for_each_side(tree.arcs[i], [&](int x, int y) {
                float& w =
                    worth[static_cast<std::size_t>(y) * static_cast<std::size_t>(tree.width) + static_cast<std::size_t>(x)];
                w = std::max(w, chances[i]);
            });
    return worth;
}

// Of each part: whether the picture's frame bounds it.
std::vector<bool> parts_at_frame(const std::vector<std::uint32_t>& part, int width, int height) {
    std::vector<bool> at_frame(*std::max_element(part.begin(), part.end()) + 1u, false);
    const auto wide = static_cast<std::size_t>(width), high = static_cast<std::size_t>(height);
    for (std::size_t x = 0; x < wide; ++x) at_frame[part[x]] = at_frame[part[(high - 1) * wide + x]] = true;
    for (std::size_t y = 0; y < high; ++y) at_frame[part[y * wide]] = at_frame[part[y * wide + wide - 1]] = true;
    return at_frame;
}

// A picture of pixels with a rim of that many around it, in which `fill` is.
template <typename Value>
std::vector<Value> with_rim(const std::vector<Value>& pixels, int width, int height, int rim, Value fill) {
    const auto wide = static_cast<std::ptrdiff_t>(width + 2 * rim);
    std::vector<Value> all(static_cast<std::size_t>(wide) * static_cast<std::size_t>(height + 2 * rim), fill);
    for (int y = 0; y < height; ++y)
        std::copy_n(pixels.begin() + static_cast<std::ptrdiff_t>(y) * width, width, all.begin() + (y + rim) * wide + rim);
    return all;
}

// The things thick, what is in them as ever, the rest thin; without things what parts two of which neither reaches the frame is
// within a larger one, and thin. If nothing else is drawn, things at the picture's frame or at bars are closed along them.
Drawing draw(const RegionTree& tree, const Parts& parts, const NamedThings& things, std::vector<float> chances, bool alone,
             const Settings& settings) {
    const double gap = settings.number("gap") / tree.mm_per_pixel, bend = settings.number("bend") / tree.mm_per_pixel;
    const std::uint32_t most = *std::max_element(parts.part.begin(), parts.part.end());
    const std::uint32_t nothing = most + 1;            // what is left out
    std::vector<std::uint32_t> thing_of(most + 2, 0);  // of each part
    for (std::size_t f = 0; f < parts.part.size(); ++f) thing_of[parts.part[f]] = things.of_face[f];
    for (std::size_t i = 0; i < tree.arcs.size(); ++i)
        if (things.of_face[tree.arcs[i].faces[0]] != things.of_face[tree.arcs[i].faces[1]]) chances[i] = 1;
    std::vector<std::uint32_t> part(tree.face.size());
    for (std::size_t i = 0; i < part.size(); ++i) {
        part[i] = parts.part[tree.face[i]];
        const int x = static_cast<int>(i) % tree.width, y = static_cast<int>(i) / tree.width;
        const PixelBox& inside = tree.inside;
        const bool in_bars = x < inside.left || y < inside.top || x >= inside.right || y >= inside.bottom;
        if (alone && (in_bars || thing_of[part[i]] == 0)) part[i] = nothing;
    }
    const int rim = alone ? static_cast<int>(std::ceil(gap)) + 1 : 0;
    const int width = tree.width + 2 * rim, height = tree.height + 2 * rim;
    part = with_rim(part, tree.width, tree.height, rim, nothing);
    const std::vector<float> worth = with_rim(worth_of_pixels(tree, chances, parts), tree.width, tree.height, rim, 1.0f);
    const RoomyParts roomy =
        gap > 0 ? with_room(std::move(part), worth, width, height, gap) : RoomyParts{std::move(part), InkMap(width, height)};
    std::vector<bool> at_frame = parts_at_frame(roomy.part, width, height);
    at_frame.resize(thing_of.size(), false);
    Drawing drawing = lines_of_parts(roomy, width, height, tree.mm_per_pixel, bend, [&](const RegionArc& arc) {
        const std::uint32_t one = thing_of[arc.faces[0]], other = thing_of[arc.faces[1]];
        if (one != other) return ArcInk{LineClass::thick, kFull, true};
        if (arc.faces[0] == nothing || arc.faces[1] == nothing) return ArcInk{LineClass::normal, 0, false};
        double sum = 0;
        for_each_side(arc, [&](int x, int y) {
            sum += static_cast<double>(
                worth[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)]);
        });
        const bool thin = things.any() ? one == 0 : !at_frame[arc.faces[0]] && !at_frame[arc.faces[1]];
        return ArcInk{thin ? LineClass::thin : LineClass::normal,
                      static_cast<float>(static_cast<double>(kFull) * sum / steps_of(arc)), true};
    });
    const double off = rim * tree.mm_per_pixel;
    drawing.width = tree.width * tree.mm_per_pixel;
    drawing.height = tree.height * tree.mm_per_pixel;
    for (Stroke& stroke : drawing.strokes)
        for (Point& p : stroke.points)
            p = {std::clamp(p.x - off, 0.0, drawing.width), std::clamp(p.y - off, 0.0, drawing.height)};
    return drawing;
}

// The thing at a place, in pixels; 0: none.
std::uint32_t thing_at(const RegionTree& tree, const NamedThings& things, Point p) {
    const int x = std::clamp(static_cast<int>(p.x), 0, tree.width - 1), y = std::clamp(static_cast<int>(p.y), 0, tree.height - 1);
    return things
        .of_face[tree.face[static_cast<std::size_t>(y) * static_cast<std::size_t>(tree.width) + static_cast<std::size_t>(x)]];
}

// The thin things that begin or end at one of the things that are to stand alone. `near`: pixels.
std::vector<RegionLine> lines_at(const RegionTree& tree, const NamedThings& things, double near) {
    const int far = static_cast<int>(std::ceil(near));
    const auto at_thing = [&](Point p) {
        for (int v = -far; v <= far; ++v)
            for (int u = -far; u <= far; ++u)
                if (std::hypot(u, v) <= near && thing_at(tree, things, {p.x + u, p.y + v}) != 0) return true;
        return false;
    };
    std::vector<RegionLine> wanted;
    for (const RegionLine& line : tree.lines)
        if (at_thing(line.points.front()) || at_thing(line.points.back())) wanted.push_back(line);
    return wanted;
}

// What bounds nothing: thin things, and inside of what is drawn what is too small to be a thing.
void add_what_is_open(Drawing& drawing, const RegionTree& tree, const Parts& parts, const NamedThings& things, bool alone,
                      const Settings& settings) {
    const double budget = line_budget(settings.number("line"), drawing.width, drawing.height);
    OpenLines wish{.gap = settings.number("gap"), .bend = settings.number("bend")};
    wish.shortest = kTwoFingertips;
    wish.least = static_cast<float>(kFull * kOpenLeast);
    wish.most = kOpenShare * budget;
    add_open_lines(drawing, alone ? lines_at(tree, things, wish.gap / tree.mm_per_pixel) : tree.lines, tree.mm_per_pixel, wish);
    const double few = things.any() ? tree.mm_per_pixel * room_inside(tree, parts, things) : 0;
    const double most = std::max(few, settings.number("inner") * budget);
    if (most <= 0) return;
    wish.shortest = kFingertip;
    wish.least = static_cast<float>(kFull * kFaint);
    wish.most = most;
    wish.attached = false;
    std::vector<bool> within = things.any() ? std::vector<bool>{} : enclosed_faces(tree, parts);
    if (things.any())
        for (const std::uint32_t thing : things.of_face) within.push_back(thing != 0);
    add_open_lines(drawing, inner_lines_of(tree, parts, within, wish.least), tree.mm_per_pixel, wish);
}

// The pieces of a line, at whose points nothing is in the way, that can be felt as lines.
std::vector<Stroke> pieces_of_outlines(Stroke stroke, const std::vector<bool>& in_the_way) {
    const auto first = std::find(in_the_way.begin(), in_the_way.end(), true) - in_the_way.begin();
    const auto size = static_cast<std::ptrdiff_t>(stroke.points.size());
    if (first == size) return {std::move(stroke)};
    std::vector<Stroke> pieces;
    Stroke piece{{}, false, stroke.line, stroke.strength, stroke.role};
    const auto end = [&] {
        if (piece.points.size() > 1 && length_of(piece.points, false) >= kFingertip) pieces.push_back(piece);
        piece.points.clear();
    };
    for (std::ptrdiff_t k = 0; k < size; ++k) {
        // Round a closed line from what is in the way, so that no piece is parted where the line begins.
        const auto i = static_cast<std::size_t>(stroke.closed ? (first + k) % size : k);
        if (in_the_way[i])
            end();
        else
            piece.points.push_back(stroke.points[i]);
    }
    end();
    return pieces;
}

// In the boxes nothing is drawn but the things; the rest of the page is what it would be without them.
void cut_at_boxes(Drawing& drawing, const RegionTree& tree, const NamedThings& things, const std::vector<Spot>& boxes) {
    if (boxes.empty()) return;
    const auto left_out = [&](Point p) {
        const double x = p.x / drawing.width, y = p.y / drawing.height;
        const bool in = std::any_of(boxes.begin(), boxes.end(),
                                    [&](const Spot& b) { return x >= b.left && x <= b.right && y >= b.top && y <= b.bottom; });
        return in && thing_at(tree, things, {p.x / tree.mm_per_pixel, p.y / tree.mm_per_pixel}) == 0;
    };
    std::vector<Stroke> strokes;
    for (Stroke& stroke : drawing.strokes) {
        std::vector<bool> in_the_way(stroke.points.size(), false);
        if (stroke.line != LineClass::thick)  // a thing's own outline
            std::transform(stroke.points.begin(), stroke.points.end(), in_the_way.begin(), left_out);
        for (Stroke& piece : pieces_of_outlines(std::move(stroke), in_the_way)) strokes.push_back(std::move(piece));
    }
    drawing.strokes = std::move(strokes);
}

// Lines end at the picture's own frame, not at that of the bars around it.
void cut_at_bars(Drawing& drawing, const RegionTree& tree) {
    if (tree.inside == all_of(tree.width, tree.height)) return;
    const double mm = tree.mm_per_pixel;
    const auto [left, top, right, bottom] = tree.inside;
    const Rect inside{left * mm, top * mm, (right - left) * mm, (bottom - top) * mm};
    std::vector<Stroke> strokes;
    for (Stroke& stroke : drawing.strokes) {
        if (std::all_of(stroke.points.begin(), stroke.points.end(), [&](Point p) { return inside.holds(p); })) {
            strokes.push_back(std::move(stroke));
            continue;
        }
        auto pieces = clipped(stroke.points, stroke.closed, inside);
        if (stroke.closed && pieces.size() > 1 && distance(pieces.back().back(), pieces.front().front()) == 0) {
            pieces.back().insert(pieces.back().end(), pieces.front().begin() + 1, pieces.front().end());
            pieces.erase(pieces.begin());
        }
        for (auto& piece : pieces) {
            Stroke part = stroke;
            part.closed = false;
            part.points = std::move(piece);
            strokes.push_back(std::move(part));
        }
    }
    drawing.strokes = std::move(strokes);
}

ChosenSetting settle_outlines(const Artwork& artwork, Settings& settings) {
    const std::vector<Spot>& spots = settings.spots("subject");
    if (spots.empty()) return {};
    const auto& tree = std::get<RegionTree>(artwork);
    return {"subject", words_of(find_things(tree, arc_chances_of(tree).drawn, spots), spots)};
}

Artwork apply_outlines(Artwork artwork, const Settings& settings) {
    const auto& tree = std::get<RegionTree>(artwork);
    const ArcChances chances = arc_chances_of(tree);
    const Stakes stakes = stakes_of(tree, chances, settings.number("sure"));
    const double line = settings.number("line");
    const NamedThings things = find_things(tree, chances.drawn, settings.spots("subject"));
    const bool alone = things.any() && settings.choice("only") == "yes";
    const Parts parts = things.any() ? parts_with_things(tree, chances.drawn, stakes.price, things, alone, line)
                                     : parts_of_page(tree, stakes.worth, stakes.price, line);
    Drawing drawing = draw(tree, parts, things, chances.drawn, alone, settings);
    add_what_is_open(drawing, tree, parts, things, alone, settings);
    if (!alone) cut_at_bars(drawing, tree);
    cut_at_boxes(drawing, tree, things, settings.spots("leave"));
    // What a person points out is on the page, whatever else is; what was pointed at in vain changes nothing. More line than
    // usual, or less, is asked for knowingly, and lines inside of things were not there when this was fitted.
    const bool usual = line == kUsualLine && settings.number("inner") == 0 && settings.spots("leave").empty();
    if (!things.any() && usual) drawing.trust = trust_of(tree, parts, chances.drawn);
    return drawing;
}

}  // namespace

extern const Filter outlines_filter;
const Filter outlines_filter{
    .name = "outlines",
    .summary = "draws whole outlines of the regions that people would draw, up to a budget of line",
    .takes = static_cast<Kinds>(Kind::regions),
    .gives = static_cast<Kinds>(Kind::drawing),
    .options = kOutlinesOptions,
    .apply = apply_outlines,
    .settle = settle_outlines,
    .finishes = static_cast<Kinds>(Kind::regions),
    .budget = "line",
    .in_full = "trace",
};

}  // namespace tactics
