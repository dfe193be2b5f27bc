// SPDX-License-Identifier: Apache-2.0
#include "filters/chart_key.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <tuple>
#include <utility>

#include "filters/plot_symbols.h"
#include "tactics/geometry/line_styles.h"

namespace tactics {

namespace {

// Width and height. An area of a texture leaves half the medium's gap at each of its borders. What remains is 1/2 in wide, so
// that a finger has some way to go on it (APH: shorter sides may not be recognised), and has two rows of the coarsest dots, which
// is more than 1/4 in (L. Hasty, Designing Tactile Graphics). Of fixed dots it has four
// rows at least.
std::pair<double, double> texture_sample(const Medium& medium) {
    constexpr double kWide = 12.7, kHigh = 11;  // mm
    if (has_fixed_dots(medium)) return {4 * kMarburgMedium.cell_pitch, 7 * kMarburgMedium.dot_pitch};
    return {kWide + medium.gap, kHigh + medium.gap};
}

// Half of the height of a line of braille, where the sample stands; of print alone the middle.
double middle_of(const LabelBlock& block, const CellSize& cell) {
    return block.braille.empty() ? block.height / 2 : block.braille[0].first_dot.y + cell.dot_pitch;
}

}  // namespace

std::vector<std::string> lines_within(const std::string& text, double width, const Sheet& sheet) {
    if (text.empty() || set_label(text, sheet).width <= width) return {text};
    std::vector<std::string> lines;
    std::string line;
    for (std::size_t from = 0; from <= text.size();) {
        const std::size_t blank = std::min(text.find(' ', from), text.size());
        const std::string word = text.substr(from, blank - from);
        from = blank + 1;
        if (word.empty()) continue;
        const std::string longer = line.empty() ? word : line + " " + word;
        if (!line.empty() && set_label(longer, sheet).width > width) {
            lines.push_back(line);
            line = word;
        } else {
            line = longer;
        }
    }
    if (!line.empty()) lines.push_back(line);
    return lines;
}

ChartKey::ChartKey(std::vector<ChartKeyEntry> entries, const Sheet& sheet, const CellPlaces& cells, const Clearance& clear,
                   double width)
    : sheet_(sheet), cells_(cells), clear_(clear), between_(clear.words + 4) {  // a blank that no line of words has
    const auto rank = [](const ChartKeyEntry& entry) { return entry.texture > 0 ? 0 : entry.style ? 1 : entry.symbol ? 2 : 3; };
    std::stable_sort(entries.begin(), entries.end(),
                     [&](const ChartKeyEntry& a, const ChartKeyEntry& b) { return rank(a) < rank(b); });
    double highest_sample = 0;
    std::size_t lines = 1;
    for (ChartKeyEntry& entry : entries) {
        Set set{std::move(entry), {}, {}};
        if (set.entry.texture > 0) std::tie(set.sample, set.height) = texture_sample(*sheet.medium);
        if (set.entry.style) set.sample = sample_length(*sheet.medium);
        if (set.entry.symbol) set.sample = set.height = 2 * reach_of(*set.entry.symbol, clear.mark);
        highest_sample = std::max(highest_sample, set.height);
        const double room = width - words_from(set) - (cells.anywhere() ? 0 : sheet.cell.cell_pitch);
        set.lines = lines_within(set.entry.text, room, sheet);
        for (const std::string& text : set.lines) {
            set.blocks.push_back(set_label(text, sheet));
            column_ = std::max(column_, words_from(set) + set.blocks.back().width);
            line_ = std::max(line_, set.blocks.back().height + kChartLines);
        }
        lines = std::max(lines, set.lines.size());
        sets_.push_back(std::move(set));
    }
    if (sets_.empty()) return;
    if (!cells.anywhere()) {
        column_ += sheet.cell.cell_pitch;
        line_ = std::ceil(line_ / cells.line_pitch()) * cells.line_pitch();
    }
    pitch_ = std::max(static_cast<double>(lines) * line_,
                      highest_sample > 0 ? highest_sample + kChartLines + sheet.medium->thin_line : 0);
    if (!cells.anywhere()) pitch_ = std::ceil(pitch_ / cells.line_pitch()) * cells.line_pitch();
    columns_ = std::max(1.0, std::floor((width + between_) / (column_ + between_)));
    rows_ = std::ceil(static_cast<double>(sets_.size()) / columns_);
}

double ChartKey::words_from(const Set& set) const {
    return set.sample > 0 ? set.sample + kChartClear + sheet_.medium->thick_line / 2 + sheet_.cell.dot : 0;
}

double ChartKey::height() const { return rows_ * pitch_ + (cells_.anywhere() || rows_ == 0 ? 0 : cells_.line_pitch()); }

void ChartKey::draw(Drawing& drawing) const {
    const double top = drawing.height - height();
    for (std::size_t i = 0; i < sets_.size(); ++i) {
        const Set& set = sets_[i];
        const double column = std::floor(static_cast<double>(i) / rows_), row = static_cast<double>(i) - column * rows_;
        const double left = column * (column_ + between_);
        Point first{};
        for (std::size_t k = 0; k < set.lines.size(); ++k) {
            const Point at{left + words_from(set), top + row * pitch_ + kChartLines + static_cast<double>(k) * line_};
            const Point placed = cells_.next(at, set.blocks[k]);
            if (k == 0) first = {left, placed.y + middle_of(set.blocks[0], sheet_.cell)};
            drawing.labels.push_back({placed, 0, 0, set.lines[k]});
        }
        if (set.entry.style) {
            const LineStyle style = line_style(*set.entry.style, *sheet_.medium);
            const double inset = sheet_.medium->thick_line / 2;
            auto sample = in_style({{first.x + inset, first.y}, {first.x + set.sample, first.y}}, false, style, *sheet_.medium);
            std::move(sample.begin(), sample.end(), std::back_inserter(drawing.strokes));
        }
        if (set.entry.texture > 0) {
            const double top_of = first.y - set.height / 2, end = first.x + set.sample, bottom = top_of + set.height;
            drawing.areas.push_back(
                {{{{first.x, top_of}, {end, top_of}, {end, bottom}, {first.x, bottom}}}, Role::line, set.entry.texture});
        }
        if (set.entry.symbol) draw_symbol(*set.entry.symbol, {first.x + set.sample / 2, first.y}, clear_.mark, drawing);
    }
}

}  // namespace tactics
