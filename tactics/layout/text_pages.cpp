// SPDX-License-Identifier: Apache-2.0
#include "tactics/layout/text_pages.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tactics/braille/braille.h"
#include "tactics/error.h"
#include "tactics/layout/dot_grid.h"
#include "tactics/layout/place.h"
#include "tactics/layout/text_cells.h"
#include "tactics/layout/title.h"
#include "tactics/layout/wrapped.h"
#include "tactics/text/utf8.h"

namespace tactics {

namespace {

using Cells = std::vector<std::uint8_t>;

constexpr std::size_t kIndent = 2, kLeastCells = 10, kLeastRows = 3;
constexpr std::size_t kMostPages = 20'000;
constexpr std::size_t kCentred = 3;  // cells that stay empty on each side of a heading, at least

Cells behind(std::size_t empty, const Cells& cells) {
    Cells line(empty, 0);
    line.insert(line.end(), cells.begin(), cells.end());
    return line;
}

std::vector<Cells> heading_lines(const Cells& cells, std::size_t most, const WordDivision& division) {
    std::vector<Cells> lines;
    for (const Cells& line : wrapped(cells, most > 4 * kCentred ? most - 2 * kCentred : most, division))
        lines.push_back(behind((most - std::min(most, line.size())) / 2, line));
    return lines;
}

// A sheet without a drawing: what stands on it, line by line.
class Lines {
public:
    Lines(const Sheet& sheet, std::size_t number) : sheet_(sheet), number_(number), first_(sheet) {
        first_.orientation = sheet.orientation == Orientation::automatic ? Orientation::portrait : sheet.orientation;
        first_.drawing_width.reset();
        first_.real_width.reset();
        first_.scale.reset();
        arrangement_ = arrange(first_, first_.paper.width / first_.paper.height);
        const Rect& live = arrangement_.place.live;
        const double dot = sheet.cell.dot;
        const double across = live.width - dot - sheet.cell.dot_pitch;
        cells_ = across > 0 ? static_cast<std::size_t>(std::floor(across / sheet.cell.cell_pitch + 1e-9)) + 1 : 0;
        const Title title = title_of(first_);
        band_ = set_title(title, first_, live);
        if (cells_ < kLeastCells || rows_below(top_of(0)) < kLeastRows)
            throw Error(
                Fault::usage, spelled("paper"),
                phrase("it has room for {0} cells and {1} lines of text; take larger paper, a smaller {2} or a shorter title",
                       std::to_string(cells_), std::to_string(rows_below(top_of(0))), spelled("margin")));
        begin_page();
    }

    std::size_t cells() const { return cells_; }
    std::size_t left() const { return rows_ - row_; }
    bool at_top() const { return row_ == 0; }

    void begin_page() {
        if (pages_.size() == kMostPages)
            throw Error(
                Fault::failed, "",
                phrase("this text fills over 20,000 pages of braille; cut it into parts, or of a PDF lay out one page with {0}",
                       spelled("page")));
        Page& page = pages_.emplace_back();
        page.width = arrangement_.place.page_width;
        page.height = arrangement_.place.page_height;
        page.live = arrangement_.place.live;
        page.braille_dot = sheet_.cell.dot;
        page.cell = sheet_.cell;
        page.bed = sheet_.bed;
        page.braille_table = sheet_.braille_table;
        page.language = sheet_.language;
        page.description = to_line(sheet_.description);
        page.title = arrangement_.title;
        const bool first = pages_.size() == 1;
        if (first) {
            page.caption = arrangement_.caption;
            page.print = band_.print;
            page.braille = band_.braille;
        }
        top_ = top_of(pages_.size() - 1);
        rows_ = rows_below(top_) - 1;  // the last has the number
        row_ = 0;
    }

    void add(Cells line) {
        if (row_ == rows_) begin_page();
        set(row_++, 0, std::move(line));
    }
    void leave_empty() {
        if (row_ > 0 && row_ < rows_) ++row_;
    }

