// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/svg/found_braille.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <iterator>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

#include "tactics/geometry/grid.h"

namespace tactics {

namespace {

// Sizes that a braille dot may have when it is drawn and not swollen yet, and the pitches of all cells known (Small English
// 2.2, Marburg 2.5, jumbo 3.2 mm and what a wrong scale makes of them).
constexpr double kSmallestDot = 0.8, kLargestDot = 2.6;
constexpr double kLeastPitch = 1.7, kMostPitch = 4.2;
// Cell to cell, in dot pitches: 2.4 (Marburg), 2.65 (NLS), 2.74 (jumbo). In a dotted line it would be 2 or 3.
constexpr double kLeastCells = 2.12, kMostCells = 2.95;
// One text: no blank wider than a cell (a jumbo one) between words, nothing further below than the next line.
constexpr double kWords = 21, kLines = 5.5;
constexpr std::size_t kMostPairs = 50'000'000;
constexpr double kOffPlace = 0.2;  // mm that a dot may be off its place

struct Row {
    double y;
    std::vector<Disc> discs;  // by x
};

// How often steps between dots have which length, to a hundredth of a millimetre.
class Steps {
public:
    Steps(double least, double most)
        : least_(least), counts_(static_cast<std::size_t>((most - least) * 100) + 2), sums_(counts_.size()) {}

    void add(double step) {
        const double bin = std::round((step - least_) * 100);
        if (!(bin >= 0 && bin < static_cast<double>(counts_.size()))) return;
        ++counts_[static_cast<std::size_t>(bin)];
        sums_[static_cast<std::size_t>(bin)] += step;
    }
    // The shortest of those that are common: at least `share` of the commonest. What is within kOffPlace is one.
    std::optional<double> common(double share) const {
        constexpr auto kWindow = static_cast<std::size_t>(kOffPlace * 100) + 1;
        std::vector<std::size_t> within(counts_.size());  // from each on
        std::size_t sum = 0, most = 0;
        for (std::size_t i = counts_.size(); i-- > 0;) {
            sum += counts_[i];
            if (i + kWindow < counts_.size()) sum -= counts_[i + kWindow];
            within[i] = sum;
            most = std::max(most, sum);
        }
        if (most == 0) return std::nullopt;
        for (std::size_t i = 0; i < within.size(); ++i) {
            if (counts_[i] == 0 || static_cast<double>(within[i]) < share * static_cast<double>(most)) continue;
            const std::size_t end = std::min(i + kWindow, counts_.size());
            std::size_t best = i;
            for (std::size_t j = i; j < end; ++j)
                if (counts_[j] > counts_[best]) best = j;
            return sums_[best] / static_cast<double>(counts_[best]);
        }
        return std::nullopt;
    }

private:
    double least_;
    std::vector<std::size_t> counts_;
    std::vector<double> sums_;  // of the steps of each bin
};

// All dots of a page, and what stands near what.
class Dots {
public:
    Dots(const std::vector<Disc>& discs, const Page& page) : discs_(discs), grid_(boxes_of(discs), page.width, page.height) {}

    // The pitch of dots: what stands beside or below each other. Between cells the step is longer than within; both are common.
    std::optional<double> dot_pitch() const {
        Steps steps(kLeastPitch, kMostPitch);
        const bool all = pairs([&](std::size_t, std::size_t, double right, double down) {
            if (down <= kOffPlace) steps.add(right);
            if (right <= kOffPlace) steps.add(down);
        });
        return all ? steps.common(0.25) : std::nullopt;
    }

    // From a cell to the next one, from dots in their same columns.
    std::optional<double> cell_pitch(double pitch) const {
        Steps steps(kLeastCells * pitch, kMostCells * pitch);
        const bool all = pairs([&](std::size_t, std::size_t, double right, double down) {
            if (is_row(down, pitch)) steps.add(right);
        });
        return all ? steps.common(1) : std::nullopt;
    }

