// SPDX-License-Identifier: Apache-2.0
#include "cli/flag_values.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "tactics/error.h"
#include "tactics/readers/read.h"
#include "tactics/text/words.h"
#include "tactics/units.h"

namespace tactics {

namespace {

constexpr int kMostWorkers = 256;

}  // namespace

double length_value(const Given& given, std::string_view name, double least) {
    const std::string text = given.value(name);
    const auto length = parse_length(text);
    if (!length || *length < least)
        throw Error(Fault::usage, name,
                    phrase("it cannot be \"{0}\"; it is a length such as 12mm or 0.5in, at least {1} mm", text.substr(0, 80),
                           to_text(least)));
    return *length;
}

double number_value(const Given& given, std::string_view name, double fallback, double least, double most, bool whole) {
    if (!given.has(name)) return fallback;
    const auto number = parse_number(given.value(name));
    if (!number || *number < least || *number > most || (whole && *number != std::floor(*number)))
        throw Error(Fault::usage, name,
                    whole ? phrase("it is a whole number from {0} to {1}", to_text(least), to_text(most))
                          : phrase("it is a number from {0} to {1}", to_text(least), to_text(most)));
    return *number;
}

int page_value(const Given& given) {
    if (!given.has("--page")) return 0;
    const auto page = parse_number(given.value("--page"));
    if (!page || *page < 1 || *page > 1e6 || *page != std::floor(*page))
        throw Error(Fault::usage, "--page", phrase("it is the number of a page, from 1"));
    return static_cast<int>(*page);
}

std::vector<int> pages_value(const Given& given) {
    if (!given.has("--page")) return {0};
    constexpr std::size_t kMost = 10'000;
    std::set<int> pages;
    const std::string list = given.value("--page");
    for (std::size_t from = 0, comma = 0; comma != std::string::npos; from = comma + 1) {
        comma = list.find(',', from);
        const std::string part = list.substr(from, comma == std::string::npos ? comma : comma - from);
        const auto dash = part.find('-');
        const auto first = parse_number(part.substr(0, dash)),
                   last = dash == std::string::npos ? first : parse_number(part.substr(dash + 1));
        const auto whole = [](const std::optional<double>& page) {
            return page && *page >= 1 && *page <= 1e6 && *page == std::floor(*page);
        };
        if (!whole(first) || !whole(last) || *last < *first)
            throw Error(Fault::usage, "--page", phrase("it is the number of a page, from 1, or several such as 1-3,7"));
        for (double page = *first; page <= *last; ++page)
            if (pages.insert(static_cast<int>(page)).second && pages.size() > kMost)
                throw Error(Fault::usage, "--page", phrase("these are over 10,000 pages; convert them in parts"));
    }
    return {pages.begin(), pages.end()};
}

std::vector<std::string> allowed_formats(const Given& given) {
    const std::vector<std::string_view> names(std::begin(kAskedFormats), std::end(kAskedFormats));
    for (const std::string& name : given.all("--allow"))
        if (std::find(names.begin(), names.end(), name) == names.end())
            throw Error(Fault::usage, "--allow",
                        phrase("it cannot be \"{0}\"{1}; it is psd or ico, all other formats are read anyway", name.substr(0, 80),
                               did_you_mean(name, names)));
    return given.all("--allow");
}

int workers_value(const Given& given) {
    if (!given.has("--jobs")) return 0;
    const std::string text = given.value("--jobs");
    const auto number = parse_number(text);
    if (!number || *number < 1 || *number > kMostWorkers || *number != static_cast<int>(*number))
        throw Error(
            Fault::usage, "--jobs",
            phrase("it cannot be \"{0}\"; it is a whole number from 1 to {1}", text.substr(0, 80), std::to_string(kMostWorkers)));
    return static_cast<int>(*number);
}

Loudness loudness_value(const Given& given) {
    constexpr std::pair<std::string_view, Loudness> kWays[] = {
        {"--quiet", Loudness::errors}, {"--warnings", Loudness::warnings}, {"--verbose", Loudness::all}};
    std::string_view named;
    Loudness loudness = Loudness::usual;
    for (const auto& [flag, way] : kWays) {
        if (!given.has(flag)) continue;
        if (!named.empty()) throw Error(Fault::usage, flag, phrase("give this or {0}, not both", named));
        named = flag;
        loudness = way;
    }
    return loudness;
}

ProgressWay progress_of(const std::string& text, std::string_view place) {
    constexpr std::pair<std::string_view, ProgressWay> kWays[] = {
        {"none", ProgressWay::none}, {"lines", ProgressWay::lines}, {"bar", ProgressWay::bar}};
    std::vector<std::string_view> names;
    for (const auto& [name, way] : kWays) {
        if (name == text) return way;
        names.push_back(name);
    }
    throw Error(Fault::usage, place,
                phrase("it cannot be \"{0}\"{1}; it is none, lines or bar", text.substr(0, 80), did_you_mean(text, names)));
}

ProgressWay progress_value(const Given& given) {
    if (const KeptValue* kept = given.kept("progress")) return progress_of(kept->value, kept->place);
    return given.has("--progress") ? progress_of(given.value("--progress"), "--progress") : ProgressWay::automatic;
}

}  // namespace tactics
