// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/figure_title.h"

#include <algorithm>
#include <cmath>

namespace tactics {

namespace {

// A4 upright has room for 30 cells between its margins, which is some 36 letters in contracted braille. Settings, as the others
// are.
constexpr std::size_t kOneLine = 36;
constexpr double kTop = 20, kMiddle = 25;  // percent: the title stands above that, and its middle not nearer to a side
constexpr double kNextLine = 2.6;          // heights of capitals from line to line
constexpr double kSameMiddle = 3;          // percent; lines of a title are centred

std::size_t letters_in(const std::string& text) {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

}  // namespace

std::string take_title(std::vector<ToldWords>& told, const std::vector<PrintPlace>& places, double first_ink) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < told.size(); ++i)
        if (!places[i].upwards && !places[i].elsewhere) order.push_back(i);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return told[a].y < told[b].y; });
    std::vector<std::size_t> lines;
    for (const std::size_t i : order) {
        const ToldWords& one = told[i];
        const bool begins = lines.empty() && one.y < kTop && one.x > kMiddle && one.x < 100 - kMiddle;
        const bool goes_on = !lines.empty() && std::abs(one.x - told[lines.front()].x) < kSameMiddle &&
                             one.y - told[lines.back()].y < kNextLine * std::max(places[i].height, places[lines.back()].height);
        if (!begins && !goes_on) break;
        if (!one.set) return "";  // not sure, or without braille: a person must look
        lines.push_back(i);
    }
    if (lines.empty()) return "";
    // What stands beside it belongs to a row of words, which is no title.
    for (const std::size_t i : order)
        if (std::find(lines.begin(), lines.end(), i) == lines.end() && told[i].y - told[lines.back()].y < places[i].height)
            return "";
    std::string title;
    for (const std::size_t i : lines) title += (title.empty() ? "" : " ") + told[i].text;
    const bool above = told[lines.back()].y + places[lines.back()].height / 2 <= first_ink;
    if (!above && lines.size() < 2 && letters_in(title) <= kOneLine) return "";  // in a box, say, which it names
    for (const std::size_t i : lines) told[i].title = true;
    return title;
}

}  // namespace tactics
