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
#include "tactics/units.h"

namespace tactics {

namespace {

constexpr Option kOptions[] = {
    {.name = "line",
     .type = Option::Type::length,
     .fallback = kUsualLine,
     .min = 1,
     .max = 100'000,
     .unit = "mm",
     .summary =
         "how much line is drawn at most on a square of 63 mm; a larger drawing has more, as its side to the 5/3. More than the "
         "default also draws less likely lines: twice the default, twice the line",
     .choices = ""},
    {.name = "sure",
     .type = Option::Type::number,
     .fallback = 0.62,
     .min = 0,
     .max = 1,
     .unit = "",
     .summary = "1: only what is surest is drawn; 0: all that anybody might draw, up to the budget",
     .choices = ""},
    {.name = "gap",
     .type = Option::Type::length,
     .fallback = 4.4,
     .min = 0,
     .max = 50,
     .unit = "mm",
     .summary = "least distance between the middles of two lines: what is narrower has one line, or none",
     .choices = ""},
    {.name = "inner",
     .type = Option::Type::number,
     .fallback = 0,
     .min = 0,
     .max = 1,
     .unit = "",
     .summary = "share of the line that may be drawn besides for what is inside of things: eyes, a mouth, a stripe. A subject "
                "has a few such lines "
                "in any case",
     .choices = ""},
    {.name = "bend",
     .type = Option::Type::length,
     .fallback = 1.4,
     .min = 0.1,
     .max = 20,
     .unit = "mm",
     .summary = "lines are smoothed over that length (standard deviation)",
     .choices = ""},
    {.name = "subject",
     .type = Option::Type::spots,
     .unit = "",
     .summary = "what matters: a box around it or a point in it, from the left and the top of the picture; each is a thing of "
                "its own. Its outline is "
                "drawn whole and thick, other lines are thin",
     .choices = ""},
    {.name = "leave",
     .type = Option::Type::spots,
     .unit = "",
     .summary = "boxes in which nothing is drawn but the subject",
     .choices = kBoxesOnly},
    {.name = "only",
     .type = Option::Type::choice,
     .fallback = 0,
     .min = 0,
     .max = 1,
     .unit = "",
     .summary = "yes: nothing is drawn but the subject, if there is one",
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

// The pixels in the boxes.
std::vector<bool> pixels_in(const RegionTree& tree, const std::vector<Spot>& boxes) {
    std::vector<bool> in(tree.face.size(), false);
    for (std::size_t i = 0; i < in.size(); ++i) {
        const double x = (static_cast<double>(i % static_cast<std::size_t>(tree.width)) + 0.5) / tree.width;
        const double y = (static_cast<double>(i / static_cast<std::size_t>(tree.width)) + 0.5) / tree.height;
        in[i] = std::any_of(boxes.begin(), boxes.end(),
                            [&](const Spot& b) { return x > b.left && x < b.right && y > b.top && y < b.bottom; });
    }
    return in;
}

// The things thick, what is in them as ever, the rest thin; without things what parts two of which neither reaches the frame is
// within a larger one, and thin. If nothing else is drawn, things at the picture's frame or at bars are closed along them.
Drawing draw(const RegionTree& tree, const Parts& parts, const NamedThings& things, std::vector<float> chances,
             const ThingWishes& wishes, const Settings& settings) {
    const double gap = settings.number("gap") / tree.mm_per_pixel, bend = settings.number("bend") / tree.mm_per_pixel;
    const std::uint32_t most = *std::max_element(parts.part.begin(), parts.part.end());
    const std::uint32_t nothing = most + 1;            // what is left out
    std::vector<std::uint32_t> thing_of(most + 2, 0);  // of each part
    for (std::size_t f = 0; f < parts.part.size(); ++f) thing_of[parts.part[f]] = things.of_face[f];
    for (std::size_t i = 0; i < tree.arcs.size(); ++i)
        if (things.of_face[tree.arcs[i].faces[0]] != things.of_face[tree.arcs[i].faces[1]]) chances[i] = 1;
    const std::vector<bool> left_out = pixels_in(tree, wishes.leave);
    const bool alone = wishes.only && things.any();
    std::vector<std::uint32_t> part(tree.face.size());
    for (std::size_t i = 0; i < part.size(); ++i) {
        part[i] = parts.part[tree.face[i]];
        const int x = static_cast<int>(i) % tree.width, y = static_cast<int>(i) / tree.width;
        const bool in_bars = x < tree.inside[0] || y < tree.inside[1] || x >= tree.inside[2] || y >= tree.inside[3];
        if (alone ? in_bars || thing_of[part[i]] == 0 : left_out[i] && thing_of[part[i]] == 0) part[i] = nothing;
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

// The thin things that are wanted: not those mostly in a box that is to be left out; where things are to stand alone, those that
// begin or end at one.
std::vector<RegionLine> wanted_lines(const RegionTree& tree, const NamedThings& things, const ThingWishes& wishes, double near) {
    if (wishes.leave.empty() && !(wishes.only && things.any())) return tree.lines;
    const std::vector<bool> left_out = pixels_in(tree, wishes.leave);
    const auto pixel_at = [&](double x, double y) {
        const int column = std::clamp(static_cast<int>(x), 0, tree.width - 1),
                  row = std::clamp(static_cast<int>(y), 0, tree.height - 1);
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(tree.width) + static_cast<std::size_t>(column);
    };
    const auto at_thing = [&](Point p) {
        for (double v = -near; v <= near; ++v)
            for (double u = -near; u <= near; ++u)
                if (std::hypot(u, v) <= near && things.of_face[tree.face[pixel_at(p.x + u, p.y + v)]] != 0) return true;
        return false;
    };
    std::vector<RegionLine> wanted;
    for (const RegionLine& line : tree.lines) {
        const auto out =
            std::count_if(line.points.begin(), line.points.end(), [&](Point p) { return left_out[pixel_at(p.x, p.y)]; });
        if (2 * static_cast<std::size_t>(out) > line.points.size()) continue;
        if (!wishes.only || !things.any() || at_thing(line.points.front()) || at_thing(line.points.back()))
            wanted.push_back(line);
    }
    return wanted;
}

// What bounds nothing: thin things, and inside of what is drawn what is too small to be a thing.
void add_what_is_open(Drawing& drawing, const RegionTree& tree, const Parts& parts, const NamedThings& things,
                      const ThingWishes& wishes, const Settings& settings) {
    const double budget = line_budget(settings.number("line"), drawing.width, drawing.height), inner = settings.number("inner");
    OpenLines wish{.gap = settings.number("gap"), .bend = settings.number("bend")};
    wish.shortest = kTwoFingertips;
    wish.least = static_cast<float>(kFull * kOpenLeast);
    wish.most = kOpenShare * budget;
    add_open_lines(drawing, wanted_lines(tree, things, wishes, wish.gap / tree.mm_per_pixel), tree.mm_per_pixel, wish);
    const double most = things.any() ? tree.mm_per_pixel * room_inside(tree, parts, things) : inner * budget;
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

// Lines end at the picture's own frame, not at that of the bars around it.
void cut_at_bars(Drawing& drawing, const RegionTree& tree) {
    if (tree.inside == std::array{0, 0, tree.width, tree.height}) return;
    const double mm = tree.mm_per_pixel;
    const auto [left, top, right, bottom] = tree.inside;
    const Rect inside{left * mm, top * mm, (right - left) * mm, (bottom - top) * mm};
    std::vector<Stroke> strokes;
    for (Stroke& stroke : drawing.strokes) {
        auto pieces = clipped(stroke.points, stroke.closed, inside);
        const bool whole = pieces.size() == 1 && pieces[0].size() == stroke.points.size() + (stroke.closed ? 1 : 0);
        if (whole) {
            strokes.push_back(std::move(stroke));
            continue;
        }
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

std::string settle(const Artwork& artwork, Settings& settings) {
    const std::vector<Spot>& spots = settings.spots("subject");
    if (spots.empty()) return "";
    const auto& tree = std::get<RegionTree>(artwork);
    return "subject: " + words_of(find_things(tree, arc_chances_of(tree).drawn, spots), spots);
}

Artwork apply(Artwork artwork, const Settings& settings) {
    const auto& tree = std::get<RegionTree>(artwork);
    const ArcChances chances = arc_chances_of(tree);
    const Stakes stakes = stakes_of(tree, chances, settings.number("sure"));
    const double line = settings.number("line");
    const ThingWishes wishes{settings.choice("only") == "yes", settings.spots("leave"), stakes.price, most_of_page(tree, line)};
    const auto& spots = settings.spots("subject");
    const bool all = spots.empty() && wishes.leave.empty();
    const NamedThings things = find_things(tree, chances.drawn, spots);
    const Parts parts =
        all ? parts_of_page(tree, stakes.worth, stakes.price, line) : parts_with_things(tree, chances.drawn, things, wishes);
    Drawing drawing = draw(tree, parts, things, chances.drawn, wishes, settings);
    add_what_is_open(drawing, tree, parts, things, wishes, settings);
    if (!wishes.only || !things.any()) cut_at_bars(drawing, tree);
    // What a person points out is on the page, whatever else is; what was pointed at in vain changes nothing. Who asks for less
    // line than usual wants what is surest of it, and misses the rest knowingly.
    const bool usual = line >= kUsualLine && settings.number("inner") == 0;  // as the pages were that it was fitted to
    if (!things.any() && wishes.leave.empty() && usual) drawing.trust = trust_of(tree, parts, chances.drawn);
    return drawing;
}

}  // namespace

extern const Filter outlines_filter;
const Filter outlines_filter{
    .name = "outlines",
    .summary = "whole outlines of the regions that people would draw, up to a budget of line",
    .takes = static_cast<Kinds>(Kind::regions),
    .gives = static_cast<Kinds>(Kind::drawing),
    .uses_colour = false,
    .options = kOptions,
    .apply = apply,
    .settle = settle,
};

}  // namespace tactics
