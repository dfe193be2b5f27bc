// SPDX-License-Identifier: Apache-2.0
// The key: what the two letters beside things stand for.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tactics/layout/sheet.h"
#include "tactics/page.h"

namespace tactics {

/// In a key the words begin in cell 6 (BANA, Guidelines and Standards for Tactile Graphics), the two letters in cell 1.
inline constexpr std::size_t kWordsFrom = 5;

struct KeyEntry {
    std::string letters;              ///< two, from a to z
    std::string text;                 ///< what they stand for
    std::vector<std::uint8_t> cells;  ///< of the letters, then from kWordsFrom on of the text
};

/// The letters a to z have the same dots in the braille of all languages that write them.
std::uint8_t letter_cell(char letter);

/// Pages with nothing but the key, for behind `drawn` and of its size: the title and what a key is called in its language, then
/// the entries one below the other, in as many columns and pages as they need.
///
/// Throws Error(usage) where the paper is too small for any entry.
std::vector<Page> key_pages(const std::vector<KeyEntry>& entries, const Page& drawn, const Sheet& sheet);

}  // namespace tactics
