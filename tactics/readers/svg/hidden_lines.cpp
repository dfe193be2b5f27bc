// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/svg/hidden_lines.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tactics/geometry/box.h"
#include "tactics/geometry/course.h"
#include "tactics/geometry/grid.h"
#include "tactics/geometry/vectors.h"
#include "tactics/readers/svg/clip.h"
#include "tactics/text/utf8.h"

namespace tactics {

namespace {

constexpr double kOpaque = 0.95;
constexpr double kLeastCover = 8;  // mm of a figure 200 mm wide or high: smaller ones are marks on lines
constexpr double kAlong = 0.2;     // mm: what runs along the border of a surface is not behind it
constexpr double kLeastPiece = 1;  // mm: of what is left of a line
constexpr std::size_t kMostCovers = 5'000, kMostSides = 10'000'000;  // sides of lines against sides of surfaces

using Rings = std::vector<std::vector<Point>>;

Box box_around(const Rings& rings) {
    Box box = kNothing;
    for (const auto& ring : rings)
        for (const Point p : ring) box.take(p);
    return box;
}

bool is_behind(Point p, const Rings& rings) {
    bool inside = false;
    for (const auto& ring : rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point a = ring[i], b = ring[(i + 1) % ring.size()];
            if (ray_meets(p, a, b)) inside = !inside;
            if (distance_to_segment(p, a, b) < kAlong) return false;
        }
    return inside;
}

// Where the way from a to b meets the rings, as shares of it, and its ends.
std::vector<double> meetings(Point a, Point b, const Rings& rings) {
    std::vector<double> all{0, 1};
    for (const auto& ring : rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point c = ring[i], d = ring[(i + 1) % ring.size()];
            const double turn = cross(b - a, d - c);
            if (turn == 0) continue;
            const double t = cross(c - a, d - c) / turn, u = cross(c - a, b - a) / turn;
            if (t > 0 && t < 1 && u >= 0 && u <= 1) all.push_back(t);
        }
    std::sort(all.begin(), all.end());
    return all;
}

Point at_share(Point a, Point b, double t) { return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}; }

struct SeenLine {
    std::vector<Point> points;
    bool closed = false;
};

// The pieces of a line that are not behind that surface. The line itself: none of it is.
std::vector<SeenLine> seen_of(const SeenLine& line, const Box& box, const Rings& rings) {
    std::vector<SeenLine> pieces;
    std::vector<Point> piece;
    bool any_hidden = false;
    const auto end_piece = [&] {
        if (piece.size() > 1) pieces.push_back({std::move(piece), false});
        piece.clear();
    };
    const std::size_t sides = line.points.size() - (line.closed ? 0 : 1);
    for (std::size_t i = 0; i < sides; ++i) {
        const Point a = line.points[i], b = line.points[(i + 1) % line.points.size()];
        const bool near = meet(box_of({a, b}, 0), box);
        const std::vector<double> places = near ? meetings(a, b, rings) : std::vector<double>{0, 1};
        for (std::size_t k = 1; k < places.size(); ++k) {
            const bool hidden = near && is_behind(at_share(a, b, (places[k - 1] + places[k]) / 2), rings);
            any_hidden = any_hidden || hidden;
            if (hidden) {
                end_piece();
                continue;
            }
            if (piece.empty()) piece.push_back(at_share(a, b, places[k - 1]));
            if (k + 1 == places.size())
                piece.push_back(b);
            else if (is_behind(at_share(a, b, (places[k] + places[k + 1]) / 2), rings))
                piece.push_back(at_share(a, b, places[k]));
        }
    }
    if (!any_hidden) return {line};
    end_piece();
    // A closed line goes on where it began.
    if (line.closed && pieces.size() > 1 && distance(pieces.back().points.back(), pieces.front().points.front()) == 0) {
        std::vector<Point>& first = pieces.front().points;
        std::vector<Point>& last = pieces.back().points;
        last.insert(last.end(), first.begin() + 1, first.end());
        first = std::move(last);
        pieces.pop_back();
    }
    std::erase_if(pieces, [](const SeenLine& one) {
        double length = 0;
        for (std::size_t i = 1; i < one.points.size(); ++i) length += distance(one.points[i - 1], one.points[i]);
        return length < kLeastPiece;
    });
    return pieces;
}

std::size_t sides_of(const Rings& rings) {
    std::size_t sides = 0;
    for (const auto& ring : rings) sides += ring.size();
    return sides;
}

}  // namespace