    // Dots that may belong to one text: near each other and in step.
    std::vector<std::vector<Disc>> texts(double pitch, std::optional<double> cell) const {
        std::vector<std::size_t> first(discs_.size());
        std::iota(first.begin(), first.end(), std::size_t{0});
        const auto root = [&first](std::size_t d) {
            while (first[d] != d) d = first[d] = first[first[d]];
            return d;
        };
        pairs([&](std::size_t i, std::size_t j, double right, double down) {
            if (!is_row(down, pitch) || !is_column(right, pitch, cell)) return;
            const std::size_t a = root(i), b = root(j);
            first[std::max(a, b)] = std::min(a, b);
        });
        std::vector<std::vector<Disc>> texts(discs_.size());
        for (std::size_t d = 0; d < discs_.size(); ++d) texts[root(d)].push_back(discs_[d]);
        std::erase_if(texts, [](const auto& text) { return text.empty(); });
        return texts;
    }

private:
    // Two texts beside each other are out of step, but for a chance of a hundredth; what is drawn in whole tenths is in step.
    static constexpr double kInStep = kOffPlace / 2;

    static std::vector<Box> boxes_of(const std::vector<Disc>& discs) {
        std::vector<Box> boxes;
        for (const Disc& d : discs)
            boxes.push_back({d.middle.x - kWords / 2, d.middle.y - kLines / 2, d.middle.x + kWords / 2, d.middle.y + kLines / 2});
        return boxes;
    }
    static bool is_row(double down, double pitch) {
        return down <= kInStep || std::abs(down - pitch) <= kInStep || std::abs(down - 2 * pitch) <= kInStep;
    }
    static bool is_column(double right, double pitch, std::optional<double> cell) {
        const double rest = cell ? std::abs(right - std::round(right / *cell) * *cell) : right;
        return rest <= kInStep || std::abs(rest - pitch) <= kInStep;
    }

    // `visit` gets two dots and how far they are apart. False: there are too many.
    template <typename Visit>
    bool pairs(Visit visit) const {
        return grid_.pairs(kMostPairs, [&](std::size_t i, std::size_t j) {
            visit(i, j, std::abs(discs_[i].middle.x - discs_[j].middle.x), std::abs(discs_[i].middle.y - discs_[j].middle.y));
            return true;
        });
    }

