// SPDX-License-Identifier: Apache-2.0
// Text to cells of braille, whatever letters it has.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

namespace tactics {

/// Sets text in one table. What the table has no cells for is kept, and everything else is set.
class TextCells {
public:
    /// `table` must outlive it.
    explicit TextCells(const std::string& table) : table_(table) {}

    /// Of one line of any length (to_line). Ligatures (U+FB00 to U+FB06) are set as their letters; joiners and non-joiners of
    /// letters count only if the table knows them, and so do raised numbers, which else follow a ^; in the place of a letter
    /// without cells stands a full one. Throws Error(usage) at the wish "braille", as to_braille.
    std::vector<std::uint8_t> of(std::string_view line);

    /// The same, or nothing: a letter has no cells.
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
    std::unordered_set<std::string> lacking_, has_;  // letters that were tried
};

}  // namespace tactics
