// SPDX-License-Identifier: Apache-2.0
#include "tactics/layout/text_pages.h"

#include <algorithm>
#include <cmath>

#include "tactics/braille/braille.h"
#include "tactics/error.h"
#include "tactics/layout/dot_grid.h"
#include "tactics/layout/place.h"
#include "tactics/layout/title.h"
#include "tactics/text/utf8.h"

namespace tactics {

namespace {

using Cells = std::vector<std::uint8_t>;

constexpr std::size_t kIndent = 2, kLeastCells = 10, kLeastRows = 3;
constexpr std::size_t kCentred = 3;       // cells that stay empty on each side of a heading, at least
constexpr std::size_t kMostBytes = 2000;  // that are set at a time: liblouis takes no more than some
constexpr std::uint8_t kFullCell = 0x3F;  // for a letter that has none
constexpr std::string_view kOrigin = "the text";

// Text to cells; what the table does not know is kept, and everything else is set.
class Setting {
public:
    explicit Setting(const std::string& table) : table_(table) {}

    Cells cells_of(std::string_view text) {
        Cells cells;
        while (!text.empty()) {
            const std::string_view part = text.substr(0, end_of_part(text));
            text.remove_prefix(std::min(part.size() + 1, text.size()));
            append(cells, known_or_words(part));
        }
        return cells;
    }

    std::vector<std::string> unknown() const { return unknown_; }

private:
    // At a blank, where there is one.
    static std::size_t end_of_part(std::string_view text) {
        if (text.size() <= kMostBytes) return text.size();
        const auto blank = text.rfind(' ', kMostBytes);
        return blank == std::string_view::npos || blank == 0 ? std::min(text.find(' '), text.size()) : blank;
    }

    static void append(Cells& cells, const Cells& more) {
        if (!cells.empty() && !more.empty()) cells.push_back(0);
        cells.insert(cells.end(), more.begin(), more.end());
    }

    Cells known_or_words(std::string_view part) {
        if (const auto known = known_cells(part)) return *known;
        Cells cells;
        while (!part.empty()) {
            const std::string_view word = part.substr(0, part.find(' '));
            part.remove_prefix(std::min(word.size() + 1, part.size()));
            const auto known = known_cells(word);
            append(cells, known ? *known : letters_of(word));
        }
        return cells;
    }

    Cells letters_of(std::string_view word) {
        Cells cells;
        while (!word.empty()) {
            std::string_view rest = word;
            take_letter(rest);
            const std::string letter(word.substr(0, word.size() - rest.size()));
            word = rest;
            if (const auto known = known_cells(letter)) {
                cells.insert(cells.end(), known->begin(), known->end());
                continue;
            }
            cells.push_back(kFullCell);
            if (std::find(unknown_.begin(), unknown_.end(), letter) == unknown_.end()) unknown_.push_back(letter);
        }
        return cells;
    }

    std::optional<Cells> known_cells(std::string_view text) const {
        try {
            return to_braille(text, table_, kOrigin);
        } catch (const Error& error) {
            if (!std::string_view(error.what()).starts_with(kOrigin)) throw;  // the table itself
            return std::nullopt;
        }
    }

    const std::string& table_;
    std::vector<std::string> unknown_;
};

Cells behind(std::size_t empty, const Cells& cells) {
    Cells line(empty, 0);
    line.insert(line.end(), cells.begin(), cells.end());
    return line;
}

std::vector<Cells> paragraph_lines(const Cells& cells, std::size_t most) {
    // The first line is shorter by what it is moved in: two cells stand before the words while they are broken.
    constexpr std::uint8_t kAnything = 1;
    std::vector<Cells> lines = wrapped(
        [&] {
            Cells moved(kIndent, kAnything);
            moved.insert(moved.end(), cells.begin(), cells.end());
            return moved;
        }(),
        most);
    if (!lines.empty())
        for (std::size_t i = 0; i < std::min(kIndent, lines.front().size()); ++i) lines.front()[i] = 0;
    return lines;
}

std::vector<Cells> heading_lines(const Cells& cells, std::size_t most) {
    std::vector<Cells> lines;
    for (const Cells& line : wrapped(cells, most > 4 * kCentred ? most - 2 * kCentred : most))
        lines.push_back(behind((most - std::min(most, line.size())) / 2, line));
    return lines;
}

// A sheet without a drawing: what stands on it, line by line.
class Lines {
public:
    explicit Lines(const Sheet& sheet) : sheet_(sheet), first_(sheet) {
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
            throw Error(Fault::usage, spelled("paper"),
                        "it has room for " + std::to_string(cells_) + " cells and " + std::to_string(rows_below(top_of(0))) +
                            " lines of text; take larger paper, a smaller " + spelled("margin") + " or a shorter title");
        begin_page();
    }

    std::size_t cells() const { return cells_; }
    std::size_t left() const { return rows_ - row_; }
    bool at_top() const { return row_ == 0; }

    void begin_page() {
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
            const Cells number = to_braille(std::to_string(i + 1), sheet_.braille_table, kOrigin);
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
    Sheet first_;
    Arrangement arrangement_;
    TitleBand band_;
    std::size_t cells_ = 0, rows_ = 0, row_ = 0;
    double top_ = 0;
    std::vector<Page> pages_;
};

}  // namespace

TextPages text_pages(const std::vector<TextBlock>& blocks, const Sheet& sheet) {
    if (sheet.braille_table.empty())
        throw Error(Fault::usage, spelled("braille"), "text is laid out in braille; name a table, or leave it out");
    Lines lines(sheet);
    Setting setting(sheet.braille_table);
    for (const TextBlock& block : blocks) {
        const Cells cells = setting.cells_of(to_line(block.text));
        if (cells.empty()) continue;
        if (block.kind == TextBlock::Kind::paragraph) {
            for (Cells& line : paragraph_lines(cells, lines.cells())) lines.add(std::move(line));
            continue;
        }
        std::vector<Cells> heading = heading_lines(cells, lines.cells());
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

std::string note_of_unknown(const std::vector<std::string>& letters) {
    if (letters.empty()) return "";
    constexpr std::size_t kNamed = 12;
    std::string named;
    for (std::size_t i = 0; i < std::min(letters.size(), kNamed); ++i) named += (i == 0 ? "\"" : ", \"") + letters[i] + "\"";
    if (letters.size() > kNamed) named += " and " + std::to_string(letters.size() - kNamed) + " more";
    return "the braille table has no cells for " + named + ": a full cell (dots 1 to 6) stands there; take another table with " +
           spelled("braille");
}

}  // namespace tactics
