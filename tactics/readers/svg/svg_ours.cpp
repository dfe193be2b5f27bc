// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/svg/svg_ours.h"

#include <algorithm>
#include <span>
#include <string_view>

#include "tactics/geometry/box.h"
#include "tactics/geometry/region_place.h"
#include "tactics/layout/own_marks.h"
#include "tactics/layout/room.h"
#include "tactics/readers/svg/svg_path.h"
#include "tactics/text/utf8.h"
#include "tactics/units.h"

namespace tactics {

namespace {

// Of a class "tactics-cells-0711" with the beginning "cells-": "0711".
std::optional<std::string_view> told(const Element& element, std::string_view beginning) {
    constexpr std::string_view kOurs = "tactics-", kBlanks = " \t\n\r";
    std::string_view rest = element.attribute("class");
    while (!rest.empty()) {
        const auto end = rest.find_first_of(kBlanks);
        std::string_view name = rest.substr(0, end);
        rest.remove_prefix(end == rest.npos ? rest.size() : end + 1);
        if (!name.starts_with(kOurs)) continue;
        name.remove_prefix(kOurs.size());
        if (name.starts_with(beginning)) return name.substr(beginning.size());
    }
    return std::nullopt;
}

std::optional<unsigned> digit(char c) {
    if (c >= '0' && c <= '9') return static_cast<unsigned>(c - '0');
    if (c >= 'a' && c <= 'f') return static_cast<unsigned>(c - 'a') + 10;
    return std::nullopt;
}

// The line of those cells whose dots are just these discs, in their order.
std::optional<BrailleLine> braille_of(std::string_view cells, std::span<const Disc> discs, const CellSize& cell) {
    if (cells.size() % 2 != 0 || discs.empty()) return std::nullopt;
    BrailleLine line;
    for (std::size_t i = 0; i < cells.size(); i += 2) {
        const auto high = digit(cells[i]), low = digit(cells[i + 1]);
        if (!high || !low) return std::nullopt;
        line.cells.push_back(static_cast<std::uint8_t>(*high << 4 | *low));
    }
    const std::vector<Point> dots = dots_of(line, cell);
    if (dots.size() != discs.size()) return std::nullopt;
    for (std::size_t i = 0; i < dots.size(); ++i) {
        line.first_dot.x += (discs[i].middle.x - dots[i].x) / static_cast<double>(dots.size());
        line.first_dot.y += (discs[i].middle.y - dots[i].y) / static_cast<double>(dots.size());
    }
    constexpr double kOff = 0.05;  // mm; a file has hundredths
    for (std::size_t i = 0; i < dots.size(); ++i)
        if (distance(discs[i].middle, {line.first_dot.x + dots[i].x, line.first_dot.y + dots[i].y}) > kOff) return std::nullopt;
    return line;
}

// Around all of these lines.
Rect extent_of(std::span<const BrailleLine> lines, const Page& page) {
    Rect all = extent_of(lines[0], page.cell, page.braille_dot);
    for (const BrailleLine& line : lines.subspan(1)) {
        const Rect one = extent_of(line, page.cell, page.braille_dot);
        const double right = std::max(all.left + all.width, one.left + one.width);
        const double bottom = std::max(all.top + all.height, one.top + one.height);
        all.left = std::min(all.left, one.left);
        all.top = std::min(all.top, one.top);
        all.width = right - all.left;
        all.height = bottom - all.top;
    }
    return all;
}

}  // namespace

Role role_told(const Element& shape) { return role_named(told(shape, "").value_or("")); }

int texture_told(const Element& shape) {
    const auto number = told(shape, "texture-").value_or("");
    return number.size() == 1 && number[0] >= '1' && number[0] <= '9' ? number[0] - '0' : 0;
}

std::optional<CellSize> cell_told(const Element& group, double scale) {
    auto rest = told(group, "cell-");
    if (!rest) return std::nullopt;
    CellSize cell;
    for (double* size : {&cell.dot_pitch, &cell.cell_pitch, &cell.line_pitch, &cell.dot}) {
        const auto end = rest->find('-');
        const auto number = parse_number(rest->substr(0, end));
        if (!number || !(*number > 0 && *number < 1000)) return std::nullopt;
        *size = *number * scale;
        rest->remove_prefix(end == rest->npos ? rest->size() : end + 1);
    }
    return cell;
}

bool tells_cells(const Element& group) { return told(group, "cells-").has_value(); }

bool tells_words(const Element& group) {
    const auto layer = group.attribute(marks::kLayer);
    return layer == marks::kWordsLayer || layer == marks::kTitleLayer;
}

bool take_region(const Element& shape, const Transform& transform, Page& page) {
    if (shape.name != "path" || told(shape, "region") != "") return false;
    Pen pen(transform);
    draw_path(shape.attribute("d"), pen);
    Region region;
    region.path = to_line(shape.attribute("data-path"));
    region.rings = rings_of(pen.finish());
    for (const Element& child : shape.children) {
        if (child.name == "title") region.name = to_line(child.text);
        if (child.name == "desc") region.description = to_line(child.text);
    }
    const Box box = box_of(region);
    const Rect sheet{0, 0, page.width, page.height};
    if (region.name.empty() || region.rings.empty() || !sheet.holds({box.left, box.top}) || !sheet.holds({box.right, box.bottom}))
        return true;
    region.at = place_in(region);
    page.regions.push_back(std::move(region));
    return true;
}

void settle_group(const Element& group, const std::optional<CellSize>& cell, std::vector<Disc>& discs, std::size_t disc,
                  std::size_t line, Page& page) {
    const auto cells = told(group, "cells-");
    if (cells && cell)
        if (auto found = braille_of(*cells, std::span(discs).subspan(disc), *cell)) {
            page.cell = *cell;
            page.braille_dot = discs[disc].diameter;
            page.braille.push_back(std::move(*found));
            discs.resize(disc);
        }
    if (told(group, "is-key")) page.is_key = true;
    if (!told(group, "name") || page.braille.size() <= line) return;
    const Rect place = extent_of(std::span(page.braille).subspan(line), page);
    page.names.push_back(
        {to_line(group.attribute("aria-label")), std::string(told(group, "key-").value_or("")), place.middle(), place});
}

}  // namespace tactics
