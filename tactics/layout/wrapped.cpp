// SPDX-License-Identifier: Apache-2.0
#include "tactics/layout/wrapped.h"

#include <algorithm>

#include "tactics/braille/braille.h"
#include "tactics/braille/hyphenation.h"
#include "tactics/error.h"

namespace tactics {

namespace {

using Cells = std::vector<std::uint8_t>;

// Bytes of text in a cell, at most: where a contraction is longer, a shorter part is taken.
constexpr std::size_t kMostBytesOfCell = 16;

void extend(Cells& line, const Cells& more) { line.insert(line.end(), more.begin(), more.end()); }

// The longest of the parts, each longer than the one before, that `fits`; 0: none does. Of neighbours the longer may have a cell
// less, so the two after the first that does not fit are tried, too.
std::size_t longest_fitting(const std::vector<std::size_t>& parts, const std::function<bool(std::size_t)>& fits) {
    std::size_t some = 0, too_many = 1;
    while (too_many <= parts.size() && fits(parts[too_many - 1])) {
        some = too_many;
        too_many *= 2;
    }
    too_many = std::min(too_many, parts.size() + 1);
    while (too_many - some > 1) {
        const std::size_t middle = (some + too_many) / 2;
        (fits(parts[middle - 1]) ? some : too_many) = middle;
    }
    for (std::size_t more = 2; more > 0; --more)
        if (some + more < parts.size() && fits(parts[some + more])) return parts[some + more];
    return some == 0 ? 0 : parts[some - 1];
}

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

std::vector<Cells> WordDivision::cut(const Cells& cells, std::size_t first, std::size_t most) const {
    std::vector<Cells> lines;
    auto at = cells.begin();
    for (std::size_t room = first; static_cast<std::size_t>(cells.end() - at) > room; room = most) {
        // A line with room for little more than the hyphen gets none: the word's own cells are worth more.
        const bool hyphened = room > 2 * hyphen_.size();
        const auto end = at + static_cast<std::ptrdiff_t>(room - (hyphened ? hyphen_.size() : 0));
        extend(lines.emplace_back(at, end), hyphened ? hyphen_ : Cells());
        at = end;
    }
    lines.emplace_back(at, cells.end());
    return lines;
}

std::vector<Cells> WordDivision::lines_of(const std::string& word, const Cells& cells, std::size_t first,
                                          std::size_t most) const {
    if (word.empty() || !cells_of_ || cells.size() <= first) return cut(cells, first, most);
    std::vector<std::size_t> places = places_to_divide(word, table_, language_);
    places.push_back(word.size());
    std::vector<Cells> lines;
    std::size_t room = first, from = 0;
    auto next = places.cbegin();
    while (from < word.size()) {
        bool known = true;
        const auto part_to = [&](std::size_t place) {
            const std::string part = word.substr(from, place - from);
            std::optional<Cells> line = cells_of_(part);
            known = known && line;
            if (line && place < word.size() && !ends_in_hyphen(part)) extend(*line, hyphen_);
            return line.value_or(Cells());
        };
        const auto end = std::upper_bound(next, places.cend(), from + kMostBytesOfCell * room);
        const std::size_t to = longest_fitting({next, end}, [&](std::size_t place) { return part_to(place).size() <= room; });
        if (!known) return cut(cells, first, most);  // it has letters that have cells in other words only
        if (to == 0) break;
        lines.push_back(part_to(to));
        next = std::upper_bound(next, end, to);
        from = to;
        room = most;
    }
    if (from == word.size()) return lines;
    const std::optional<Cells> rest = from == 0 ? cells : cells_of_(word.substr(from));
    if (!rest) return cut(cells, first, most);
    for (Cells& line : cut(*rest, room, most)) lines.push_back(std::move(line));
    return lines;
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

std::vector<Cells> wrapped(const Cells& cells, std::size_t most, const WordDivision& division, std::size_t less) {
    std::vector<Cells> lines;
    Cells line;
    const std::size_t all = words_in(cells);
    std::size_t room = most - std::min(less, most - 1), number = 0;  // of the line; of the words before this one
    const auto end_line = [&] {
        lines.push_back(std::move(line));
        line.clear();
        room = most;
    };
    for (auto at = cells.begin();;) {
        const auto begin = std::find_if(at, cells.end(), [](std::uint8_t cell) { return cell != 0; });
        if (begin == cells.end()) break;
        const auto end = std::find(begin, cells.end(), std::uint8_t{0});
        if (!line.empty() && line.size() + static_cast<std::size_t>(end - at) > room) end_line();
        if (!line.empty()) line.insert(line.end(), at, begin);
        const auto length = static_cast<std::size_t>(end - begin);
        if (line.size() + length <= room) {
            line.insert(line.end(), begin, end);
        } else {
            for (Cells& part : division.lines_of(division.word(number, all), {begin, end}, room, most)) {
                if (!line.empty()) end_line();
                line = std::move(part);
            }
        }
        ++number;
        at = end;
    }
    if (!line.empty()) lines.push_back(std::move(line));
    return lines;
}

}  // namespace tactics
