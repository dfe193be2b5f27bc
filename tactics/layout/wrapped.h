// SPDX-License-Identifier: Apache-2.0
// Lines of braille: broken between words, and within a word where it is longer than a line.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tactics/layout/sheet.h"

namespace tactics {

/// How words that are longer than a line are divided: where their language divides them, with a hyphen. A part is translated by
/// itself, as contractions do not go over the end of a line.
class WordDivision {
public:
    using Cells = std::vector<std::uint8_t>;

    /// Words are cut after any cell, without or with a hyphen.
    WordDivision() = default;
    explicit WordDivision(Cells hyphen) : hyphen_(std::move(hyphen)) {}
    /// Words of the text are divided as places_to_divide has it (tactics/braille/hyphenation.h). `cells_of` gives the cells of a
    /// part, or nothing if it has none.
    WordDivision(Cells hyphen, std::string_view text, std::string braille_table, std::string language,
                 std::function<std::optional<Cells>(const std::string& part)> cells_of);

    /// A word of the text, counted from 0; empty if the text has not as many words as its cells.
    std::string word(std::size_t number, std::size_t words) const;
    /// The lines that a word takes alone: the first of at most `first` cells, the others of at most `most`, each as long as it
    /// can be, and each but the last with a hyphen, if it does not end in one of the word's own. `cells` are those of the whole
    /// word. It is cut after any cell if it is empty or its letters have no cells in parts of it, and from the first place where
    /// no part is short enough.
    std::vector<Cells> lines_of(const std::string& word, const Cells& cells, std::size_t first, std::size_t most) const;

private:
    std::vector<Cells> cut(const Cells& cells, std::size_t first, std::size_t most) const;

    Cells hyphen_;
    std::vector<std::string> words_;
    std::string table_, language_;
    std::function<std::optional<Cells>(const std::string&)> cells_of_;
};

/// That of a text on a sheet, with the hyphen of its braille table.
WordDivision division_in(const Sheet& sheet, const std::string& text);

/// The cells of a hyphen in that table; empty: it has no short one, or there is no table.
std::vector<std::uint8_t> hyphen_of(const std::string& braille_table);

/// Runs of cells that are not blank.
std::size_t words_in(const std::vector<std::uint8_t>& cells);

/// Lines of at most `most` cells, broken at blank cells; the first has `less` cells fewer. A longer word is divided, or cut where
/// the division does not know it.
std::vector<std::vector<std::uint8_t>> wrapped(const std::vector<std::uint8_t>& cells, std::size_t most,
                                               const WordDivision& division, std::size_t less = 0);

}  // namespace tactics
