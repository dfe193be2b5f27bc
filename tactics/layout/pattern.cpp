// SPDX-License-Identifier: Apache-2.0
#include "tactics/layout/pattern.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tactics/error.h"
#include "tactics/geometry/spans.h"
#include "tactics/layout/dot_grid.h"
#include "tactics/layout/label.h"
#include "tactics/layout/room.h"
#include "tactics/layout/texture.h"
#include "tactics/layout/title.h"

namespace tactics {

namespace {

// The amount by which a file's rounding to hundredths of a millimetre can reduce a distance.
constexpr double kRounded = 0.02;

struct Side {
    Point a, b;
};

// Nothing of a pattern comes nearer to the side than `reach`.
struct Obstacle {
    Side side;
    double reach = 0;
};

struct Border {
    Side side;
    std::size_t area = 0;  // even-odd within each
    bool open = false;     // the pattern may be inside it; else it must not
};

// All that a pattern has to do with, along rows of the page, which is turned so that they are level.
struct Ground {
    std::vector<Obstacle> obstacles;
    std::vector<Border> borders;

    void add_line(const std::vector<Point>& points, bool closed, double reach) {
        for (std::size_t i = 0; i + 1 < points.size(); ++i) obstacles.push_back({{points[i], points[i + 1]}, reach});
        if (closed || points.size() == 1) obstacles.push_back({{points.back(), points.front()}, reach});
    }
    void add_area(const Area& area, bool open) {
        for (const auto& ring : area.rings)
            for (std::size_t i = 0; i < ring.size(); ++i)
                borders.push_back({{ring[i], ring[i + 1 < ring.size() ? i + 1 : 0]}, areas_, open});
        ++areas_;
    }
    void add_black(const Area& area, double reach) {
        for (const auto& ring : area.rings)
            if (!ring.empty()) add_line(ring, true, reach);
        add_area(area, false);
    }
    void add_box(const Rect& r, double reach) {
        add_black(
            {{{{r.left, r.top}, {r.left + r.width, r.top}, {r.left + r.width, r.top + r.height}, {r.left, r.top + r.height}}}},
            reach);
    }
    template <typename Turn>
    void turn(const Turn& turned) {
        for (Obstacle& o : obstacles) o.side = {turned(o.side.a), turned(o.side.b)};
        for (Border& b : borders) b.side = {turned(b.side.a), turned(b.side.b)};
    }

private:
    std::size_t areas_ = 0;
};

// Things that cross rows: which of the background's things, and down to where.
struct Meeting {
    std::size_t index;
    double bottom;
};

// The first row that meets each of the `things`; `reach_of` gives the distance beyond its side within which each counts.
template <typename Thing, typename Reach>
std::vector<std::vector<Meeting>> first_met(const std::vector<Thing>& things, const std::vector<double>& rows,
                                            const Reach& reach_of) {
    std::vector<std::vector<Meeting>> met(rows.size());
    for (std::size_t i = 0; i < things.size(); ++i) {
        const Side& side = things[i].side;
        const double top = std::min(side.a.y, side.b.y) - reach_of(things[i]);
        const double bottom = std::max(side.a.y, side.b.y) + reach_of(things[i]);
        const auto first = std::lower_bound(rows.begin(), rows.end(), top);
        if (first != rows.end() && *first <= bottom) met[static_cast<std::size_t>(first - rows.begin())].push_back({i, bottom});
    }
    return met;
}

// From one row to the next at `y`.
void go_down(std::vector<Meeting>& active, const std::vector<Meeting>& fresh, double y) {
    std::erase_if(active, [y](const Meeting& m) { return m.bottom < y; });
    active.insert(active.end(), fresh.begin(), fresh.end());
}

// One row's spans, kept from row to row for their memory.
struct RowSpans {
    std::vector<Span> inside, taken;

    // Within areas that are open for the pattern, and within others.
    void cross_areas(const Ground& ground, const std::vector<Meeting>& met, double y) {
        crossings_.clear();
        inside.clear();
        taken.clear();
        for (const Meeting& m : met) {
            const auto& [s, area, open] = ground.borders[m.index];
            if ((s.a.y > y) != (s.b.y > y))
                crossings_.push_back({area, s.a.x + (y - s.a.y) / (s.b.y - s.a.y) * (s.b.x - s.a.x), open});
        }
        std::sort(crossings_.begin(), crossings_.end(),
                  [](const Crossing& a, const Crossing& b) { return a.area != b.area ? a.area < b.area : a.x < b.x; });
        for (std::size_t i = 0; i + 1 < crossings_.size(); i += 2)
            (crossings_[i].open ? inside : taken).push_back({crossings_[i].x, crossings_[i + 1].x});
    }