    std::vector<Page> finish() {
        for (std::size_t i = 0; i < pages_.size(); ++i) {
            const Cells number = to_braille(std::to_string(number_ + i), sheet_.braille_table, "the text");
            top_ = top_of(i);
            place(pages_[i], rows_below(top_) - 1, cells_ - std::min(cells_, number.size()), number);
            put_on_dots(pages_[i]);
        }
        return std::move(pages_);
    }

private:
    // Below the title a line stays empty.
    double top_of(std::size_t page) const { return page == 0 && band_.height > 0 ? band_.height + sheet_.cell.line_pitch : 0; }

    std::size_t rows_below(double top) const {
        const double down = arrangement_.place.live.height - top - 2 * sheet_.cell.dot_pitch - sheet_.cell.dot;
        return down < 0 ? 0 : static_cast<std::size_t>(std::floor(down / sheet_.cell.line_pitch + 1e-9)) + 1;
    }

    void set(std::size_t row, std::size_t from, Cells cells) { place(pages_.back(), row, from, std::move(cells)); }

    void place(Page& page, std::size_t row, std::size_t from, Cells cells) const {
        const Rect& live = page.live;
        const double half = sheet_.cell.dot / 2;
        page.braille.push_back({{live.left + half + static_cast<double>(from) * sheet_.cell.cell_pitch,
                                 live.top + top_ + half + static_cast<double>(row) * sheet_.cell.line_pitch},
                                std::move(cells)});
    }

    const Sheet& sheet_;
    std::size_t number_;
    Sheet first_;
    Arrangement arrangement_;
    TitleBand band_;
    std::size_t cells_ = 0, rows_ = 0, row_ = 0;
    double top_ = 0;
    std::vector<Page> pages_;
};

}  // namespace

TextPages text_pages(const std::vector<TextBlock>& blocks, const Sheet& sheet, std::size_t number) {
    if (sheet.braille_table.empty())
        throw Error(Fault::usage, spelled("braille"), phrase("text is laid out in braille; name a table, or leave it out"));
    Lines lines(sheet, number);
    TextCells setting(sheet.braille_table);
    const Cells hyphen = hyphen_of(sheet.braille_table);
    for (const TextBlock& block : blocks) {
        const std::string text = to_line(block.text);
        const Cells cells = setting.of(text);
        if (cells.empty()) continue;
        const WordDivision division(hyphen, text, sheet.braille_table, sheet.language,
                                    [&](const std::string& part) { return setting.known(part); });
        if (block.kind == TextBlock::Kind::paragraph) {
            std::size_t indent = kIndent;
            for (const Cells& line : wrapped(cells, lines.cells(), division, kIndent))
                lines.add(behind(std::exchange(indent, 0), line));
            continue;
        }
        std::vector<Cells> heading = heading_lines(cells, lines.cells(), division);
        lines.leave_empty();
        if (!lines.at_top() && lines.left() < heading.size() + 2) lines.begin_page();  // an empty line and one of what follows
        for (Cells& line : heading) lines.add(std::move(line));
        lines.leave_empty();
    }
    return {lines.finish(), setting.unknown()};
}

std::size_t lines_of_braille(const std::vector<Page>& pages) {
    std::size_t lines = 0;
    for (const Page& page : pages) lines += page.braille.size() - 1;
    return lines;
}

Phrase note_of_unknown(const std::vector<std::string>& letters) {
    if (letters.empty()) return {};
    constexpr std::size_t kNamed = 12;
    std::vector<Phrase> some;
    for (std::size_t i = 0; i < std::min(letters.size(), kNamed); ++i) some.push_back(phrase("\"{0}\"", letters[i]));
    Phrase named = row_of(some);
    if (letters.size() > kNamed) {
        const std::string more = std::to_string(letters.size() - kNamed);
        named = letters.size() < TextCells::kMostUnknown ? phrase("{0} and {1} more", std::move(named), more)
                                                         : phrase("{0} and {1} or more others", std::move(named), more);
    }
    return phrase("the braille table has no cells for {0}: a full cell (dots 1 to 6) stands there; take another table with {1}",
                  std::move(named), spelled("braille"));
}

}  // namespace tactics
