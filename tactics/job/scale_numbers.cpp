// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/scale_numbers.h"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

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
std::size_t thin_out_for_room(std::vector<ToldWords>& told, const std::function<std::size_t()>& left_out,
                              const std::function<void()>& keep) {
    constexpr double kName = 4;  // numbers of a scale. A setting
    constexpr int kThinnings = 2;
    struct Best {
        std::vector<ToldWords> told;
        std::size_t thinned = 0;
        double lost = std::numeric_limits<double>::infinity();
    } best;
    const auto try_this = [&](std::size_t thinned) {
        const std::size_t names = left_out();
        if (const double lost = kName * static_cast<double>(names) + static_cast<double>(thinned); lost < best.lost) {
            best = {told, thinned, lost};
            keep();
        }
        return names == 0;
    };
    bool done = try_this(0);
    std::size_t thinned = 0;
    for (int round = 0; round < kThinnings && !done; ++round) {
        const std::vector<ToldWords> before = told;
        const std::size_t rows = thin_out(told, &ToldWords::x, &ToldWords::y);
        if (rows > 0 && try_this(thinned + rows)) break;
        told = before;
        const std::size_t columns = thin_out(told, &ToldWords::y, &ToldWords::x);
        if (columns > 0 && try_this(thinned + columns)) break;
        told = before;
        thinned += thin_out(told);
        done = rows > 0 && columns > 0 && try_this(thinned);
        if (best.thinned == 0) break;  // it does not help
    }
    told = std::move(best.told);
    return best.thinned;
}

}  // namespace tactics