    const std::vector<Disc>& discs_;
    Grid grid_;
};

// Rows of dots that stand at one height.
std::vector<Row> rows_of(std::vector<Disc> discs) {
    std::sort(discs.begin(), discs.end(), [](const Disc& a, const Disc& b) { return a.middle.y < b.middle.y; });
    std::vector<Row> rows;
    for (const Disc& disc : discs) {
        if (rows.empty() || disc.middle.y - rows.back().y > kOffPlace) rows.push_back({disc.middle.y, {}});
        rows.back().discs.push_back(disc);
    }
    for (Row& row : rows)
        std::sort(row.discs.begin(), row.discs.end(), [](const Disc& a, const Disc& b) { return a.middle.x < b.middle.x; });
    return rows;
}

// The middle one of those within kOffPlace of each other that are most, or nothing.
std::optional<double> commonest(std::vector<double> values) {
    if (values.empty()) return std::nullopt;
    std::sort(values.begin(), values.end());
    std::size_t best = 0, best_begin = 0, begin = 0;
    for (std::size_t end = 0; end < values.size(); ++end) {
        while (values[end] - values[begin] > kOffPlace) ++begin;
        if (end - begin + 1 > best) {
            best = end - begin + 1;
            best_begin = begin;
        }
    }
    return values[best_begin + best / 2];
}

// Where dots stand across a line, each place once.
std::vector<double> places_of(const std::vector<const Row*>& rows) {
    std::vector<double> places;
    for (const Row* row : rows)
        for (const Disc& disc : row->discs) places.push_back(disc.middle.x);
    std::sort(places.begin(), places.end());
    std::vector<double> apart;
    for (const double x : places)
        if (apart.empty() || x - apart.back() > kOffPlace) apart.push_back(x);
    return apart;
}

// Over many cells a small error grows, so the longer distances settle it (least squares).
double settled(double rough, const std::vector<std::vector<const Row*>>& lines) {
    double products = 0, squares = 0;
    for (const auto& rows : lines) {
        const auto places = places_of(rows);
        for (const double place : places) {
            const double across = place - places[0], cells = std::round(across / rough);
            if (cells < 1 || std::abs(across - cells * rough) > kOffPlace) continue;
            products += across * cells;
            squares += cells * cells;
        }
    }
    return squares > 0 ? products / squares : rough;
}

// Sets the dots of one text in cells; nothing if one stands where no cell has a dot.
std::optional<BrailleLine> set_text(const std::vector<std::pair<Point, int>>& dots, double top, double pitch, double cell) {
    if (dots.size() < 2) return std::nullopt;
    for (const auto& [at, row] : dots)
        if (std::abs(at.y - top - row * pitch) > kOffPlace) return std::nullopt;
    double left = dots.front().first.x;
    for (const auto& [at, row] : dots) left = std::min(left, at.x);
    for (const double start : {left, left - pitch}) {  // the first column may hold no dot
        BrailleLine line{{start, top}, {}};
        bool fits = true;
        double right = 0, low = 0;  // what all dots together are off
        for (const auto& [at, row] : dots) {
            const double across = at.x - start;
            const double number = std::floor((across + kOffPlace) / cell), within = across - number * cell;
            const bool first = std::abs(within) <= kOffPlace, second = std::abs(within - pitch) <= kOffPlace;
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

// Keeps those of the commonest size; the others are returned.
std::vector<Disc> take_other_sizes(std::vector<Disc>& discs, double size) {
    std::vector<Disc> others;
    std::erase_if(discs, [&](const Disc& disc) {
        if (std::abs(disc.diameter - size) <= kOffPlace) return false;
        others.push_back(disc);
        return true;
    });
    return others;
}

// A line begins with its topmost row and holds three.
std::vector<std::vector<const Row*>> lines_of(const std::vector<std::vector<Row>>& texts, double pitch) {
    std::vector<std::vector<const Row*>> lines;
    for (const auto& rows : texts) {
        bool begun = false;
        for (const Row& row : rows) {
            if (!begun || row.y - lines.back().front()->y > 2 * pitch + kOffPlace) lines.emplace_back();
            begun = true;
            lines.back().push_back(&row);
        }
    }
    return lines;
}

// The dots of a line from left to right, each with the number of its row, where two blank cells part two texts, whose cells need
// not stand in step.
std::vector<std::vector<std::pair<Point, int>>> texts_in(const std::vector<const Row*>& line, double pitch, double cell) {
    std::vector<std::pair<Point, int>> places;
    for (const Row* row : line)
        for (const Disc& disc : row->discs)
            places.push_back({disc.middle, static_cast<int>(std::lround((row->y - line.front()->y) / pitch))});
    std::sort(places.begin(), places.end(), [](const auto& a, const auto& b) { return a.first.x < b.first.x; });
    std::vector<std::vector<std::pair<Point, int>>> texts;
    for (std::size_t begin = 0, end = 0; begin < places.size(); begin = end) {
        end = begin + 1;
        while (end < places.size() && places[end].first.x - places[end - 1].first.x < 3 * cell) ++end;
        texts.emplace_back(places.begin() + static_cast<std::ptrdiff_t>(begin),
                           places.begin() + static_cast<std::ptrdiff_t>(end));
    }
    return texts;
}

// A few cells stand in step by no chance, and those of words have two dots or more on average; shorter texts beside these are
// braille, too. Points of a plot whose values are whole numbers stand in step as well, but mostly one in a cell.
bool has_words(const std::vector<BrailleLine>& lines) {
    constexpr std::ptrdiff_t kFewestCells = 4;
    std::ptrdiff_t cells = 0, most = 0, dots = 0;
    for (const BrailleLine& line : lines) {
        const auto count = std::count_if(line.cells.begin(), line.cells.end(), [](std::uint8_t cell) { return cell != 0; });
        most = std::max(most, count);
        cells += count;
        for (const std::uint8_t cell : line.cells) dots += std::popcount(cell);
    }
    return most >= kFewestCells && dots >= 2 * cells;
}

// Takes out areas, and counts what is behind them anew.
void drop_areas(FoundPage& figure, const std::vector<bool>& dropped) {
    std::vector<std::size_t> moved(dropped.size() + 1);  // the new number of each
    std::vector<Area> kept;
    for (std::size_t i = 0; i < dropped.size(); ++i) {
        moved[i] = kept.size();
        if (!dropped[i]) kept.push_back(std::move(figure.page.areas[i]));
    }
    moved.back() = kept.size();
    figure.page.areas = std::move(kept);
    for (FoundLook& look : figure.looks) {
        look.area = moved[look.area];
        look.areas_end = moved[look.areas_end];
    }
}

}  // namespace

void take_braille_of_figure(FoundPage& figure) {
    const double scale = figure.file_width / figure.page.width;
    if (!figure.tells_size || !(scale > 0)) return;
    std::vector<Disc> discs;
    std::map<std::pair<double, double>, std::vector<std::size_t>> areas_at;
    for (std::size_t i = 0; i < figure.page.areas.size(); ++i) {
        const Area& area = figure.page.areas[i];
        if (area.role != Role::line || area.rings.size() != 1) continue;
        std::vector<Point> ring = area.rings.front();
        for (Point& p : ring) p = {p.x * scale, p.y * scale};
        Disc disc;
        if (!is_braille_dot(ring, disc)) continue;
        discs.push_back(disc);
        areas_at[{disc.middle.x, disc.middle.y}].push_back(i);
    }
    Page page;
    page.width = figure.file_width;
    page.height = figure.file_height;
    const std::vector<Disc> left = take_braille(std::move(discs), page);
    if (!has_words(page.braille)) return;
    for (const Disc& disc : left) areas_at.erase({disc.middle.x, disc.middle.y});
    std::vector<bool> dropped(figure.page.areas.size(), false);
    for (const auto& [at, areas] : areas_at)
        for (const std::size_t area : areas) dropped[area] = true;
    drop_areas(figure, dropped);
    std::move(page.braille.begin(), page.braille.end(), std::back_inserter(figure.page.braille));
}

void settle_discs(std::vector<Disc> discs, Page& page) {
    for (const Disc& disc : take_braille(std::move(discs), page))
        page.strokes.push_back({{disc.middle, disc.middle}, false, disc.diameter});
}

bool is_braille_dot(const std::vector<Point>& ring, Disc& disc) {
    if (ring.size() < 6 || ring.size() > 1000) return false;
    const auto [left, top, right, bottom] = tactics::box_of(ring);
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
    std::vector<Disc> left = take_other_sizes(discs, size);
    const Dots dots(discs, page);
    const auto pitch = dots.dot_pitch();
    if (!pitch) {
        left.insert(left.end(), discs.begin(), discs.end());
        return left;
    }
    const auto cell_pitch = dots.cell_pitch(*pitch);
    std::vector<std::vector<Row>> texts;
    for (auto& text : dots.texts(*pitch, cell_pitch)) texts.push_back(rows_of(std::move(text)));
    const auto lines = lines_of(texts, *pitch);
    const double cell = cell_pitch ? settled(*cell_pitch, lines) : page.cell.cell_pitch;
    const std::size_t before = page.braille.size();
    for (const auto& line : lines)
        for (const auto& text : texts_in(line, *pitch, cell)) {
            // With no two cells in a row on the whole page, more than one is a pattern of dots and no text.
            const bool pattern = !cell_pitch && text.back().first.x - text.front().first.x > *pitch + kOffPlace;
            const auto set = pattern ? std::nullopt : set_text(text, line.front()->y, *pitch, cell);
            if (set)
                page.braille.push_back(*set);
            else
                for (const auto& [at, row] : text) left.push_back({at, size});
        }
    if (page.braille.size() > before) {
        page.cell.dot_pitch = *pitch;
        page.cell.cell_pitch = cell;
        page.braille_dot = size;
    }
    return left;
}

}  // namespace tactics
