// SPDX-License-Identifier: Apache-2.0
#include "tactics/page.h"

#include <algorithm>

namespace tactics {

double width_of(LineClass line, const Medium& medium) {
    const double width = line == LineClass::thin ? medium.thin_line : line == LineClass::normal ? medium.line : medium.thick_line;
    return std::max(width, medium.thin_line);
}

Bitmap to_bitmap(const Image& image, const Rect& place) {
    Bitmap bitmap{image.width, image.height, place, {}};
    bitmap.bits.assign(bitmap.row_bytes() * static_cast<std::size_t>(image.height), 0);
    for (int y = 0; y < image.height; ++y) {
        const std::uint8_t* from = image.row(y);
        std::uint8_t* to = bitmap.bits.data() + bitmap.row_bytes() * static_cast<std::size_t>(y);
        for (int x = 0; x < image.width; ++x)
            to[x / 8] = static_cast<std::uint8_t>(to[x / 8] | ((from[x] < 128 ? 0x80u : 0u) >> (x % 8)));
    }
    return bitmap;
}

double total_stroke_length(const Page& page) {
    double length = 0;
    for (const PageStroke& stroke : page.strokes)
        if (stroke.role != Role::pattern) length += length_of({stroke.points, stroke.closed});
    return length;
}

void move_by(Page& page, double right, double down) {
    const auto move = [&](Point& point) { point = {point.x + right, point.y + down}; };
    const auto move_rect = [&](Rect& rect) {
        rect.left += right;
        rect.top += down;
    };
    move_rect(page.live);
    for (PageStroke& stroke : page.strokes)
        for (Point& point : stroke.points) move(point);
    for (auto* areas : {&page.areas, &page.textured})
        for (Area& area : *areas)
            for (auto& points : area.rings)
                for (Point& point : points) move(point);
    for (Region& region : page.regions) {
        move(region.at);
        for (auto& points : region.rings)
            for (Point& point : points) move(point);
    }
    if (page.picture) move_rect(page.picture->place);
    for (BrailleLine& line : page.braille) move(line.first_dot);
    for (PrintLine& line : page.print) move(line.baseline);
    for (PageName& name : page.names) {
        move(name.thing);
        move_rect(name.place);
    }
    if (page.scale) move_rect(page.scale->place);
}

bool is_blank(const Page& page) {
    return page.strokes.empty() && page.areas.empty() && !page.picture && page.braille.empty() && page.print.empty();
}

Page empty_like(const Page& page) {
    Page empty;
    empty.width = page.width;
    empty.height = page.height;
    empty.live = page.live;
    empty.braille_dot = page.braille_dot;
    empty.cell = page.cell;
    empty.bed = page.bed;
    empty.braille_table = page.braille_table;
    empty.language = page.language;
    return empty;
}

}  // namespace tactics
