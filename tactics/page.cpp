// SPDX-License-Identifier: Apache-2.0
#include "tactics/page.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace tactics {

double width_of(LineClass line, const Medium& medium) {
    const double width = line == LineClass::thin ? medium.thin_line : line == LineClass::normal ? medium.line : medium.thick_line;
    return std::max(width, medium.thin_line);
}

LineKind kind_of(const PageStroke& stroke) {
    switch (stroke.role) {
        case Role::axis:
        case Role::tick:
        case Role::lead:
        case Role::scale:
        case Role::mark: return LineKind::values;
        case Role::grid: return LineKind::grid;
        case Role::pattern: return LineKind::pattern;
        case Role::line:
        case Role::dash:
        case Role::dots:
        case Role::arrow:
        case Role::symbol: break;
    }
    return stroke.inner ? LineKind::inner : LineKind::drawn;
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
    for (PageWords& words : page.words) move(words.at);
    move_rect(page.drawing);
}

namespace {

constexpr std::array<std::string_view, 8> kWordsKinds{"title", "caption", "name", "letters", "key", "label", "scale", "mark"};

// Divided, not multiplied by a hundredth: so it is the number that its decimal digits are read as. Nothing is below 0: -0 is 0.
double on_steps(double mm) { return std::round(mm * (1 / kPageStep)) / (1 / kPageStep) + 0.0; }

}  // namespace

std::string_view name_of(WordsKind kind) { return kWordsKinds[static_cast<std::size_t>(kind)]; }

std::optional<WordsKind> words_named(std::string_view name) {
    const auto found = std::find(kWordsKinds.begin(), kWordsKinds.end(), name);
    if (found == kWordsKinds.end()) return std::nullopt;
    return static_cast<WordsKind>(found - kWordsKinds.begin());
}

Point on_steps(Point p) { return {on_steps(p.x), on_steps(p.y)}; }

std::vector<Point> on_steps(const std::vector<Point>& points) {
    std::vector<Point> out;
    out.reserve(points.size());
    for (const Point& each : points) {
        const Point p = on_steps(each);
        if (out.size() > 1 && out.back().x == p.x && out.back().y == p.y) continue;
        out.push_back(p);
    }
    // The second may fall on the first if others follow.
    if (out.size() > 2 && out[0].x == out[1].x && out[0].y == out[1].y) out.erase(out.begin());
    return out;
}

void put_on_steps(Page& page) {
    // The last ones on a sheet whose sides lie between steps.
    const double right = std::floor(page.width / kPageStep + 1e-6) * kPageStep;
    const double bottom = std::floor(page.height / kPageStep + 1e-6) * kPageStep;
    const auto stepped = [&](std::vector<Point> points) {
        for (Point& p : points) p = {std::min(p.x, right), std::min(p.y, bottom)};
        points = on_steps(points);
        // 8.5 in is a little less than 215.9 mm.
        for (Point& p : points) p = {std::min(p.x, page.width), std::min(p.y, page.height)};
        return points;
    };
    for (PageStroke& stroke : page.strokes) {
        stroke.points = stepped(std::move(stroke.points));
        stroke.width = on_steps(stroke.width);
        if (stroke.points.size() < 3) stroke.closed = false;
    }
    const auto put = [&](std::vector<std::vector<Point>>& rings) {
        for (auto& ring : rings) ring = stepped(std::move(ring));
        std::erase_if(rings, [](const auto& ring) { return ring.size() < 3; });
    };
    for (auto* areas : {&page.areas, &page.textured}) {
        for (Area& area : *areas) put(area.rings);
        std::erase_if(*areas, [](const Area& area) { return area.rings.empty(); });
    }
    for (Region& region : page.regions) {
        region.at = on_steps(region.at);
        put(region.rings);
    }
}

void drop_unset_words(Page& page) {
    std::vector<int> number(page.words.size(), -1);
    const auto each = [&](const auto& visit) {
        for (BrailleLine& line : page.braille) visit(line.words);
        for (PrintLine& line : page.print) visit(line.words);
        for (PageName& name : page.names) visit(name.words);
    };
    each([&](int words) {
        if (words >= 0) number[static_cast<std::size_t>(words)] = 0;
    });
    std::vector<PageWords> kept;
    for (std::size_t i = 0; i < page.words.size(); ++i) {
        if (number[i] < 0 && page.words[i].kind != WordsKind::key) continue;
        number[i] = static_cast<int>(kept.size());
        kept.push_back(std::move(page.words[i]));
    }
    page.words = std::move(kept);
    each([&](int& words) {
        if (words >= 0) words = number[static_cast<std::size_t>(words)];
    });
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
    empty.heights = page.heights;
    empty.braille_table = page.braille_table;
    empty.language = page.language;
    empty.medium = page.medium;
    return empty;
}

}  // namespace tactics
