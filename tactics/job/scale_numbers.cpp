// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/scale_numbers.h"

#include <algorithm>
#include <string>

#include "tactics/units.h"

namespace tactics {

namespace {

bool is_all_figures(const std::string& text) {
    bool digit = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        digit = digit || (c >= '0' && c <= '9');
        const bool minus = text.compare(i, 3, "\xe2\x88\x92") == 0;  // U+2212
        if (minus)
            i += 2;
        else if ((c < '0' || c > '9') && c != '.' && c != ',' && c != '-' && c != '+' && c != '%')
            return false;
    }
    return digit;
}

// "1,000" as 1000, "−5 %" as -5.
double value_of(std::string text) {
    std::string plain;
    for (std::size_t i = 0; i < text.size(); ++i)
        if (text.compare(i, 3, "\xe2\x88\x92") == 0) {
            plain += '-';
            i += 2;
        } else if (text[i] != ',' && text[i] != '%' && text[i] != '+') {
            plain += text[i];
        }
    return parse_number(plain).value_or(0);
}

// Where numbers that grow or fall one after the other end: those of one scale. What comes again is of things.
std::size_t end_of_scale(const std::vector<ToldWords*>& row, std::size_t from) {
    std::size_t end = from + 1;
    const auto step = [&](std::size_t i) { return value_of(row[i]->text) - value_of(row[i - 1]->text); };
    while (end < row.size() && step(end) != 0 && (step(end) > 0) == (step(from + 1) > 0)) ++end;
    return end;
}

// Those whose place across is the same, in the order of their place along.
std::size_t thin_out(std::vector<ToldWords>& told, double ToldWords::*along, double ToldWords::*across) {
    constexpr double kSameRow = 2.5;  // percent of the picture: middles of "5" and "100" in a column differ by that
    constexpr std::size_t kRow = 4;
    std::vector<ToldWords*> numbers;
    for (ToldWords& one : told)
        if (one.set && is_all_figures(one.text)) numbers.push_back(&one);
    std::stable_sort(numbers.begin(), numbers.end(),
                     [&](const ToldWords* a, const ToldWords* b) { return a->*across < b->*across; });
    std::size_t left_out = 0;
    for (std::size_t begin = 0, end = 0; begin < numbers.size(); begin = end) {
        while (end < numbers.size() && numbers[end]->*across - numbers[begin]->*across <= kSameRow) ++end;
        std::vector<ToldWords*> row(numbers.begin() + static_cast<std::ptrdiff_t>(begin),
                                    numbers.begin() + static_cast<std::ptrdiff_t>(end));
        std::sort(row.begin(), row.end(), [&](const ToldWords* a, const ToldWords* b) { return a->*along < b->*along; });
        for (std::size_t from = 0, past = 0; from < row.size(); from = past) {
            past = end_of_scale(row, from);
            if (past - from < kRow) continue;
            for (std::size_t i = from + 1; i < past; i += 2, ++left_out) row[i]->set = false;
        }
    }
    return left_out;
}

}  // namespace

std::size_t thin_out(std::vector<ToldWords>& told) {
    const std::size_t in_rows = thin_out(told, &ToldWords::x, &ToldWords::y);
    return in_rows + thin_out(told, &ToldWords::y, &ToldWords::x);
}

// One axis may have too many numbers and the other not: rows alone are tried first, then columns alone, then both.
std::size_t thin_out_until(std::vector<ToldWords>& told, const std::function<bool()>& has_room) {
    constexpr int kThinnings = 2;
    std::size_t thinned = 0;
    int round = 0;
    while (!has_room() && round++ < kThinnings) {
        const std::vector<ToldWords> before = told;
        if (const std::size_t rows = thin_out(told, &ToldWords::x, &ToldWords::y); rows > 0 && has_room()) return thinned + rows;
        told = before;
        if (const std::size_t columns = thin_out(told, &ToldWords::y, &ToldWords::x); columns > 0 && has_room())
            return thinned + columns;
        told = before;
        const std::size_t more = thin_out(told);
        if (more == 0) break;
        thinned += more;
    }
    return thinned;
}

}  // namespace tactics
