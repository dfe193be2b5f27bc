// SPDX-License-Identifier: Apache-2.0
#include "tactics/lettering/two_readings.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "tactics/geometry/lots.h"
#include "tactics/text/utf8.h"

namespace tactics {

namespace {

bool are_at_one_place(const PixelBox& a, const PixelBox& b) {
    constexpr double kShare = 0.3;  // of the smaller one. A setting
    const int across = std::min(a.right, b.right) - std::max(a.left, b.left),
              down = std::min(a.bottom, b.bottom) - std::max(a.top, b.top);
    if (across <= 0 || down <= 0) return false;
    const auto area = [](const PixelBox& box) { return static_cast<double>(box.width()) * box.height(); };
    return static_cast<double>(across) * down >= kShare * std::min(area(a), area(b));
}

// Words of both readings that lie on each other.
struct Place {
    std::vector<PrintedWords*> given, smoothed;
};

std::vector<Place> places_of(Lettering& given, Lettering& smoothed) {
    std::vector<PrintedWords*> all;
    for (PrintedWords& one : given.words) all.push_back(&one);
    for (PrintedWords& one : smoothed.words) all.push_back(&one);
    const std::size_t own = given.words.size();
    Lots joined(all.size());
    for (std::size_t i = 0; i < own; ++i)
        for (std::size_t k = own; k < all.size(); ++k)
            if (are_at_one_place(all[i]->box, all[k]->box))
                joined.join(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(k));
    std::vector<Place> places;
    for (const std::vector<std::size_t>& group : joined.groups()) {
        Place& place = places.emplace_back();
        for (const std::size_t one : group) (one < own ? place.given : place.smoothed).push_back(all[one]);
    }
    return places;
}

// Bytes that were read.
std::size_t length_of(const std::vector<PrintedWords*>& words, bool only_sure) {
    std::size_t count = 0;
    for (const PrintedWords* one : words) count += one->sure || !only_sure ? one->text.size() : 0;
    return count;
}

std::string without_spaces(std::string text) {
    std::erase(text, ' ');
    return text;
}

bool has_figures(const std::string& text) {
    return std::any_of(text.begin(), text.end(), [](char c) { return is_digit(static_cast<unsigned char>(c)); });
}

// Each of the others was read as a part of these, or was not read; but a part of a number is another one.
bool bear_out(const std::vector<PrintedWords*>& others, const std::vector<PrintedWords*>& words) {
    if (words.size() == 1 && others.size() == 1 && has_figures(words.front()->text)) {
        const std::string& other = others.front()->text;
        return other.empty() || without_spaces(other) == without_spaces(words.front()->text);
    }
    std::string text;
    for (const PrintedWords* one : words) text += without_spaces(one->text) + '\n';
    return std::all_of(others.begin(), others.end(),
                       [&](const PrintedWords* other) { return text.find(without_spaces(other->text)) != text.npos; });
}

// Whether those of the given picture are taken.
bool takes_given(const Place& place) {
    if (place.given.empty() || place.smoothed.empty()) return place.smoothed.empty();
    const std::size_t given = length_of(place.given, true), smoothed = length_of(place.smoothed, true);
    const bool more = length_of(place.given, false) >= length_of(place.smoothed, false),
               surer = given == smoothed ? more : given > smoothed;
    const bool borne_out = surer ? bear_out(place.smoothed, place.given) : bear_out(place.given, place.smoothed);
    return borne_out ? surer : more;  // what cannot be sure is told as a whole
}

// Letters alone that were read alike twice in each reading, as surely as print in a font that is not installed has to be.
bool are_words_of_both(const PrintedWords& a, const PrintedWords& b) {
    constexpr double kSure = 93;  // a setting
    constexpr std::ptrdiff_t kLetters = 3;
    const auto count = std::count_if(a.text.begin(), a.text.end(), [](char c) { return (c | 32) >= 'a' && (c | 32) <= 'z'; });
    return a.text == b.text && std::min(a.sureness, b.sureness) >= kSure && count >= kLetters && !has_figures(a.text);
}

void take_words(const Place& place, std::vector<PrintedWords>& to) {
    const bool of_given = takes_given(place);
    const auto &words = of_given ? place.given : place.smoothed, &others = of_given ? place.smoothed : place.given;
    const bool denied = !bear_out(others, words);
    for (PrintedWords* one : words) {
        if (one->sure && (denied || (others.empty() && letters_in(one->text) < 2))) {
            one->sure = false;
            one->out = denied;  // it is print all the same, which both have found
        }
        if (words.size() == 1 && others.size() == 1 && are_words_of_both(*one, *others.front())) one->sure = one->print = true;
        to.push_back(std::move(*one));
    }
}

}  // namespace

Lettering put_together(Lettering given, Lettering smoothed) {
    std::vector<PrintedWords> words;
    for (const Place& place : places_of(given, smoothed)) take_words(place, words);
    given.words = std::move(words);
    sort_by_place(given.words);
    given.found_any = given.found_any || smoothed.found_any;
    return given;
}

}  // namespace tactics
