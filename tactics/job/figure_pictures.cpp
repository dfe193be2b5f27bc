// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/figure_pictures.h"

#include <algorithm>
#include <utility>

#include "tactics/geometry/clipped.h"
#include "tactics/geometry/distance.h"
#include "tactics/layout/room.h"

namespace tactics {

namespace {

Rect scaled(const Rect& rect, double scale) {
    return {rect.left * scale, rect.top * scale, rect.width * scale, rect.height * scale};
}

void move(std::vector<Point>& points, const Rect& place) {
    for (Point& p : points) p = {p.x + place.left, p.y + place.top};
}

void lay_into(Drawing& figure, Drawing part, const Rect& place, const Rect& shown) {
    for (Stroke& stroke : part.strokes) {
        move(stroke.points, place);
        const auto pieces = clipped(stroke.points, stroke.closed, shown);
        const bool whole = pieces.size() == 1 && pieces.front().size() == stroke.points.size();
        for (const auto& piece : pieces) {
            if (piece.size() < 2) continue;
            Stroke line = stroke;
            line.points = piece;
            line.closed = stroke.closed && whole;
            figure.strokes.push_back(std::move(line));
        }
    }
    for (Area& area : part.areas) {
        Area kept = area;
        kept.rings.clear();
        for (auto& ring : area.rings) {
            move(ring, place);
            if (auto within = ring_within(std::move(ring), shown); within.size() > 2) kept.rings.push_back(std::move(within));
        }
        if (!kept.rings.empty()) figure.areas.push_back(std::move(kept));
    }
}

}  // namespace

Image turned_over(Image image, bool mirrored, bool upside_down) {
    if (upside_down)
        for (int top = 0, bottom = image.height - 1; top < bottom; ++top, --bottom)
            std::swap_ranges(image.row(top), image.row(top) + image.row_bytes(), image.row(bottom));
    if (mirrored)
        for (int y = 0; y < image.height; ++y)
            for (int left = 0, right = image.width - 1; left < right; ++left, --right)
                std::swap_ranges(image.row(y) + left * image.channels, image.row(y) + (left + 1) * image.channels,
                                 image.row(y) + right * image.channels);
    return image;
}

void take_words(const std::vector<FigurePart>& parts, double width, double height, PrintWords& words) {
    for (const FigurePart& part : parts) {
        const auto on_figure = [&](double x, double y) {
            return Point{100 * (part.place.left + x / 100 * part.place.width) / width,
                         100 * (part.place.top + y / 100 * part.place.height) / height};
        };
        for (ToldWords told : part.drawable.words.told) {
            const Point at = on_figure(told.x, told.y);
            const Point mm{at.x / 100 * width, at.y / 100 * height};
            if (distance(nearest_of(part.shown, mm), mm) > 0) continue;  // a clip hides it
            told.wanted = on_figure(told.wanted.x, told.wanted.y);
            told.x = at.x;
            told.y = at.y;
            told.title = false;
            words.told.push_back(std::move(told));
        }
        words.notes.insert(words.notes.end(), part.drawable.words.notes.begin(), part.drawable.words.notes.end());
    }
}

void draw_parts(const std::vector<FigurePart>& parts, double scale, bool with_words, const Sheet& sheet, Drawing& figure,
                DrawingWay& way) {
    for (const FigurePart& part : parts) {
        const Rect place = scaled(part.place, scale);
        DrawingWay own;
        lay_into(figure, part.drawable.draw(sheet, place, kWhole, with_words ? part.drawable.words : PrintWords{}, own), place,
                 scaled(part.shown, scale));
        way.steps = std::move(own.steps);
        way.chosen.insert(way.chosen.end(), own.chosen.begin(), own.chosen.end());
        if (own.detail) way.detail = std::move(own.detail);
        way.finer = way.finer || own.finer;
    }
}

}  // namespace tactics
