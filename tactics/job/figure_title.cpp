// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/figure_title.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>

#include "tactics/text/utf8.h"

namespace tactics {

namespace {

// Settings.
constexpr double kTop = 20, kMiddle = 25;  // percent: not farther below what is highest, and its middle not nearer to a side
constexpr double kNextLine = 2.6;          // heights of capitals from line to line
constexpr double kSameMiddle = 3;          // percent; lines of a centred title have one
constexpr double kAtLeft = 1.15;  // times as high as any other words: a title that begins at the left, as many tools set it

constexpr std::string_view kUnitSigns[] = {"%", "°", "€", "$", "£"};

// "Yield (t/ha)", as an axis is named, or a sign for money or shares.
bool names_unit(const std::string& text) {
    const std::size_t open = text.find_first_of("([");
    if (open != text.npos && text.find(' ', open) == text.npos && text.find_last_of(")]") == text.size() - 1) return true;
    return std::any_of(std::begin(kUnitSigns), std::end(kUnitSigns),
                       [&](std::string_view unit) { return text.find(unit) != text.npos; });
}

// What begins first is no more than a line, and below the middle of the words.
bool is_line_below(const FirstInk& first, double x) {
    constexpr double kLine = 4, kBelow = 5;  // settings, percent of the width
    return first.right - first.left <= kLine && std::abs((first.left + first.right) / 2 - x) <= kBelow;
}

// A name of something right below it is short and as high as other names; a title is larger, says more, or stands free.
bool may_be_title(const std::string& title, double height, double gap, bool led_to, const std::vector<double>& other_heights) {
    constexpr double kLarger = 1.1, kFree = 1.5;  // settings, relative to other words and to its own height
    std::vector<double> others = other_heights;
    const auto half = others.begin() + static_cast<std::ptrdiff_t>(others.size() / 2);
    if (!others.empty()) std::nth_element(others.begin(), half, others.end());
    const bool larger = !others.empty() && height >= kLarger * *half;
    std::size_t long_words = 0;
    for (std::size_t at = 0; at < title.size();) {
        const std::size_t end = std::min(title.find(' ', at), title.size());
        const std::string word = title.substr(at, end - at);
        const bool spelled_out = std::none_of(word.begin(), word.end(), [](char c) { return c >= '0' && c <= '9'; });
        long_words += letters_in(word) >= 3 && spelled_out ? 1 : 0;
        at = end + 1;
    }
    const bool phrase = long_words >= 2 && title.find('=') == title.npos;
    return letters_in(title) > 2 && (larger || phrase || (long_words > 0 && gap >= kFree * height && !led_to));
}

}  // namespace

std::string take_title(std::vector<ToldWords>& told, const std::vector<PrintPlace>& places, const FirstInk& first) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < told.size(); ++i)
        if (!places[i].upwards && !places[i].elsewhere) order.push_back(i);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return told[a].y < told[b].y; });
    double highest = first.top;
    for (const std::size_t i : order) highest = std::min(highest, told[i].y - places[i].height / 2);
    const auto stands_out = [&](std::size_t i) {
        for (std::size_t k = 0; k < places.size(); ++k)
            if (k != i && places[i].height < kAtLeft * places[k].height) return false;
        return !names_unit(told[i].text);
    };
    std::vector<std::size_t> lines;
    for (const std::size_t i : order) {
        const ToldWords& one = told[i];
        const bool in_middle = one.x > kMiddle && one.x < 100 - kMiddle;
        const bool at_left = one.x <= kMiddle && lines.empty() && stands_out(i);
        const bool begins = lines.empty() && one.y - highest < kTop && (in_middle || at_left);
        const bool goes_on = !lines.empty() && std::abs(one.x - told[lines.front()].x) < kSameMiddle &&
                             one.y - told[lines.back()].y < kNextLine * std::max(places[i].height, places[lines.back()].height);
        if (!begins && !goes_on) break;
        if (!one.set) return "";  // not sure, or without braille: a person must look
        lines.push_back(i);
    }
    if (lines.empty()) return "";
    // Words beside it make a row of words, which is no title.
    for (const std::size_t i : order)
        if (std::find(lines.begin(), lines.end(), i) == lines.end() && told[i].y - told[lines.back()].y < places[i].height)
            return "";
    std::string title;
    for (const std::size_t i : lines) title += (title.empty() ? "" : " ") + told[i].text;
    // Else it is in a box, say, which it names.
    if (told[lines.back()].y + places[lines.back()].height / 2 > first.top) return "";
    std::vector<double> others;
    for (std::size_t i = 0; i < told.size(); ++i)
        if (std::find(lines.begin(), lines.end(), i) == lines.end()) others.push_back(places[i].height);
    const std::size_t last = lines.back();
    const double gap = first.top - told[last].y - places[last].height / 2;
    if (!may_be_title(title, places[last].height, gap, is_line_below(first, told[last].x), others)) return "";
    for (const std::size_t i : lines) told[i].title = true;
    return title;
}

}  // namespace tactics
