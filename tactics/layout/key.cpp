// SPDX-License-Identifier: Apache-2.0
#include "tactics/layout/key.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "tactics/error.h"
#include "tactics/layout/sheet.h"
#include "tactics/layout/title.h"
#include "tactics/layout/wrapped.h"

namespace tactics {

namespace {

using Cells = std::vector<std::uint8_t>;

// A continuation line begins two cells after the words of the first line, as in braille lists: a hand that looks for the next
// letters at the left does not meet it.
constexpr std::size_t kRunoverFrom = kWordsFrom + 2;
// Between columns: a reading hand takes one blank cell for the end of a word, two for the end of a sentence. Own choice.
constexpr std::size_t kCellsBetween = 3;

struct KeyTitle {
    std::string_view language, alone, behind;
};
constexpr KeyTitle kTitles[] = {
#define KEY(language, alone, behind) {language, alone, behind},
#include "tactics/layout/key_titles.inc"
#undef KEY
};

bool has_low_dot(const std::string& key) {
    constexpr std::uint8_t kLow = 0b100100;  // dots 3 and 6
    return ((letter_cell(key[0]) | letter_cell(key[1])) & kLow) != 0;
}

// "Map of Lisbon, key"
std::string key_title(const Page& drawn) {
    const std::string_view language = std::string_view(drawn.language).substr(0, drawn.language.find('-'));
    for (const KeyTitle& title : kTitles)
        if (title.language == language)
            return drawn.title.empty() ? std::string(title.alone) : drawn.title + ", " + std::string(title.behind);
    return drawn.title;
}

// The lines of an entry, none longer than `most` cells.
std::vector<Cells> lines_of(const KeyEntry& entry, std::size_t most, const Sheet& sheet) {
    if (entry.cells.size() <= most) return {entry.cells};
    const WordDivision division = division_in(sheet, entry.text);
    const auto words = entry.cells.begin() + static_cast<std::ptrdiff_t>(kWordsFrom);
    std::vector<Cells> lines;
    for (Cells& part : wrapped({words, entry.cells.end()}, most - kRunoverFrom, division)) {
        Cells line(entry.cells.begin(), words);
        if (!lines.empty()) line.assign(kRunoverFrom, 0);
        line.insert(line.end(), part.begin(), part.end());
        lines.push_back(std::move(line));
    }
    return lines;
}

// A page with its title, to be filled with columns of lines from the top left.
class Filling {
public:
    Filling(const Page& page, const Sheet& sheet, std::size_t longest) : sheet_(sheet), drawn_(empty_like(page)) {
        drawn_.title = page.title;
        if (sheet.window) {
            drawn_.width = sheet.window->x;
            drawn_.height = sheet.window->y;
            drawn_.live.width -= page.width - drawn_.width;
            drawn_.live.height -= page.height - drawn_.height;
        }
        const Page& drawn = drawn_;
        Sheet titled = sheet;
        titled.title = key_title(drawn);
        titled.caption.clear();
        const Title title = title_of(titled);
        title_ = title.text;
        band_ = set_title(title, titled, drawn.live);
        const double dot = drawn.braille_dot, height = 2 * drawn.cell.dot_pitch + dot;
        const double across = drawn.live.width - dot - drawn.cell.dot_pitch, down = drawn.live.height - band_.height - height;
        const double fit = std::floor(across / drawn.cell.cell_pitch + 1e-9) + 1;
        if (!(fit > static_cast<double>(kRunoverFrom)) || down < 0)
            throw drawn.title.empty()
                ? Error(Fault::usage, spelled("paper"),
                        phrase("it is too small for the key of the labels, even on a page of its own; take larger paper or "
                               "shorter labels"))
                : Error(Fault::usage, sheet.title_origin,
                        phrase("the title leaves no room for the key on a page of its own; shorten it or take larger paper"));
        most_ = static_cast<std::size_t>(fit);
        width_ = std::min(longest, most_);
        columns_ = (most_ + kCellsBetween) / (width_ + kCellsBetween);
        rows_ = static_cast<std::size_t>(std::floor(down / drawn.cell.line_pitch + 1e-9)) + 1;
    }

