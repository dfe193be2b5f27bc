#include "tactics/pages/found_braille.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "tactics/rules/grid.h"

namespace tactics {

namespace {

// Sizes that a braille dot may have when it is drawn and not swollen yet, and the pitches of all cells known (Small English
// 2.2, Marburg 2.5, jumbo 3.2 mm and what a wrong scale makes of them).
constexpr double kSmallestDot = 0.8, kLargestDot = 2.6;
constexpr double kLeastPitch = 1.7, kMostPitch = 4.2;
// Cell to cell, in dot pitches: 2.4 (Marburg), 2.65 (NLS), 2.74 (jumbo). In a dotted line it would be 2 or 3.
constexpr double kLeastCells = 2.12, kMostCells = 2.95;
// One text: no blank wider than a cell between words, nothing further below than the next line.
constexpr double kWords = 15, kLines = 5.5;
constexpr std::size_t kMostPairs = 50'000'000;
constexpr double kOff = 0.2;  // mm that a dot may be off its place

struct Row {
    double y;
    std::vector<Disc> discs;  // by x
};

// Dots that may belong to one text.
std::vector<std::vector<Disc>> texts_of(const std::vector<Disc>& discs, const Page& page) {
    std::vector<Box> boxes;
    for (const Disc& d : discs)
        boxes.push_back({d.middle.x - kWords / 2, d.middle.y - kLines / 2, d.middle.x + kWords / 2, d.middle.y + kLines / 2});
    std::vector<std::size_t> first(discs.size());
    std::iota(first.begin(), first.end(), std::size_t{0});
    const auto root = [&first](std::size_t d) {
        while (first[d] != d) d = first[d] = first[first[d]];
        return d;
    };
    const Grid grid(std::move(boxes), page.width, page.height);
    if (!grid.pairs(kMostPairs, [&](std::size_t i, std::size_t j) {
            const std::size_t a = root(i), b = root(j);
            first[std::max(a, b)] = std::min(a, b);
            return true;
        }))
        return {};
    std::vector<std::vector<Disc>> texts(discs.size());
    for (std::size_t d = 0; d < discs.size(); ++d) texts[root(d)].push_back(discs[d]);
    std::erase_if(texts, [](const auto& text) { return text.empty(); });
    return texts;
}

// Rows of dots that stand at one height.
std::vector<Row> rows_of(std::vector<Disc> discs) {
    std::sort(discs.begin(), discs.end(), [](const Disc& a, const Disc& b) { return a.middle.y < b.middle.y; });
    std::vector<Row> rows;
    for (const Disc& disc : discs) {
        if (rows.empty() || disc.middle.y - rows.back().y > kOff) rows.push_back({disc.middle.y, {}});
        rows.back().discs.push_back(disc);
    }
    for (Row& row : rows)
        std::sort(row.discs.begin(), row.discs.end(), [](const Disc& a, const Disc& b) { return a.middle.x < b.middle.x; });
    return rows;
}

// The middle one of those within kOff of each other that are most, or nothing.
std::optional<double> commonest(std::vector<double> values) {
    if (values.empty()) return std::nullopt;
    std::sort(values.begin(), values.end());
    std::size_t best = 0, best_begin = 0, begin = 0;
    for (std::size_t end = 0; end < values.size(); ++end) {
        while (values[end] - values[begin] > kOff) ++begin;
        if (end - begin + 1 > best) {
            best = end - begin + 1;
            best_begin = begin;
        }
    }
    return values[best_begin + best / 2];
}

// The pitch of dots: what stands next to each other in a row, or below each other, in the range of braille.
void add_steps(const std::vector<Row>& rows, std::vector<double>& steps) {
    for (std::size_t r = 0; r < rows.size(); ++r) {
        for (std::size_t i = 1; i < rows[r].discs.size(); ++i) {
            const double step = rows[r].discs[i].middle.x - rows[r].discs[i - 1].middle.x;
            if (step >= kLeastPitch && step <= kMostPitch) steps.push_back(step);
        }
        if (r > 0 && rows[r].y - rows[r - 1].y >= kLeastPitch && rows[r].y - rows[r - 1].y <= kMostPitch)
            for (std::size_t i = 0; i < std::min(rows[r].discs.size(), rows[r - 1].discs.size()); ++i)
                steps.push_back(rows[r].y - rows[r - 1].y);
    }
}

std::optional<double> dot_pitch_of(std::vector<double> steps) {
    if (steps.empty()) return std::nullopt;
    // Between cells the step is longer than within; both may be common, the shorter is the cell's own.
    const double least = *std::min_element(steps.begin(), steps.end());
    std::erase_if(steps, [least](double step) { return step > least + kOff; });
    return commonest(steps);
}

// Where dots stand across a line, each place once.
std::vector<double> places_of(const std::vector<const Row*>& rows) {
    std::vector<double> places;
    for (const Row* row : rows)
        for (const Disc& disc : row->discs) places.push_back(disc.middle.x);
    std::sort(places.begin(), places.end());
    std::vector<double> apart;
    for (const double x : places)
        if (apart.empty() || x - apart.back() > kOff) apart.push_back(x);
    return apart;
}

// From the first columns of cells to the next: whole numbers of cells lie between equal columns.
std::optional<double> cell_pitch_of(const std::vector<std::vector<const Row*>>& lines, double pitch) {
    std::vector<double> steps;
    for (const auto& rows : lines) {
        const auto places = places_of(rows);
        for (std::size_t i = 0; i < places.size(); ++i)
            for (std::size_t j = i + 1; j < places.size() && places[j] - places[i] <= kMostCells * pitch; ++j)
                if (places[j] - places[i] >= kLeastCells * pitch) steps.push_back(places[j] - places[i]);
    }
    const auto rough = commonest(steps);
    if (!rough) return rough;
    // Over many cells a small error grows, so the longer distances settle it (least squares).
    double products = 0, squares = 0;
    for (const auto& rows : lines) {
        const auto places = places_of(rows);
        for (const double place : places) {
            const double across = place - places[0], cells = std::round(across / *rough);
            if (cells < 1 || std::abs(across - cells * *rough) > kOff) continue;
            products += across * cells;
            squares += cells * cells;
        }
    }
    return squares > 0 ? products / squares : *rough;
}

// Sets the dots of one text in cells; nothing if one stands where no cell has a dot.
std::optional<BrailleLine> set_text(const std::vector<std::pair<Point, int>>& dots, double top, double pitch, double cell) {
    if (dots.size() < 2) return std::nullopt;
    for (const auto& [at, row] : dots)
        if (std::abs(at.y - top - row * pitch) > kOff) return std::nullopt;
    double left = dots.front().first.x;
    for (const auto& [at, row] : dots) left = std::min(left, at.x);
    for (const double start : {left, left - pitch}) {  // the first column may hold no dot
        BrailleLine line{{start, top}, {}};
        bool fits = true;
        double right = 0, low = 0;  // what all dots together are off
        for (const auto& [at, row] : dots) {
            const double across = at.x - start;
            const double number = std::floor((across + kOff) / cell), within = across - number * cell;
            const bool first = std::abs(within) <= kOff, second = std::abs(within - pitch) <= kOff;
            if (!first && !second) {
                fits = false;
                break;
            }
            const auto index = static_cast<std::size_t>(number);
            right += second ? within - pitch : within;
            low += at.y - top - row * pitch;
            if (line.cells.size() <= index) line.cells.resize(index + 1, 0);
            line.cells[index] = static_cast<std::uint8_t>(line.cells[index] | 1u << (row + (second ? 3 : 0)));
        }
        if (!fits) continue;
        const auto count = static_cast<double>(dots.size());
        line.first_dot = {start + right / count, top + low / count};
        return line;
    }
    return std::nullopt;
}

}  // namespace

bool is_braille_dot(const std::vector<Point>& ring, Disc& disc) {
    if (ring.size() < 6 || ring.size() > 1000) return false;
    double left = ring[0].x, right = left, top = ring[0].y, bottom = top;
    for (const Point& p : ring) {
        left = std::min(left, p.x);
        right = std::max(right, p.x);
        top = std::min(top, p.y);
        bottom = std::max(bottom, p.y);
    }
    disc = {{(left + right) / 2, (top + bottom) / 2}, (right - left + bottom - top) / 2};
    if (disc.diameter < kSmallestDot || disc.diameter > kLargestDot) return false;
    return std::all_of(ring.begin(), ring.end(),
                       [&](Point p) { return std::abs(distance(p, disc.middle) - disc.diameter / 2) < 0.06; });
}

std::vector<Disc> take_braille(std::vector<Disc> discs, Page& page) {
    if (discs.size() < 2) return discs;
    std::vector<double> sizes;
    for (const Disc& disc : discs) sizes.push_back(disc.diameter);
    const double size = *commonest(sizes);
    std::vector<Disc> left;
    std::erase_if(discs, [&](const Disc& disc) {
        if (std::abs(disc.diameter - size) <= kOff) return false;
        left.push_back(disc);
        return true;
    });
    std::vector<std::vector<Row>> texts;
    std::vector<double> steps;
    for (auto& text : texts_of(discs, page)) {
        texts.push_back(rows_of(std::move(text)));
        add_steps(texts.back(), steps);
    }
    const auto pitch = dot_pitch_of(std::move(steps));
    if (!pitch) {
        left.insert(left.end(), discs.begin(), discs.end());
        return left;
    }
    // A line begins with its topmost row and holds three.
    std::vector<std::vector<const Row*>> lines;
    for (const auto& rows : texts) {
        bool begun = false;
        for (const Row& row : rows) {
            if (!begun || row.y - lines.back().front()->y > 2 * *pitch + kOff) lines.emplace_back();
            begun = true;
            lines.back().push_back(&row);
        }
    }
    const auto cell_pitch = cell_pitch_of(lines, *pitch);
    const double cell = cell_pitch.value_or(page.cell.cell_pitch);
    const std::size_t before = page.braille.size();
    for (const auto& line : lines) {
        std::vector<std::pair<Point, int>> dots;
        for (const Row* row : line)
            for (const Disc& disc : row->discs)
                dots.push_back({disc.middle, static_cast<int>(std::lround((row->y - line.front()->y) / *pitch))});
        std::sort(dots.begin(), dots.end(), [](const auto& a, const auto& b) { return a.first.x < b.first.x; });
        // Two blank cells part two texts, whose cells need not stand in step.
        for (std::size_t begin = 0, end = 0; begin < dots.size(); begin = end) {
            end = begin + 1;
            while (end < dots.size() && dots[end].first.x - dots[end - 1].first.x < 3 * cell) ++end;
            const std::vector<std::pair<Point, int>> text(dots.begin() + static_cast<std::ptrdiff_t>(begin),
                                                          dots.begin() + static_cast<std::ptrdiff_t>(end));
            // With no two cells in a row on the whole page, more than one is a pattern of dots and no text.
            const bool pattern = !cell_pitch && text.back().first.x - text.front().first.x > *pitch + kOff;
            const auto set = pattern ? std::nullopt : set_text(text, line.front()->y, *pitch, cell);
            if (set)
                page.braille.push_back(*set);
            else
                for (const auto& [at, row] : text) left.push_back({at, size});
        }
    }
    if (page.braille.size() > before) {
        page.cell.dot_pitch = *pitch;
        page.cell.cell_pitch = cell;
        page.braille_dot = size;
    }
    return left;
}

}  // namespace tactics