    void take_obstacles(const Ground& ground, const std::vector<Meeting>& near, double y) {
        Span span;
        for (const Meeting& m : near)
            if (const auto& [side, reach] = ground.obstacles[m.index]; span_within(side.a, side.b, reach, y, span))
                taken.push_back(span);
    }

    std::vector<Span> free() {
        std::sort(inside.begin(), inside.end());
        std::sort(taken.begin(), taken.end());
        // Areas should not lie over each other; where they do, each span is used once.
        for (std::size_t i = 1; i < inside.size(); ++i) inside[i].first = std::max(inside[i].first, inside[i - 1].second);
        std::erase_if(inside, [](const Span& s) { return s.first >= s.second; });
        return without(inside, taken);
    }

private:
    struct Crossing {
        std::size_t area;
        double x;
        bool open;
    };
    std::vector<Crossing> crossings_;
};

// Calls visit(row, spans) for each row, in their order, with the spans that are free for the pattern.
template <typename Visit>
void for_each_row(const Ground& ground, const std::vector<double>& rows, const Visit& visit) {
    const auto obstacles = first_met(ground.obstacles, rows, [](const Obstacle& o) { return o.reach; });
    const auto borders = first_met(ground.borders, rows, [](const Border&) { return 0.0; });
    std::vector<Meeting> near, met;
    RowSpans spans;
    for (std::size_t row = 0; row < rows.size(); ++row) {
        go_down(near, obstacles[row], rows[row]);
        go_down(met, borders[row], rows[row]);
        spans.cross_areas(ground, met, rows[row]);
        if (spans.inside.empty()) continue;
        spans.take_obstacles(ground, near, rows[row]);
        visit(row, spans.free());
    }
}

class Pattern {
public:
    Pattern(const Page& page, const Medium& medium, const Rect& cells, int texture)
        : page_(page),
          medium_(medium),
          cells_(cells),
          number_(texture),
          texture_(textures()[static_cast<std::size_t>(texture - 1)]),
          width_(has_fixed_dots(medium) ? medium.line : std::max(medium.thin_line, texture_.width * medium.line)) {}

    void draw(std::vector<PageStroke>& out) {
        look_around();
        if (has_fixed_dots(medium_))
            draw_dots(out);
        else
            draw_rows(out);
    }

private:
    void look_around() {
        const auto clear = [&](double width, double gap) {
            return std::max(least_apart(medium_, width, width_), gap + (width + width_) / 2) + kRounded;
        };
        for (const Area& area : page_.textured) {
            if (area.texture == number_) ground_.add_area(area, true);
            for (const auto& ring : area.rings)
                if (!ring.empty()) ground_.add_line(ring, true, (least_apart(medium_, 0, 0) + width_) / 2);
        }
        for (const PageStroke& stroke : page_.strokes)
            if (stroke.role != Role::pattern && !stroke.points.empty())
                ground_.add_line(stroke.points, stroke.closed, clear(stroke.width, medium_.gap));
        for (const Area& area : page_.areas) ground_.add_black(area, clear(0, medium_.gap));
        for (const BrailleLine& line : page_.braille)
            if (!line.cells.empty()) ground_.add_box(extent_of(line, page_.cell, page_.braille_dot), clear(0, kFromBraille));
        for (const PrintLine& line : page_.print) ground_.add_box(extent_of(line), clear(0, 0));
    }

    // More whole cells, `dots` each, on both sides, as far as they fit.
    static void go_on(std::vector<double>& centres, std::size_t dots, double pitch, double low, double high) {
        constexpr double kSlip = 1e-6;
        const std::vector<double> cell(centres.begin(), centres.begin() + static_cast<std::ptrdiff_t>(dots));
        for (int k = 1; cell[0] - k * pitch >= low - kSlip; ++k)
            for (std::size_t i = dots; i-- > 0;) centres.insert(centres.begin(), cell[i] - k * pitch);
        while (centres.back() + pitch <= high + kSlip)
            for (std::size_t i = 0; i < dots; ++i) centres.push_back(centres[centres.size() - dots] + pitch);
    }

