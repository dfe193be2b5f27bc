// SPDX-License-Identifier: Apache-2.0
#include "tactics/layout/room.h"

#include <algorithm>
#include <cmath>

#include "tactics/layout/title.h"

namespace tactics {

namespace {

constexpr double kFinest = 0.5;       // mm
constexpr double kMostSquares = 5e7;  // of a page of many sheets they are larger
constexpr int kStrip = 64;            // rows of squares; a word is 20 high

double square_of(const Page& page) { return std::max(kFinest, std::sqrt(page.width * page.height / kMostSquares)); }

// Like std::hypot, which is much slower, for lengths on a page.
double length_of(double x, double y) { return std::sqrt(x * x + y * y); }

// Of a place from what begins there and is that long.
double away_from(double begin, double length, double place) { return std::clamp(place, begin, begin + length) - place; }

}  // namespace

Point nearest_of(const Rect& rect, Point p) {
    return {std::clamp(p.x, rect.left, rect.left + rect.width), std::clamp(p.y, rect.top, rect.top + rect.height)};
}

Rect extent_of(const BrailleLine& line, const CellSize& cell, double dot) {
    const double cells = static_cast<double>(line.cells.size()) - 1;
    const bool eight_dots = std::any_of(line.cells.begin(), line.cells.end(), [](std::uint8_t c) { return c > 0x3F; });
    return {line.first_dot.x - dot / 2, line.first_dot.y - dot / 2, cells * cell.cell_pitch + cell.dot_pitch + dot,
            (eight_dots ? 3 : 2) * cell.dot_pitch + dot};
}

Rect extent_of(const PrintLine& line) {
    return {line.baseline.x, line.baseline.y - kAscent * line.size, print_width(line.text) * line.size,
            (kAscent + kDescent) * line.size};
}

Room::Room(const Page& page, double clear)
    : clear_(clear),
      square_(square_of(page)),
      live_(page.live),
      columns_(static_cast<int>(std::ceil(page.width / square_))),
      rows_(static_cast<int>(std::ceil(page.height / square_))),
      ink_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {
    if (page.bed) {
        across_ = {page.bed->across(page.cell), page.bed->first.x - page.braille_dot / 2};
        down_ = {page.bed->down(page.cell), page.bed->first.y - page.braille_dot / 2};
    }
    for (const PageStroke& stroke : page.strokes) {
        const std::size_t sides = stroke.points.size() - (stroke.closed ? 0 : 1);
        for (std::size_t i = 0; i < sides; ++i)
            mark(stroke.points[i], stroke.points[(i + 1) % stroke.points.size()], stroke.width);
    }
    for (const Area& area : page.areas) mark(area);
    for (const BrailleLine& line : page.braille)
        if (!line.cells.empty()) mark(extent_of(line, page.cell, page.braille_dot));
    for (const PrintLine& line : page.print) mark(extent_of(line));
    if (page.picture) mark(page.picture->place);  // dots are all over it
    keep_clear();
    add_up(0, rows_);
}

Room::Squares Room::squares_of(const Rect& rect) const {
    return {std::clamp(static_cast<int>(std::floor(rect.left / square_)), 0, columns_),
            std::clamp(static_cast<int>(std::floor(rect.top / square_)), 0, rows_),
            std::clamp(static_cast<int>(std::ceil((rect.left + rect.width) / square_)), 0, columns_),
            std::clamp(static_cast<int>(std::ceil((rect.top + rect.height) / square_)), 0, rows_)};
}

void Room::fill(std::vector<std::uint8_t>& squares, const Rect& rect) const {
    const auto [left, top, right, bottom] = squares_of(rect);
    for (int y = top; y < bottom; ++y)
        std::fill_n(squares.begin() + static_cast<std::ptrdiff_t>(y) * columns_ + left, std::max(0, right - left),
                    std::uint8_t{1});
}

void Room::mark(const Rect& rect) { fill(ink_, rect); }

// Squares every quarter of a square along the line: none that it crosses by more than a corner is missed, and the distance
// that is kept has half a square to spare.
void Room::mark(Point from, Point to, double width) {
    const int steps = static_cast<int>(std::ceil(distance(from, to) / (square_ / 4)));
    for (int i = 0; i <= steps; ++i) {
        const double t = steps == 0 ? 0 : static_cast<double>(i) / steps;
        const Point p{from.x + t * (to.x - from.x), from.y + t * (to.y - from.y)};
        mark(Rect{p.x - width / 2, p.y - width / 2, width, width});
    }
}

void Room::mark(const Area& area) {
    for (const auto& ring : area.rings)
        for (std::size_t i = 0; i < ring.size(); ++i) mark(ring[i], ring[(i + 1) % ring.size()], 0);
    // Inside by the even-odd rule, along the middle of each row of squares.
    std::vector<double> crossings;
    for (int y = 0; y < rows_; ++y) {
        const double at = (y + 0.5) * square_;
        crossings.clear();
        for (const auto& ring : area.rings)
            for (std::size_t i = 0; i < ring.size(); ++i) {
                const Point a = ring[i], b = ring[(i + 1) % ring.size()];
                if ((a.y <= at) != (b.y <= at)) crossings.push_back(a.x + (at - a.y) / (b.y - a.y) * (b.x - a.x));
            }
        std::sort(crossings.begin(), crossings.end());
        for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
            mark(Rect{crossings[i], at - square_ / 4, crossings[i + 1] - crossings[i], square_ / 2});
    }
}

void Room::keep_clear() {
    constexpr int kMostReach = 254;  // squares: 127 mm, more than anything keeps clear
    const int reach = std::min(kMostReach, static_cast<int>(std::ceil(clear_ / square_)));
    const auto columns = static_cast<std::size_t>(columns_);
    block_margins();
    // Squares to the nearest ink in the row, none farther than that matters.
    std::vector<std::uint8_t> beside(ink_.size());
    std::vector<bool> inked(static_cast<std::size_t>(rows_));
    for (std::size_t y = 0; y < inked.size(); ++y) {
        const std::uint8_t* ink = ink_.data() + y * columns;
        inked[y] = std::find(ink, ink + columns, 1) != ink + columns;
        if (inked[y]) measure_row(ink, static_cast<std::uint8_t>(reach + 1), beside.data() + y * columns);
    }
    for (int off = 0; off <= reach; ++off) {
        // So many squares beside the ink are still too near, so many rows above and below it.
        int most = reach;
        while (most >= 0 && length_of(std::max(0, most - 1), std::max(0, off - 1)) * square_ >= clear_) --most;
        if (most < 0) break;
        const auto near = static_cast<std::uint8_t>(most);
        for (int y = 0; y < rows_; ++y) {
            if (!inked[static_cast<std::size_t>(y)]) continue;
            const std::uint8_t* away = beside.data() + static_cast<std::size_t>(y) * columns;
            for (const int to : {y - off, y + off}) {
                if (to < 0 || to >= rows_) continue;
                std::uint8_t* blocked = blocked_.data() + static_cast<std::size_t>(to) * columns;
                for (std::size_t x = 0; x < columns; ++x)
                    blocked[x] = static_cast<std::uint8_t>(blocked[x] | (away[x] <= near ? 1 : 0));
            }
        }
    }
}

void Room::measure_row(const std::uint8_t* ink, std::uint8_t most, std::uint8_t* away) const {
    const auto next = [most](std::uint8_t last, std::uint8_t here) {
        return here != 0 ? std::uint8_t{0} : last < most ? static_cast<std::uint8_t>(last + 1) : most;
    };
    std::uint8_t last = most;
    for (int x = 0; x < columns_; ++x) away[x] = last = next(last, ink[x]);
    last = most;
    for (int x = columns_ - 1; x >= 0; --x) {
        last = next(last, ink[x]);
        away[x] = std::min(away[x], last);
    }
}

// What is not wholly on the live part of the page.
void Room::block_margins() {
    const auto is_out = [this](int square, double live, double length) {
        return square * square_ < live || square * square_ + square_ > live + length;
    };
    std::vector<std::uint8_t> row(static_cast<std::size_t>(columns_));
    for (std::size_t x = 0; x < row.size(); ++x) row[x] = is_out(static_cast<int>(x), live_.left, live_.width) ? 1 : 0;
    blocked_.assign(ink_.size(), 1);
    for (int y = 0; y < rows_; ++y)
        if (!is_out(y, live_.top, live_.height))
            std::copy(row.begin(), row.end(), blocked_.begin() + static_cast<std::ptrdiff_t>(y) * columns_);
}

void Room::add_up(int top, int bottom) {
    const std::size_t stride = static_cast<std::size_t>(columns_) + 1;
    const int strips = (rows_ + kStrip - 1) / kStrip;
    if (sums_.empty()) sums_.resize(stride * static_cast<std::size_t>(strips * (kStrip + 1)));
    for (int strip = top / kStrip; strip < strips && strip * kStrip < bottom; ++strip) {
        const int end = std::min(rows_, (strip + 1) * kStrip);
        std::size_t i = static_cast<std::size_t>(strip * kStrip) * (stride - 1);
        std::size_t row = static_cast<std::size_t>(strip * (kStrip + 1) + 1) * stride;  // that before it is all 0
        for (int y = strip * kStrip; y < end; ++y, row += stride) {
            std::uint32_t in_row = 0;
            for (std::size_t x = 1; x < stride; ++x) {
                in_row += blocked_[i++];
                sums_[row + x] = sums_[row - stride + x] + in_row;
            }
        }
    }
}

Room::Span Room::span_of(double from, double length) const {
    return {static_cast<int>(std::floor(from / square_)), static_cast<int>(std::ceil((from + length) / square_))};
}

bool Room::is_free(const Rect& rect) const { return is_free(span_of(rect.left, rect.width), span_of(rect.top, rect.height)); }

bool Room::is_free(Span across, Span down) const {
    const int top = down.begin, bottom = down.end;
    if (across.begin < 0 || top < 0 || across.end > columns_ || bottom > rows_) return false;
    for (int strip = top / kStrip; strip * kStrip < bottom; ++strip) {
        const auto sum = [this, strip](int x, int y) {
            return sums_[static_cast<std::size_t>(y + strip) * (static_cast<std::size_t>(columns_) + 1) +
                         static_cast<std::size_t>(x)];
        };
        const int from = std::max(top, strip * kStrip), to = std::min(bottom, (strip + 1) * kStrip);
        if (sum(across.end, to) + sum(across.begin, from) != sum(across.begin, to) + sum(across.end, from)) return false;
    }
    return true;
}

std::vector<Rect> Room::around(Point to, double width, double height, double reach) const {
    struct Ranked {
        double cost;
        Rect rect;
    };
    constexpr double kOffAxis = 0.2;  // a label is looked for beside or above its thing, less at a corner
    std::vector<Ranked> found;
    const double across = reach + width, down = reach + height;
    const double left = to.x - width / 2, top = to.y - height / 2;
    const double first_dx = across_.first ? across_.at_least(left - across) - left : -across;
    const double first_dy = down_.first ? down_.at_least(top - down) - top : -down;
    // What each place has in common with those above and below it is counted once.
    struct Column {
        double dx, left, away;
        Span across;
    };
    std::vector<Column> columns;
    for (double dx = first_dx; dx <= across; dx += across_.step) {
        const double begin = to.x + dx - width / 2;
        columns.push_back({dx, begin, away_from(begin, width, to.x), span_of(begin, width)});
    }
    for (double dy = first_dy; dy <= down; dy += down_.step) {
        const double begin = to.y + dy - height / 2, away_down = away_from(begin, height, to.y);
        const Span rows = span_of(begin, height);
        for (const Column& column : columns) {
            const double away = length_of(column.away, away_down);
            if (away > reach || !is_free(column.across, rows)) continue;
            const double dx = column.dx, to_left = dx < 0 ? 1 : 0;
            found.push_back({away + kOffAxis * std::min(std::abs(dx), std::abs(dy)) + 0.01 * length_of(dx, dy) + to_left,
                             {column.left, begin, width, height}});
        }
    }
    std::stable_sort(found.begin(), found.end(), [](const Ranked& a, const Ranked& b) { return a.cost < b.cost; });
    std::vector<Rect> rects;
    for (const Ranked& each : found) rects.push_back(each.rect);
    return rects;
}

void Room::take(const Rect& rect) {
    mark(rect);
    const Rect around{rect.left - clear_, rect.top - clear_, rect.width + 2 * clear_, rect.height + 2 * clear_};
    fill(blocked_, around);
    const Squares changed = squares_of(around);
    add_up(changed.top, changed.bottom);
}

void Room::take(Point from, Point to, double width) {
    const int steps = 1 + static_cast<int>(std::ceil(distance(from, to) / square_));
    const double half = width / 2 + clear_;
    for (int i = 0; i <= steps; ++i) {
        const double t = static_cast<double>(i) / steps;
        const Point p{from.x + t * (to.x - from.x), from.y + t * (to.y - from.y)};
        fill(blocked_, {p.x - half, p.y - half, 2 * half, 2 * half});
    }
    mark(from, to, width);
    const Squares changed = squares_of({0, std::min(from.y, to.y) - half, 0, std::abs(to.y - from.y) + 2 * half});
    add_up(std::max(changed.top - 1, 0), std::min(changed.bottom + 1, rows_));  // the places between are rounded
}

}  // namespace tactics
