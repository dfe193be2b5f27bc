// SPDX-License-Identifier: Apache-2.0
#include "tactics/layout/tiles.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "tactics/geometry/clipped.h"
#include "tactics/geometry/region_place.h"
#include "tactics/layout/key.h"
#include "tactics/layout/room.h"
#include "tactics/layout/sheet.h"
#include "tactics/layout/title.h"

namespace tactics {

namespace {

// As high as a cell, so that the sheet's name stands between the marks.
double mark_length(const Sheet& sheet) { return std::max(2 * sheet.cell.dot_pitch + sheet.cell.dot, sheet.medium->shortest); }
// Kept clear between the window and the marks; half of the widest line stands out of the window.
double mark_gap(const Sheet& sheet) { return sheet.medium->gap + sheet.medium->thick_line / 2; }

bool holds(const Rect& window, const Rect& rect) {
    constexpr double kSlip = 1e-9;
    return rect.left >= window.left - kSlip && rect.top >= window.top - kSlip &&
           rect.left + rect.width <= window.left + window.width + kSlip &&
           rect.top + rect.height <= window.top + window.height + kSlip;
}

bool holds(const Rect& window, Point p) { return holds(window, Rect{p.x, p.y, 0, 0}); }

void add_stroke(const PageStroke& stroke, const Rect& window, std::vector<PageStroke>& out) {
    if (std::all_of(stroke.points.begin(), stroke.points.end(), [&](Point p) { return holds(window, p); })) {
        out.push_back(stroke);
        return;
    }
    std::vector<std::vector<Point>> pieces = clipped(stroke.points, stroke.closed, window);
    // A closed line that began inside the window: its end continues at its beginning.
    const Point begin = stroke.points[0];
    if (stroke.closed && pieces.size() > 1 && holds(window, begin) && distance(pieces.back().back(), begin) == 0) {
        std::vector<Point>&first = pieces.front(), &last = pieces.back();
        last.insert(last.end(), first.begin() + 1, first.end());
        std::swap(first, last);
        pieces.pop_back();
    }
    for (auto& piece : pieces) out.push_back({std::move(piece), false, stroke.width, stroke.role, stroke.inner});
}

void add_areas(const std::vector<Area>& areas, const Rect& window, std::vector<Area>& out) {
    for (const Area& area : areas) {
        Area within{{}, area.role, area.texture};
        for (const auto& ring : area.rings)
            if (auto points = ring_within(ring, window); points.size() >= 3) within.rings.push_back(std::move(points));
        if (!within.rings.empty()) out.push_back(std::move(within));
    }
}

// Things that are not drawn at all are listed on the first sheet.
void add_regions(const std::vector<Region>& regions, const Rect& window, bool first, std::vector<Region>& out) {
    for (const Region& region : regions) {
        Region within = region;
        within.rings.clear();
        for (const auto& ring : region.rings)
            if (auto points = ring_within(ring, window); points.size() >= 3) within.rings.push_back(std::move(points));
        if (!within.rings.empty() && !holds(window, within.at)) within.at = place_in(within);
        if (!within.rings.empty() || (first && region.rings.empty())) out.push_back(std::move(within));
    }
}

// Whole pixels whose middle lies in the window.
std::optional<Bitmap> picture_within(const Bitmap& picture, const Rect& window) {
    const double across = picture.place.width / picture.width, down = picture.place.height / picture.height;
    const auto first = [](double from, double step, int most) {
        return std::clamp(static_cast<int>(std::ceil(from / step - 0.5 - 1e-9)), 0, most);
    };
    const int left = first(window.left - picture.place.left, across, picture.width);
    const int right = first(window.left + window.width - picture.place.left, across, picture.width);
    const int top = first(window.top - picture.place.top, down, picture.height);
    const int bottom = first(window.top + window.height - picture.place.top, down, picture.height);
    if (left >= right || top >= bottom) return std::nullopt;
    Bitmap part{
        right - left,
        bottom - top,
        {picture.place.left + left * across, picture.place.top + top * down, (right - left) * across, (bottom - top) * down},
        {}};
    part.bits.assign(part.row_bytes() * static_cast<std::size_t>(part.height), 0);
    for (int y = top; y < bottom; ++y)
        for (int x = left; x < right; ++x) {
            const std::uint8_t byte =
                picture.bits[static_cast<std::size_t>(y) * picture.row_bytes() + static_cast<std::size_t>(x / 8)];
            if ((byte >> (7 - x % 8) & 1) == 0) continue;
            std::uint8_t& to =
                part.bits[static_cast<std::size_t>(y - top) * part.row_bytes() + static_cast<std::size_t>((x - left) / 8)];
            to = static_cast<std::uint8_t>(to | 0x80u >> ((x - left) % 8));
        }
    return part;
}

// The cells of a line that are in the window as a whole.
std::optional<BrailleLine> braille_within(const BrailleLine& line, const Page& page, const Rect& window) {
    BrailleLine part{{0, line.first_dot.y}, {}, line.words};
    for (std::size_t i = 0; i < line.cells.size(); ++i) {
        const BrailleLine one{{line.first_dot.x + static_cast<double>(i) * page.cell.cell_pitch, line.first_dot.y},
                              {line.cells[i]}};
        if (!holds(window, extent_of(one, page.cell, page.braille_dot))) continue;
        if (part.cells.empty()) part.first_dot.x = one.first_dot.x;
        part.cells.push_back(line.cells[i]);
    }
    if (part.cells.empty()) return std::nullopt;
    return part;
}

// Marks stand along the line on which two sheets meet, outside of the window: cut one along its marks and lay it on the
// marks of the other.
void add_marks(Page& page, const Cut& cut, int column, int row, const Sheet& sheet) {
    const Rect& window = cut.window;
    const double near = mark_gap(sheet), far = near + mark_length(sheet), width = sheet.medium->thin_line;
    const double across = (window.width - cut.across) / 2, down = (window.height - cut.down) / 2;
    const auto standing = [&](double x) {
        page.strokes.push_back({{{x, window.top - far}, {x, window.top - near}}, false, width, Role::mark});
        page.strokes.push_back(
            {{{x, window.top + window.height + near}, {x, window.top + window.height + far}}, false, width, Role::mark});
    };
    const auto lying = [&](double y) {
        page.strokes.push_back({{{window.left - far, y}, {window.left - near, y}}, false, width, Role::mark});
        page.strokes.push_back(
            {{{window.left + window.width + near, y}, {window.left + window.width + far, y}}, false, width, Role::mark});
    };
    if (column > 0) standing(window.left + across);
    if (column + 1 < sheet.tiles.columns) standing(window.left + window.width - across);
    if (row > 0) lying(window.top + down);
    if (row + 1 < sheet.tiles.rows) lying(window.top + window.height - down);
}

// "b2" above the window, behind the mark that may stand there.
void add_name(Page& page, const Cut& cut, int column, int row, const Sheet& sheet) {
    const double left = cut.window.left + (cut.window.width - cut.across) / 2 + sheet.medium->thin_line / 2 + mark_gap(sheet);
    const double top = cut.window.top - mark_gap(sheet) - mark_length(sheet);
    const auto letter = static_cast<char>('a' + row);
    const int words = static_cast<int>(page.words.size());
    page.words.push_back({WordsKind::mark, std::string{letter, static_cast<char>('1' + column)}});
    if (sheet.braille_table.empty()) {
        constexpr double kSize = 4.94;  // mm, as of the title
        page.print.push_back({{left, top + kAscent * kSize}, kSize, page.words.back().text, words});
        return;
    }
    constexpr std::uint8_t kNumberSign = 0b111100;  // dots 3456; digits are the letters from a on
    const double dot = sheet.cell.dot / 2;
    page.braille.push_back(
        {{left + dot, top + dot}, {letter_cell(letter), kNumberSign, letter_cell(static_cast<char>('a' + column))}, words});
}

}  // namespace

std::optional<Cut> cut_of(double width, double height, const Rect& live, const Sheet& sheet) {
    // A cell of eight dots fits in, so that each is whole on one sheet; 1 cm is enough to glue. Own choice.
    const double shared = std::max(10.0, 3 * sheet.cell.dot_pitch + sheet.cell.dot);
    const double ring = mark_gap(sheet) + mark_length(sheet);
    const auto step = [&](double room, double pitch) { return std::floor((room - 2 * ring - shared) / pitch + 1e-9) * pitch; };
    Cut cut{width, height, live, {}, step(live.width, sheet.cell.cell_pitch), step(live.height, sheet.cell.line_pitch), {}};
    if (!(cut.across > 2 * shared) || !(cut.down > 2 * shared)) return std::nullopt;
    cut.window = {live.left + ring, live.top + ring, cut.across + shared, cut.down + shared};
    cut.whole = {cut.window.left, cut.window.top, cut.across * sheet.tiles.columns + shared,
                 cut.down * sheet.tiles.rows + shared};
    return cut;
}

std::vector<Rect> windows_of(const Cut& cut, const Sheet& sheet) {
    std::vector<Rect> windows;
    for (int row = 0; row < sheet.tiles.rows; ++row)
        for (int column = 0; column < sheet.tiles.columns; ++column)
            windows.push_back(
                {cut.window.left + column * cut.across, cut.window.top + row * cut.down, cut.window.width, cut.window.height});
    return windows;
}

std::vector<Page> cut_up(const Page& page, const Cut& cut, const Sheet& sheet) {
    const std::vector<Rect> windows = windows_of(cut, sheet);
    std::vector<Page> sheets;
    for (int row = 0; row < sheet.tiles.rows; ++row)
        for (int column = 0; column < sheet.tiles.columns; ++column) {
            const Rect& window = windows[sheets.size()];
            Page& part = sheets.emplace_back(empty_like(page));
            part.description = page.description;
            if (sheets.size() == 1) {
                part.title = page.title;
                part.caption = page.caption;
            }
            for (const PageStroke& stroke : page.strokes) add_stroke(stroke, window, part.strokes);
            add_areas(page.areas, window, part.areas);
            add_areas(page.textured, window, part.textured);
            add_regions(page.regions, window, sheets.size() == 1, part.regions);
            part.remarks = page.remarks;
            if (page.picture) part.picture = picture_within(*page.picture, window);
            for (const BrailleLine& line : page.braille)
                if (auto within = braille_within(line, page, window)) part.braille.push_back(std::move(*within));
            for (const PrintLine& line : page.print)  // the title's and the scale bar's, which are on one sheet as a whole
                if (holds(window, line.baseline)) part.print.push_back(line);
            for (const PageName& name : page.names)
                if (holds(window, name.place)) part.names.push_back(name);
            if (page.scale && holds(window, page.scale->place)) part.scale = page.scale;
            part.words = page.words;
            part.drawing = page.drawing;
            move_by(part, cut.window.left - window.left, cut.window.top - window.top);
            part.width = cut.width;
            part.height = cut.height;
            part.live = cut.live;
            add_marks(part, cut, column, row, sheet);
            add_name(part, cut, column, row, sheet);
            // The pages of a key are of all sheets.
            drop_unset_words(part);
        }
    return sheets;
}

}  // namespace tactics