void add_cover(FoundPage& figure, const std::vector<Subpath>& surface, const Paint& fill, const Rect& clip) {
    if (fill.none || fill.opacity < kOpaque || fill.fades || fill.pattern > 0 || figure.covers.size() >= kMostCovers) return;
    Rings rings = rings_of(surface);
    const Box box = box_around(rings);
    if (std::min(box.width(), box.height()) < kLeastCover) return;
    if (!std::all_of(rings.begin(), rings.end(), [&](const auto& ring) { return lies_in(ring, clip); })) return;
    figure.covers.push_back({std::move(rings), figure.page.strokes.size(), figure.page.areas.size(), figure.words.size()});
}

namespace {

// Its own, or a shape of its own right after it, as many tools draw it.
bool has_outline(const FoundCover& cover, const Page& page) {
    constexpr std::size_t kNext = 4;
    constexpr double kSameBox = 0.5;  // mm
    const Box own = box_around(cover.rings);
    for (std::size_t i = cover.strokes; i < std::min(cover.strokes + kNext, page.strokes.size()); ++i)
        if (same_box(box_of(page.strokes[i].points), own, kSameBox)) return true;
    return false;
}

class Hiding {
public:
    explicit Hiding(FoundPage& figure) : figure_(figure), covers_(figure.covers) {
        std::vector<Box> boxes;
        for (const FoundCover& cover : covers_) boxes.push_back(box_around(cover.rings));
        boxes_ = boxes;
        grid_ = Grid(std::move(boxes), figure.page.width, figure.page.height);
    }

    void hide_lines() {
        std::vector<PageStroke> kept;
        for (std::size_t i = 0; i < figure_.page.strokes.size(); ++i) {
            const PageStroke& stroke = figure_.page.strokes[i];
            std::vector<SeenLine> lines{{stroke.points, stroke.closed}};
            for (const std::size_t c : covers_over(stroke.points, [&](const FoundCover& cover) { return cover.strokes > i; })) {
                work_ += stroke.points.size() * sides_of(covers_[c].rings);
                if (work_ > kMostSides) break;
                std::vector<SeenLine> seen;
                for (const SeenLine& line : lines)
                    for (SeenLine& piece : seen_of(line, boxes_[c], covers_[c].rings)) seen.push_back(std::move(piece));
                lines = std::move(seen);
            }
            for (SeenLine& line : lines) {
                PageStroke& piece = kept.emplace_back(stroke);
                piece.points = std::move(line.points);
                piece.closed = line.closed;
            }
        }
        figure_.page.strokes = std::move(kept);
    }

    void hide_areas() {
        for (std::size_t i = 0; i < figure_.page.areas.size() && work_ <= kMostSides; ++i) {
            Rings& rings = figure_.page.areas[i].rings;
            if (rings.empty()) continue;
            const bool gone = grid_.any_near(box_around(rings), [&](std::size_t c) {
                if (covers_[c].areas <= i) return false;
                work_ += sides_of(rings) * sides_of(covers_[c].rings);
                return work_ <= kMostSides && std::all_of(rings.begin(), rings.end(), [&](const auto& ring) {
                           return std::all_of(ring.begin(), ring.end(), [&](Point p) { return is_behind(p, covers_[c].rings); });
                       });
            });
            if (gone) rings.clear();
        }
    }

    // Copies of a box behind it have its words, too.
    void hide_words() {
        std::vector<Phrase> hidden;
        for (std::size_t i = 0; i < figure_.words.size(); ++i) {
            FoundWords& words = figure_.words[i];
            if (words.text.empty()) continue;
            words.hidden = grid_.any_near(box_of({words.middle, words.middle}, 0), [&](std::size_t c) {
                return covers_[c].words > i && is_behind(words.middle, covers_[c].rings);
            });
            if (words.hidden) hidden.push_back(phrase("\"{0}\"", beginning_of(words.text)));
        }
        if (!hidden.empty())
            figure_.notes.push_back(
                phrase("these words {0} lie behind something else that is drawn, and are left out", row_of(hidden)));
    }

private:
    template <typename Later>
    std::vector<std::size_t> covers_over(const std::vector<Point>& points, Later is_later) const {
        std::vector<std::size_t> over;
        if (points.size() < 2) return over;
        grid_.any_near(box_of(points), [&](std::size_t c) {
            if (is_later(covers_[c])) over.push_back(c);
            return false;
        });
        std::sort(over.begin(), over.end());
        over.erase(std::unique(over.begin(), over.end()), over.end());
        return over;
    }

    FoundPage& figure_;
    const std::vector<FoundCover>& covers_;
    std::vector<Box> boxes_;
    Grid grid_;
    std::size_t work_ = 0;
};

}  // namespace

void hide_behind_covers(FoundPage& figure) {
    std::erase_if(figure.covers, [&](const FoundCover& cover) { return !has_outline(cover, figure.page); });
    if (figure.covers.empty()) return;
    Hiding hiding(figure);
    hiding.hide_lines();
    hiding.hide_areas();
    hiding.hide_words();
}

}  // namespace tactics
