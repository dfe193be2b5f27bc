// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/cell.h"

#include <algorithm>
#include <array>

#include "tactics/text/number.h"
#include "tactics/text/utf8.h"

namespace tactics {

namespace {

constexpr std::size_t kLongestNumber = 400;  // letters; the longest double without an exponent has 1 + 17 + 307

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool is_word(std::string_view cell, std::string_view word) {
    return std::equal(cell.begin(), cell.end(), word.begin(), word.end(), [](char a, char b) { return lower(a) == b; });
}

}  // namespace

bool is_gap(std::string_view cell) {
    if (cell.empty() || cell == "-") return true;
    return is_word(cell, "nan") || is_word(cell, "na") || is_word(cell, "n/a") || is_word(cell, "null");
}

bool is_infinity(std::string_view cell) {
    if (!cell.empty() && (cell.front() == '+' || cell.front() == '-')) cell.remove_prefix(1);
    return is_word(cell, "inf") || is_word(cell, "infinity");
}

std::optional<double> number_in(std::string_view cell, Decimal decimal) {
    if (decimal == Decimal::point) return parse_number(cell);
    const auto comma = cell.find(',');
    if (comma == std::string_view::npos) {
        // A point would be one between thousands.
        return cell.find('.') == std::string_view::npos ? parse_number(cell) : std::nullopt;
    }
    std::array<char, kLongestNumber> text{};
    if (cell.size() > text.size() || cell.find('.') != std::string_view::npos) return std::nullopt;
    std::copy(cell.begin(), cell.end(), text.begin());
    text[comma] = '.';
    return parse_number({text.data(), cell.size()});
}

bool is_number(std::string_view cell) { return parse_number(cell).has_value() || number_in(cell, Decimal::comma).has_value(); }

bool has_thousands(std::string_view cell) {
    if (!cell.empty() && (cell.front() == '+' || cell.front() == '-')) cell.remove_prefix(1);
    std::size_t digits = 0, marks = 0;
    char mark = '\0';
    for (std::size_t i = 0;; ++i) {
        if (i < cell.size() && is_digit(cell[i])) {
            ++digits;
            continue;
        }
        // All groups but the first have three digits.
        if (digits == 0 || digits > 3 || (marks > 0 && digits != 3)) return false;
        if (i == cell.size()) return marks > 0;
        if (mark == '\0') mark = cell[i];
        if (cell[i] != mark) {
            // The fraction, with the other mark.
            return marks > 0 && (cell[i] == '.' || cell[i] == ',') &&
                   std::all_of(cell.begin() + static_cast<std::ptrdiff_t>(i) + 1, cell.end(), is_digit);
        }
        if (mark != ',' && mark != '.' && mark != '\'') return false;
        ++marks;
        digits = 0;
    }
}

}  // namespace tactics
