// SPDX-License-Identifier: Apache-2.0
// An option of a filter or a format, described once; checking, help, completion, man page and fuzzing all read this description.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tactics/spot.h"

namespace tactics {

struct Option {
    enum class Type {
        number,  ///< any number in [min, max]
        whole,   ///< an integer in [min, max]
        length,  ///< mm in [min, max]; read with mm, cm, in or pt
        choice,  ///< one of `choices`; its value is the index
        spots,   ///< boxes and points in the picture, as parse_spots reads them; none by default
        words,   ///< a line of text, empty by default; only for formats, because words in a recipe's step end at spaces
        date,    ///< a day from 1980 to 2107 as 2026-03-31; none by default
    };
    std::string_view name = {};
    Type type = Type::number;
    double fallback = 0;  ///< the default (for a choice, its index)
    double min = 0;
    double max = 0;
    std::string_view unit = {};     ///< for the help: "mm", "grey levels", "dpi"; empty if it has none
    std::string_view summary = {};  ///< one line
    std::string_view choices =
        {};  ///< for Type::choice: names separated by one space; for Type::spots: kBoxesOnly if it takes no points
};

inline constexpr std::string_view kBoxesOnly = "boxes";

/// Values for all options of one entry, in their order. Always complete and in range.
class Settings {
public:
    /// All defaults. `options` must outlive the settings (they are static descriptions).
    explicit Settings(std::span<const Option> options);

    /// Sets `name` from text. Throws Error(usage) at `place` on an unknown name (nearest named), a bad number, a value out of
    /// range (names the range). `owner` is the filter's or format's name for the message.
    void set(std::string_view name, std::string_view text, std::string_view place, std::string_view owner);

    double number(std::string_view name) const;                   ///< number, length (mm)
    int whole(std::string_view name) const;                       ///< whole
    std::string_view choice(std::string_view name) const;         ///< choice
    const std::vector<Spot>& spots(std::string_view name) const;  ///< spots
    const std::string& words(std::string_view name) const;        ///< words, or a date as YYYY-MM-DD; empty: none

    /// Its value as set() reads it.
    std::string text(std::string_view name) const { return text_of(index_of(name)); }

    bool is_default(std::string_view name) const { return is_default(index_of(name)); }

    std::span<const Option> options() const { return options_; }
    /// `name=value` for each setting that is not the default, separated by spaces; lengths with their unit.
    std::string to_text() const;

private:
    bool is_default(std::size_t index) const;
    std::string text_of(std::size_t index) const;
    std::size_t index_of(std::string_view name) const;
    std::span<const Option> options_;
    std::vector<double> values_;
    std::vector<std::vector<Spot>> spots_;  // of the options of type spots
    std::vector<std::string> words_;        // of the options of type words or date
};

/// "0.1 to 20 mm, default 0.5 mm" or "median, bilateral; default median" or "a box ...".
std::string describe_range(const Option& option);
std::vector<std::string_view> choice_names(const Option& option);

}  // namespace tactics