    void add(const KeyEntry& entry) {
        std::vector<Cells> lines = lines_of(entry, most_, sheet_);
        // In one piece, if a column can hold it.
        if (pages_.empty() || (row_ > 0 && row_ + lines.size() > rows_)) begin_column();
        for (Cells& line : lines) {
            if (row_ == rows_) begin_column();
            const Point dot{
                drawn_.live.left + drawn_.braille_dot / 2 +
                    static_cast<double>(column_ * (width_ + kCellsBetween)) * drawn_.cell.cell_pitch,
                drawn_.live.top + band_.height + drawn_.braille_dot / 2 + static_cast<double>(row_) * drawn_.cell.line_pitch};
            Page& page = pages_.back();
            if (&line == &lines.front() || page.words.empty() || page.words.back().kind != WordsKind::key)
                page.words.push_back({WordsKind::key, entry.text, entry.letters});
            const int words = static_cast<int>(page.words.size()) - 1;
            if (&line == &lines.front()) {
                const Rect place{dot.x - drawn_.braille_dot / 2, dot.y - drawn_.braille_dot / 2,
                                 static_cast<double>(line.size()) * drawn_.cell.cell_pitch, drawn_.cell.line_pitch};
                page.names.push_back({entry.text, entry.letters, place.middle(), place, words});
            }
            page.braille.push_back({dot, std::move(line), words});
            ++row_;
        }
    }

    std::vector<Page> finish() { return std::move(pages_); }

private:
    void begin_column() {
        row_ = 0;
        if (!pages_.empty() && ++column_ < columns_) return;
        column_ = 0;
        Page& page = pages_.emplace_back(empty_like(drawn_));
        page.title = title_;
        if (!title_.empty()) page.words.push_back({WordsKind::title, title_});
        page.print = band_.print;
        page.braille = band_.braille;
        page.is_key = true;
    }

    const Sheet& sheet_;
    Page drawn_;  // of their size, with nothing on it
    std::string title_;
    TitleBand band_;
    std::size_t most_ = 0;                // cells of a line
    std::size_t width_ = 0;               // cells of a column
    std::size_t columns_ = 0, rows_ = 0;  // of a page
    std::size_t column_ = 0, row_ = 0;    // where the next line goes
    std::vector<Page> pages_;
};

}  // namespace

std::string key_for(const std::string& text, const std::set<std::string>& taken) {
    std::string letters;
    bool fresh = true;
    std::string initials;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x80 && std::isalpha(byte) != 0) {
            letters += static_cast<char>(std::tolower(byte));
            if (fresh) initials += letters.back();
        }
        fresh = byte < 0x80 && std::isalnum(byte) == 0;
    }
    const auto is_good = [&](const std::string& key) { return has_low_dot(key) && !taken.contains(key); };
    if (initials.size() > 1 && is_good(initials.substr(0, 2))) return initials.substr(0, 2);
    for (std::size_t i = 1; i < letters.size(); ++i)
        if (const std::string key{letters[0], letters[i]}; is_good(key)) return key;
    for (char a = 'a'; a <= 'z'; ++a)
        for (char b = 'a'; b <= 'z'; ++b)
            if (const std::string key{a, b}; is_good(key)) return key;
    return {};
}

std::size_t count_of_keys() {
    std::size_t count = 0;
    for (char a = 'a'; a <= 'z'; ++a)
        for (char b = 'a'; b <= 'z'; ++b) count += has_low_dot({a, b}) ? 1 : 0;
    return count;
}

std::uint8_t letter_cell(char letter) {
    constexpr std::uint8_t kLetters[] = {1,  3,  9,  25, 17, 11, 27, 19, 10, 26, 5,  7,  13,
                                         29, 21, 15, 31, 23, 14, 30, 37, 39, 58, 45, 61, 53};
    return kLetters[letter - 'a'];
}

std::vector<Page> key_pages(const std::vector<KeyEntry>& entries, const Page& drawn, const Sheet& sheet) {
    if (entries.empty()) return {};
    std::size_t longest = 0;
    for (const KeyEntry& entry : entries) longest = std::max(longest, entry.cells.size());
    Filling filling(drawn, sheet, longest);
    for (const KeyEntry& entry : entries) filling.add(entry);
    return filling.finish();
}

}  // namespace tactics