    void draw_dots(std::vector<PageStroke>& out) const {
        DotGrid grid = page_.bed ? dot_grid(page_) : cell_grid(cells_, page_.cell);
        if (!page_.bed) {
            go_on(grid.columns, 2, page_.cell.cell_pitch, page_.live.left, page_.live.left + page_.live.width);
            go_on(grid.rows, 3, page_.cell.line_pitch, page_.live.top, page_.live.top + page_.live.height);
        }
        // Each may become a mark; a sheet of 3 m has this many.
        constexpr std::size_t kMostDots = 2'000'000;
        if (grid.columns.size() * grid.rows.size() > kMostDots)
            throw Error(Fault::usage, "", phrase("the page has over 2 million dots, too many for textures; take smaller paper"));
        std::vector<std::string_view> tile;
        for (std::string_view rest = texture_.tile;; rest.remove_prefix(tile.back().size() + 1)) {
            tile.push_back(rest.substr(0, rest.find('/')));
            if (tile.back().size() == rest.size()) break;
        }
        for_each_row(ground_, grid.rows, [&](std::size_t row, const std::vector<Span>& spans) {
            const std::string_view marks = tile[row % tile.size()];
            for (const auto& [from, to] : spans) {
                auto column = std::lower_bound(grid.columns.begin(), grid.columns.end(), from);
                for (; column != grid.columns.end() && *column <= to; ++column)
                    if (marks[static_cast<std::size_t>(column - grid.columns.begin()) % marks.size()] == '#')
                        out.push_back(mark({*column, grid.rows[row]}, {*column, grid.rows[row]}));
            }
        });
    }

    void draw_rows(std::vector<PageStroke>& out) {
        const double turn = texture_.degrees * std::numbers::pi / 180, cosine = std::cos(turn), sine = std::sin(turn);
        ground_.turn([&](Point p) { return Point{p.x * cosine + p.y * sine, p.y * cosine - p.x * sine}; });
        double top = 1e300, bottom = -1e300;
        for (const Border& border : ground_.borders)
            if (border.open) {
                top = std::min({top, border.side.a.y, border.side.b.y});
                bottom = std::max({bottom, border.side.a.y, border.side.b.y});
            }
        if (!(top < bottom)) return;

        // White grows with what the medium asks for between two things.
        const Medium& swell = media()[0];
        const double wider = medium_.gap / swell.gap;
        double down = texture_.between_rows * wider + width_, along = texture_.length + texture_.along_row * wider + width_;
        constexpr double kMostMarks = 500'000;
        const double marks = page_.width * page_.height / (down * std::min(along, std::hypot(page_.width, page_.height)));
        if (const double many = std::sqrt(marks / kMostMarks); many > 1) {
            down *= many;
            along *= many;
        }
        std::vector<double> rows;
        const double first = std::ceil(top / down);
        for (double k = first; k * down < bottom; ++k) rows.push_back(k * down);

        const auto back = [&](double x, double y) { return Point{x * cosine - y * sine, x * sine + y * cosine}; };
        // A shorter piece of a line would be a dot.
        const double shortest = std::min(texture_.length / 2, medium_.gap);
        for_each_row(ground_, rows, [&](std::size_t row, const std::vector<Span>& spans) {
            const double y = rows[row];
            const auto add = [&](double from, double to) {
                if (to - from >= shortest) out.push_back(mark(back(from, y), back(to, y)));
            };
            const double start = texture_.staggered && std::fmod(first + static_cast<double>(row), 2) != 0 ? along / 2 : 0;
            for (const auto& [from, to] : spans) {
                if (texture_.endless()) {
                    add(from, to);
                    continue;
                }
                for (double x = std::ceil((from - start - texture_.length) / along) * along + start; x <= to; x += along)
                    add(std::max(x, from), std::min(x + texture_.length, to));
            }
        });
    }

    PageStroke mark(Point from, Point to) const { return {{from, to}, false, width_, Role::pattern}; }

    const Page& page_;
    const Medium& medium_;
    Rect cells_;
    int number_;
    const Texture& texture_;
    double width_;
    Ground ground_;
};

}  // namespace

void draw_patterns(Page& page, const Medium& medium, const Rect& cells) {
    if (page.textured.empty()) return;
    std::vector<PageStroke> marks;
    for (int texture = 1; texture <= static_cast<int>(textures().size()); ++texture)
        if (std::any_of(page.textured.begin(), page.textured.end(), [&](const Area& area) { return area.texture == texture; }))
            Pattern(page, medium, cells, texture).draw(marks);
    page.strokes.insert(page.strokes.end(), marks.begin(), marks.end());
}

}  // namespace tactics
