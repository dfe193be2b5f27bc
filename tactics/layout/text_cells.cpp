// SPDX-License-Identifier: Apache-2.0
#include "tactics/layout/text_cells.h"

#include <algorithm>
#include <array>

#include "tactics/braille/braille.h"
#include "tactics/error.h"
#include "tactics/text/utf8.h"

namespace tactics {

namespace {

using Cells = std::vector<std::uint8_t>;

constexpr std::size_t kMostBytes = 2000;  // that are set at a time: liblouis takes no more than some
constexpr std::uint8_t kFullCell = 0x3F;  // for a letter that has none
constexpr std::string_view kOrigin = "the text";

// The Unicode Standard, Alphabetic Presentation Forms.
constexpr char32_t kFirstLigature = 0xFB00;
constexpr std::array<std::string_view, 7> kLigatures = {"ff", "fi", "fl", "ffi", "ffl", "st", "st"};

std::string without_ligatures(std::string_view text) {
    std::string out;
    while (!text.empty()) {
        const char32_t letter = take_letter(text);
        if (letter >= kFirstLigature && letter < kFirstLigature + kLigatures.size())
            out += kLigatures[letter - kFirstLigature];
        else
            append_letter(out, letter);
    }
    return out;
}

// The digit of a superscript, or a minus; nothing: it is neither.
std::optional<char> lowered(char32_t letter) {
    if (letter == 0x2070 || (letter >= 0x2074 && letter <= 0x2079)) return static_cast<char>('0' + (letter - 0x2070));
    if (letter == 0xB9) return '1';
    if (letter == 0xB2 || letter == 0xB3) return static_cast<char>('0' + (letter - 0xB0));
    return letter == 0x207B ? std::optional('-') : std::nullopt;
}

// For a table that lacks a letter of it: how letters join is left out, and "x\u00B2" is x^2.
std::string in_usual_letters(std::string_view text) {
    std::string out;
    bool raised = false;
    while (!text.empty()) {
        const char32_t letter = take_letter(text);
        const auto number = lowered(letter);
        if (number && !raised) out += '^';
        raised = number.has_value();
        if (number)
            out += *number;
        else if (letter != 0x200C && letter != 0x200D)
            append_letter(out, letter);
    }
    return out;
}

std::string_view first_letter(std::string_view text) {
    std::string_view rest = text;
    take_letter(rest);
    return text.substr(0, text.size() - rest.size());
}

// At a blank, where there is one.
std::size_t end_of_part(std::string_view text) {
    if (text.size() <= kMostBytes) return text.size();
    const auto blank = text.rfind(' ', kMostBytes);
    if (blank != std::string_view::npos && blank > 0) return blank;
    return std::min(text.find(' '), text.size());
}

void append(Cells& cells, const Cells& more) {
    if (!cells.empty() && !more.empty()) cells.push_back(0);
    cells.insert(cells.end(), more.begin(), more.end());
}

}  // namespace

Cells TextCells::of(std::string_view line) {
    const std::string plain = without_ligatures(line);
    Cells cells;
    for (std::string_view text = plain; !text.empty();) {
        const std::string_view next = text.substr(0, end_of_part(text));
        text.remove_prefix(std::min(next.size() + 1, text.size()));
        append(cells, part(next));
    }
    return cells;
}

std::optional<Cells> TextCells::known(std::string_view text) const {
    try {
        return to_braille(text, table_, kOrigin);
    } catch (const Error& error) {
        if (!std::string_view(error.what()).starts_with(kOrigin)) throw;  // the table itself
        return std::nullopt;
    }
}

Cells TextCells::part(std::string_view part) {
    if (auto cells = known(part)) return *cells;
    Cells cells;
    while (!part.empty()) {
        const std::string_view next = part.substr(0, part.find(' '));
        part.remove_prefix(std::min(next.size() + 1, part.size()));
        append(cells, word(next));
    }
    return cells;
}

Cells TextCells::word(std::string_view word) {
    if (auto cells = known(word)) return *cells;
    return runs(in_usual_letters(word));
}

// The text between letters without cells is set as a whole: a number keeps its sign, a contraction its cells.
Cells TextCells::runs(std::string_view word) {
    Cells cells;
    const auto set = [&](std::string_view run) {
        if (run.empty()) return;
        if (const auto whole = run.size() <= kMostBytes ? known(run) : std::nullopt) {
            cells.insert(cells.end(), whole->begin(), whole->end());
            return;
        }
        while (!run.empty()) {
            const std::string_view letter = first_letter(run);
            const Cells alone = known(letter).value_or(Cells{kFullCell});
            cells.insert(cells.end(), alone.begin(), alone.end());
            run.remove_prefix(letter.size());
        }
    };
    std::size_t begin = 0;
    for (std::size_t at = 0; at < word.size();) {
        const std::string_view letter = first_letter(word.substr(at));
        if (lacks(letter)) {
            set(word.substr(begin, at - begin));
            cells.push_back(kFullCell);
            begin = at + letter.size();
        }
        at += letter.size();
    }
    set(word.substr(begin));
    return cells;
}

bool TextCells::lacks(std::string_view letter) {
    std::string own(letter);
    if (has_.contains(own)) return false;
    if (lacking_.contains(own)) return true;
    if (known(letter)) {
        has_.insert(std::move(own));
        return false;
    }
    if (unknown_.size() < kMostUnknown) unknown_.push_back(own);
    lacking_.insert(std::move(own));
    return true;
}

}  // namespace tactics
