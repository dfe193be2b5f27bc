// SPDX-License-Identifier: Apache-2.0
// Text to braille cells, for any letters.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

namespace tactics {

/// Translates text with one table. Letters without cells are recorded, and everything else is set.
class TextCells {
public:
    /// `table` must outlive it.
    explicit TextCells(const std::string& table) : table_(table) {}

    /// The cells of one line of any length (to_line). Ligatures (U+FB00 to U+FB06) are set as their letters. Joiners and
    /// non-joiners count only if the table has them; so do superscript numbers, which otherwise follow a ^. A full cell replaces
    /// a letter without cells. Throws Error(usage) at the wish "braille", as to_braille.
    std::vector<std::uint8_t> of(std::string_view line);

    /// The same, or nothing if a letter has no cells.
    std::optional<std::vector<std::uint8_t>> known(std::string_view text) const;

    /// Letters without cells, each once, the first kMostUnknown of them.
    const std::vector<std::string>& unknown() const { return unknown_; }

    static constexpr std::size_t kMostUnknown = 100;

private:
    std::vector<std::uint8_t> part(std::string_view part);
    std::vector<std::uint8_t> word(std::string_view word);
    std::vector<std::uint8_t> runs(std::string_view word);
    bool lacks(std::string_view letter);

    const std::string& table_;
    std::vector<std::string> unknown_;
    std::unordered_set<std::string> lacking_, has_;  // letters already tried
};

}  // namespace tactics
