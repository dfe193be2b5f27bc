// SPDX-License-Identifier: Apache-2.0
// The key, which explains the two letters beside things.
#pragma once

#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "tactics/layout/sheet.h"
#include "tactics/page.h"

namespace tactics {

/// In a key the words begin in cell 6 (BANA, Guidelines and Standards for Tactile Graphics), the two letters in cell 1.
inline constexpr std::size_t kWordsFrom = 5;

struct KeyEntry {
    std::string letters;              ///< two, from a to z
    std::string text;                 ///< the words that they stand for
    std::vector<std::uint8_t> cells;  ///< cells of the letters, then, from kWordsFrom on, of the text
};

/// The letters a to z have the same dots in the braille of every language that uses them.
std::uint8_t letter_cell(char letter);

/// Two unused letters, if possible from the words themselves, preferably their first letters; empty if all are taken. One of the
/// two has dot 3 or 6, so that a finger feels where the cell is (NBA).
std::string key_for(const std::string& text, const std::set<std::string>& taken);

/// All that there are.
std::size_t count_of_keys();

/// Pages with only the key, to follow `drawn`, in the same size: the title and the word for "key" in its language, then the
/// entries one below the other, in as many columns and pages as they need.
///
/// Throws Error(usage) if the paper is too small for an entry.
std::vector<Page> key_pages(const std::vector<KeyEntry>& entries, const Page& drawn, const Sheet& sheet);

}  // namespace tactics
