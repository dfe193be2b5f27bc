// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/svg/chart_parts.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "tactics/layout/chart_told.h"
#include "tactics/readers/svg/chart_bars.h"
#include "tactics/readers/svg/clip.h"
#include "tactics/readers/svg/dash_marks.h"
#include "tactics/readers/svg/hidden_lines.h"
#include "tactics/readers/svg/text_runs.h"

namespace tactics {

namespace {

// A grid is lighter than axes, or dashed. Settings: what gnuplot and others draw in middle grey counts, black rules of a table do
// not.
constexpr double kGridLightness = 0.3;
constexpr std::size_t kLeastOfGrid = 3;  // lines side by side
constexpr double kLongOfGrid = 0.3;      // of the figure's width or height
constexpr double kSamePlace = 0.3;       // mm

bool is_grid_like(const FoundLook& look) {
    return look.fill < 0 && look.line >= 0 && (look.line > kGridLightness || look.dashes > 0);
}

// Straight along the page, and how: 'h', 'v' or 0.
char way_of(const PageStroke& stroke) {
    if (stroke.closed || stroke.points.size() < 2) return 0;
    Extent extent;
    for (const Point& p : stroke.points) extent.add(p);
    if (extent.box.height < kSamePlace && extent.box.width > kSamePlace) return 'h';
    return extent.box.width < kSamePlace && extent.box.height > kSamePlace ? 'v' : 0;
}

// Lines that run the same way and look alike, if some of them begin and end together. Others of them are interrupted, by a
// legend.
void leave_out_grid(FoundPage& figure) {
    struct Row {
        std::vector<std::size_t> strokes;
        std::map<std::pair<long, long>, std::size_t> together;
    };
    std::map<std::tuple<char, long, std::size_t>, Row> rows;
    for (const FoundLook& look : figure.looks) {
        if (!is_grid_like(look)) continue;
        for (std::size_t i = look.stroke; i < look.strokes_end; ++i) {
            const PageStroke& stroke = figure.page.strokes[i];
            const char way = way_of(stroke);
            if (way == 0 || (stroke.role != Role::line && stroke.role != Role::dash)) continue;
            Row& row = rows[{way, std::lround(look.line * 1000), look.dashes}];
            row.strokes.push_back(i);
            const auto along = [&](Point p) { return way == 'h' ? p.x : p.y; };
            const double one = along(stroke.points.front()), other = along(stroke.points.back()), from = std::min(one, other),
                         to = std::max(one, other);
            if (to - from < kLongOfGrid * (way == 'h' ? figure.page.width : figure.page.height)) continue;
            ++row.together[{std::lround(from / kSamePlace), std::lround(to / kSamePlace)}];
        }
    }
    std::size_t gone = 0;
    for (const auto& [key, row] : rows) {
        if (std::none_of(row.together.begin(), row.together.end(), [](const auto& same) { return same.second >= kLeastOfGrid; }))
            continue;
        for (const std::size_t i : row.strokes) figure.page.strokes[i].points.clear();
        gone += row.strokes.size();
    }
    if (gone > 0) figure.notes.push_back(told_of_grid(gone));
}

}  // namespace

void add_look(FoundPage& figure, std::size_t strokes, std::size_t areas, const Style& style, const Ground& ground) {
    const Page& page = figure.page;
    if (page.strokes.size() == strokes && page.areas.size() == areas) return;
    const auto lightness = [&](const Paint& paint) {
        return paint.none ? -1 : paint.pattern > 0 ? paint.pattern : ground.on_white(paint.lightness);
    };
    const bool whole = style.dashes.empty() || style.dashes == "none";
    const std::size_t dashes =
        whole ? 0 : figure.dash_kinds.try_emplace(style.dashes, figure.dash_kinds.size() + 1).first->second;
    FoundLook look{strokes,
                   page.strokes.size(),
                   areas,
                   page.areas.size(),
                   lightness(style.stroke),
                   lightness(style.fill),
                   dashes,
                   marks_of(style.dashes, style.stroke_width)};
    // A straight line has no inside to be filled.
    const auto straight = [](const PageStroke& stroke) { return stroke.points.size() < 3; };
    if (page.areas.size() == areas &&
        std::all_of(page.strokes.begin() + static_cast<std::ptrdiff_t>(strokes), page.strokes.end(), straight))
        look.fill = -1;
    // Gnuplot draws a curve and its sample in one path.
    const bool apart = look.fill < 0 && look.areas_end == areas;
    for (std::size_t i = strokes; apart && i < page.strokes.size(); ++i) {
        look.stroke = i;
        look.strokes_end = i + 1;
        figure.looks.push_back(look);
    }
    if (!apart) figure.looks.push_back(look);
}

Rect box_of(const FoundPage& figure, const FoundLook& look) {
    Extent extent;
    for (std::size_t i = look.stroke; i < look.strokes_end; ++i)
        for (const Point& p : figure.page.strokes[i].points) extent.add(p);
    for (std::size_t i = look.area; i < look.areas_end; ++i)
        for (const auto& ring : figure.page.areas[i].rings)
            for (const Point& p : ring) extent.add(p);
    return extent.box;
}

void tidy_chart(FoundPage& figure, bool with_words) {
    join_text_runs(figure.words);
    leave_out_grid(figure);
    find_chart_bars(figure);
    if (with_words) name_by_legend(figure);
    tell_dashes_apart(figure);
    hide_behind_covers(figure);
    std::erase_if(figure.page.strokes, [](const PageStroke& stroke) { return stroke.points.empty(); });
    std::erase_if(figure.page.areas, [](const Area& area) { return area.rings.empty(); });
    figure.looks.clear();  // their numbers hold no more
    figure.dash_kinds.clear();
}

}  // namespace tactics
