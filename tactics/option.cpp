// SPDX-License-Identifier: Apache-2.0
#include "tactics/option.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "tactics/error.h"
#include "tactics/text/utf8.h"
#include "tactics/text/words.h"
#include "tactics/units.h"

namespace tactics {

std::vector<std::string_view> choice_names(const Option& option) { return words_of(option.choices); }

namespace {

constexpr std::size_t kMostWords = 500;

bool is_words(const Option& option) { return option.type == Option::Type::words || option.type == Option::Type::date; }

std::string value_text(const Option& option, double value) {
    switch (option.type) {
        case Option::Type::choice: return std::string(choice_names(option)[static_cast<std::size_t>(value)]);
        case Option::Type::length: return to_text(value) + "mm";
        case Option::Type::number:
        case Option::Type::whole:
        case Option::Type::spots:
        case Option::Type::words:
        case Option::Type::date: break;
    }
    return to_text(value);
}

// Those that differ between languages.
constexpr SourceWords kUnits[] = {"percent", "grey levels", "square cm", "cells",      "classes",
                                  "pins",    "pixels",      "regions",   "% of height"};

// A number as it is typed.
Phrase with_unit(const Option& option, double value) {
    if (option.unit.empty()) return to_text(value);
    const auto unit =
        std::find_if(std::begin(kUnits), std::end(kUnits), [&](SourceWords one) { return one.text == option.unit; });
    return phrase("{0} {1}", to_text(value), unit == std::end(kUnits) ? Phrase(option.unit) : phrase(*unit));
}

Phrase range_words(const Option& option) {
    if (option.type == Option::Type::spots && option.choices == kBoxesOnly)
        return phrase("a box such as 20%,30%-70%,90%, several joined by \";\"; default none");
    if (option.type == Option::Type::spots)
        return phrase("a box such as 20%,30%-70%,90%, a point such as 40%,50%, several joined by \";\"; default none");
    if (option.type == Option::Type::words)
        return phrase("one line of at most {0} bytes of UTF-8; default none", std::to_string(kMostWords));
    if (option.type == Option::Type::date) return phrase("a day from 1980-01-01 to 2107-12-31, written like that; default none");
    if (option.type == Option::Type::choice) {
        std::string all;
        for (const auto name : choice_names(option)) all += (all.empty() ? "" : ", ") + std::string(name);
        return phrase("{0}; default {1}", all, value_text(option, option.fallback));
    }
    return phrase("{0} to {1}, default {2}", to_text(option.min), with_unit(option, option.max),
                  with_unit(option, option.fallback));
}

double parse_choice(const Option& option, std::string_view text, std::string_view place, const std::string& what) {
    const auto names = choice_names(option);
    for (std::size_t i = 0; i < names.size(); ++i)
        if (names[i] == text) return static_cast<double>(i);
    std::string all;
    for (const auto name : names) all += (all.empty() ? "" : ", ") + std::string(name);
    throw Error(Fault::usage, place,
                phrase("{0} cannot be \"{1}\"; it is one of {2}{3}", what, text, all, did_you_mean(text, names)));
}

double parse_value(const Option& option, std::string_view text, std::string_view place, std::string_view owner) {
    const std::string what = std::string(owner) + " " + std::string(option.name);
    if (option.type == Option::Type::choice) return parse_choice(option, text, place, what);
    auto value = option.type == Option::Type::length ? parse_length(text) : parse_number(text);
    const bool whole = option.type == Option::Type::whole;
    if (!value || (whole && *value != std::floor(*value)))
        throw Error(
            Fault::usage, place,
            option.type == Option::Type::length
                ? phrase("{0} cannot be \"{1}\"; it is a length such as 1.5mm or 0.1in, {2}", what, text, range_words(option))
                : phrase("{0} cannot be \"{1}\"; it is {2}, {3}", what, text,
                         whole ? phrase("a whole number") : phrase("a number"), range_words(option)));
    // To the six decimals that to_text writes, so that a saved setting is the same number when it is read back.
    value = std::round(*value * 1e6) / 1e6;
    if (*value < option.min || *value > option.max)
        throw Error(Fault::usage, place, phrase("{0}={1} is out of range; it is {2}", what, text, range_words(option)));
    return *value;
}

// The days that a ZIP archive can hold (PKWARE APPNOTE 6.3, 4.4.6: 7 bits for the years since 1980).
constexpr int kFirstYear = 1980, kLastYear = 2107;

bool is_day(std::string_view text) {
    const auto number = [&](std::size_t at, std::size_t count) {
        int value = 0;
        for (const char digit : text.substr(at, count)) value = digit < '0' || digit > '9' ? -10'000 : 10 * value + digit - '0';
        return value;
    };
    if (text.size() != 10 || text[4] != '-' || text[7] != '-') return false;
    const int year = number(0, 4), month = number(5, 2), day = number(8, 2);
    constexpr int kDays[] = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
    const bool leap = year % 4 == 0 && (year % 100 != 0 || year % 400 == 0);
    return year >= kFirstYear && year <= kLastYear && month >= 1 && month <= 12 && day >= 1 &&
           day <= kDays[month - 1] + (month == 2 && leap ? 1 : 0);
}

std::string parse_words(const Option& option, std::string_view text, std::string_view place, const std::string& what) {
    const auto refused = [&] {
        return Error(Fault::usage, place,
                     phrase("{0} cannot be \"{1}\"; it is {2}", what, beginning_of(to_line(text)), range_words(option)));
    };
    if (option.type == Option::Type::date && !text.empty() && !is_day(text)) throw refused();
    if (option.type == Option::Type::words && (text.size() > kMostWords || to_line(text) != text)) throw refused();
    return std::string(text);
}

}  // namespace

std::string describe_range(const Option& option) { return range_words(option).english(); }

Settings::Settings(std::span<const Option> options) : options_(options) {
    values_.reserve(options.size());
    for (const auto& option : options) values_.push_back(option.fallback);
    spots_.resize(options.size());
    words_.resize(options.size());
}

void Settings::set(std::string_view name, std::string_view text, std::string_view place, std::string_view owner) {
    std::vector<std::string_view> names;
    for (std::size_t i = 0; i < options_.size(); ++i) {
        if (options_[i].name == name && options_[i].type == Option::Type::spots) {
            const std::string what = std::string(owner) + " " + std::string(name);
            spots_[i] = parse_spots(text, place, what);
            if (options_[i].choices == kBoxesOnly &&
                !std::all_of(spots_[i].begin(), spots_[i].end(), [](const Spot& s) { return s.is_box(); }))
                throw Error(
                    Fault::usage, place,
                    phrase("{0} has a point in \"{1}\"; it takes boxes such as 20%,30%-70%,90%", what, text.substr(0, 80)));
            return;
        }
        if (options_[i].name == name && is_words(options_[i])) {
            words_[i] = parse_words(options_[i], text, place, std::string(owner) + " " + std::string(name));
            return;
        }
        if (options_[i].name == name) {
            values_[i] = parse_value(options_[i], text, place, owner);
            return;
        }
        names.push_back(options_[i].name);
    }
    std::string known;
    for (const auto n : names) known += (known.empty() ? "" : ", ") + std::string(n);
    throw Error(Fault::usage, place,
                known.empty()
                    ? phrase("{0} has no setting \"{1}\"{2}; it has none", owner, name, did_you_mean(name, names))
                    : phrase("{0} has no setting \"{1}\"{2}; it has {3}", owner, name, did_you_mean(name, names), known));
}

std::size_t Settings::index_of(std::string_view name) const {
    for (std::size_t i = 0; i < options_.size(); ++i)
        if (options_[i].name == name) return i;
    throw std::logic_error("no option " + std::string(name));  // a filter asks for what it did not describe
}

double Settings::number(std::string_view name) const { return values_[index_of(name)]; }
int Settings::whole(std::string_view name) const { return static_cast<int>(values_[index_of(name)]); }

const std::vector<Spot>& Settings::spots(std::string_view name) const { return spots_[index_of(name)]; }
const std::string& Settings::words(std::string_view name) const { return words_[index_of(name)]; }

std::string_view Settings::choice(std::string_view name) const {
    const std::size_t index = index_of(name);
    return choice_names(options_[index])[static_cast<std::size_t>(values_[index])];
}

bool Settings::is_default(std::size_t index) const {
    if (is_words(options_[index])) return words_[index].empty();
    return options_[index].type == Option::Type::spots ? spots_[index].empty() : values_[index] == options_[index].fallback;
}

std::string Settings::text_of(std::size_t index) const {
    if (is_words(options_[index])) return words_[index];
    return options_[index].type == Option::Type::spots ? tactics::to_text(spots_[index])
                                                       : value_text(options_[index], values_[index]);
}

std::string Settings::to_text() const {
    std::string text;
    for (std::size_t i = 0; i < options_.size(); ++i)
        if (!is_default(i)) text += (text.empty() ? "" : " ") + std::string(options_[i].name) + "=" + text_of(i);
    return text;
}

}  // namespace tactics
