// SPDX-License-Identifier: Apache-2.0
#include "tactics/layout/wrapped.h"

#include <algorithm>

#include "tactics/braille/braille.h"
#include "tactics/braille/hyphenation.h"
#include "tactics/error.h"

namespace tactics {

namespace {

using Cells = std::vector<std::uint8_t>;

bool ends_with(const Cells& cells, const Cells& end) {
    return cells.size() >= end.size() && std::equal(end.rbegin(), end.rend(), cells.rbegin());
}

// What is still to be broken into lines.
class Rest {
public:
    Rest(Cells cells, const WordDivision& division) : cells_(std::move(cells)), division_(division), words_(words_in(cells_)) {}

    bool begin_line() {
        while (at_ < cells_.size() && cells_[at_] == 0) ++at_;
        return at_ < cells_.size();
    }

    Cells take_line(std::size_t most) {
        std::size_t end = std::min(cells_.size(), at_ + most);
        if (end < cells_.size() && cells_[end] != 0) {
            std::size_t blank = end;
            while (blank > at_ && cells_[blank - 1] != 0) --blank;
            if (blank == at_) return take_part(most);
            end = blank;
        }
        Cells line(place(at_), place(end));
        while (!line.empty() && line.back() == 0) line.pop_back();
        number_ += words_in(line);
        word_.reset();
        at_ = end;
        return line;
    }

private:
    Cells::const_iterator place(std::size_t at) const { return cells_.begin() + static_cast<std::ptrdiff_t>(at); }

    // Of a word that is longer than the line.
    Cells take_part(std::size_t most) {
        if (!word_) word_ = division_.word(number_, words_);
        if (auto parts = division_.divide(*word_, most)) {
            const auto end = std::find(place(at_), cells_.cend(), std::uint8_t{0});
            Cells after = std::move(parts->rest);
            after.insert(after.end(), end, cells_.cend());
            cells_ = std::move(after);
            at_ = 0;
            word_ = std::move(parts->rest_word);
            return std::move(parts->first);
        }
        word_ = "";  // what is left of it is no word
        // A line with room for little more than the hyphen gets none: the word's own cells are worth more.
        const Cells& hyphen = division_.hyphen();
        const bool room = most > 2 * hyphen.size();
        const std::size_t end = at_ + most - (room ? hyphen.size() : 0);
        Cells line(place(at_), place(end));
        if (room) line.insert(line.end(), hyphen.begin(), hyphen.end());
        at_ = end;
        return line;
    }

    Cells cells_;
    const WordDivision& division_;
    std::size_t words_, at_ = 0, number_ = 0;  // the number of the word that the line begins with
    std::optional<std::string> word_;          // what is left of a word that was divided
};

}  // namespace

std::size_t words_in(const Cells& cells) {
    std::size_t words = 0;
    for (std::size_t i = 0; i < cells.size(); ++i) words += cells[i] != 0 && (i == 0 || cells[i - 1] == 0) ? 1 : 0;
    return words;
}

WordDivision::WordDivision(Cells hyphen, std::string_view text, std::string braille_table, std::string language,
                           std::function<std::optional<Cells>(const std::string&)> cells_of)
    : hyphen_(std::move(hyphen)),
      table_(std::move(braille_table)),
      language_(std::move(language)),
      cells_of_(std::move(cells_of)) {
    while (!text.empty()) {
        const std::string_view word = text.substr(0, text.find(' '));
        if (!word.empty()) words_.emplace_back(word);
        text.remove_prefix(std::min(text.size(), word.size() + 1));
    }
}

std::string WordDivision::word(std::size_t number, std::size_t words) const {
    return words == words_.size() && number < words ? words_[number] : "";
}

std::optional<WordDivision::Parts> WordDivision::divide(const std::string& word, std::size_t most) const {
    if (word.empty() || !cells_of_) return std::nullopt;
    std::vector<std::size_t> places = places_to_divide(word, table_, language_);
    std::reverse(places.begin(), places.end());
    for (const std::size_t place : places) {
        std::optional<Cells> first = cells_of_(word.substr(0, place));
        if (!first) return std::nullopt;
        if (!ends_with(*first, hyphen_) || hyphen_.empty()) first->insert(first->end(), hyphen_.begin(), hyphen_.end());
        if (first->size() > most) continue;
        std::optional<Cells> rest = cells_of_(word.substr(place));
        if (!rest) return std::nullopt;
        return Parts{std::move(*first), std::move(*rest), word.substr(place)};
    }
    return std::nullopt;
}

std::vector<std::uint8_t> hyphen_of(const std::string& braille_table) {
    constexpr std::size_t kLongest = 3;  // cells; a table that writes more for it means something else
    if (braille_table.empty()) return {};
    try {
        std::vector<std::uint8_t> cells = to_braille("-", braille_table, "-");
        return cells.size() <= kLongest ? cells : std::vector<std::uint8_t>();
    } catch (const Error&) {
        return {};  // it has no cells for it
    }
}

WordDivision division_in(const Sheet& sheet, const std::string& text) {
    return {hyphen_of(sheet.braille_table), text, sheet.braille_table, sheet.language,
            [table = sheet.braille_table](const std::string& part) -> std::optional<Cells> {
                try {
                    return to_braille(part, table, part);
                } catch (const Error&) {
                    return std::nullopt;  // letters that it has in other words only
                }
            }};
}

std::vector<Cells> wrapped(Cells cells, std::size_t most, const WordDivision& division, std::size_t less) {
    std::vector<Cells> lines;
    for (Rest rest(std::move(cells), division); rest.begin_line();)
        lines.push_back(rest.take_line(most - (lines.empty() ? std::min(less, most - 1) : 0)));
    return lines;
}

}  // namespace tactics
