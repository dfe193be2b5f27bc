// SPDX-License-Identifier: Apache-2.0
#include "tactics/layout/scale_bar.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "tactics/error.h"
#include "tactics/layout/label.h"
#include "tactics/layout/sheet.h"

namespace tactics {

namespace {

// Two fingers span it, and it leaves the drawing most of the width. Own choice.
constexpr double kLongest = 60;  // mm
// A line on its own is felt as one from 1/2 in on (rules/line_length.cpp).
constexpr double kShortest = 12.7;  // mm
// Lines closer than 6 mm are hard to tell apart (BRI, APH guide); as of the title.
constexpr double kClearOfBar = 6;  // mm

// Longer than a cell is high, or in dots the bar would be read as braille; on an embosser's rows of dots, which stand up to 5 mm
// apart, still above and below the bar. Own choice.
double tick_of(const Sheet& sheet) {
    return sheet.cell.line_pitch + (has_fixed_dots(*sheet.medium) ? 2 * sheet.cell.dot_pitch : 0);
}

// The braille, or the print where there is none, is level with the bar: a finger that leaves the bar at its end finds it.
struct BarLevel {
    double above = 0, below = 0;  // mm of bar and words
    double down = 0;              // where the bar is in the words: 0 at their top, 1 at the bottom
};
BarLevel level_of(const LabelBlock& words, const Sheet& sheet) {
    const double last = words.braille.empty() ? words.height : words.height - words.braille[0].first_dot.y + sheet.cell.dot / 2;
    const double middle = words.height - last / 2, tick = tick_of(sheet) / 2;
    return {std::max(middle, tick), std::max(last / 2, tick), middle / words.height};
}

}  // namespace

Phrase real_length(double mm) {
    struct Unit {
        SourceWords words;
        double mm;
    };
    static constexpr std::array<Unit, 4> kUnits{
        {{SourceWords("{0} km"), 1e6}, {SourceWords("{0} m"), 1e3}, {SourceWords("{0} cm"), 10}, {SourceWords("{0} mm"), 1}}};
    const double step = mm > 0 ? std::pow(10, std::floor(std::log10(mm)) - 2) : 1;
    const double rounded = std::round(mm / step) * step;
    const auto unit = std::find_if(kUnits.begin(), kUnits.end() - 1, [&](const Unit& u) { return rounded >= u.mm * (1 - 1e-9); });
    return phrase(unit->words, numeral(rounded / unit->mm));
}

double scale_bar_height(const Sheet& sheet) {
    const BarLevel level = level_of(set_label("1 m", sheet), sheet);
    return level.above + level.below + std::max(kClearOfBar, sheet.medium->gap) +
           sheet.medium->thick_line / 2;  // half of the widest line stands out of the drawing
}

void set_scale_bar(Page& page, const Rect& room, double scale, const Sheet& sheet) {
    const double line = sheet.medium->line, tick = tick_of(sheet);
    const double before = line + kClearOfBar;  // of the words, besides the bar
    // From the longest round length down.
    for (int step = static_cast<int>(std::ceil(std::log10(kLongest / scale))) * 3 + 2;; --step) {
        constexpr std::array<double, 3> kRound{1, 2, 5};
        const int power = step >= 0 ? step / 3 : -((2 - step) / 3);
        const double real = kRound[static_cast<std::size_t>(step - 3 * power)] * std::pow(10, power), length = real * scale;
        if (length > kLongest + 1e-9) continue;
        if (length < kShortest)
            throw Error(Fault::usage, spelled("real-width"),
                        phrase("there is no room for the scale bar and its words; take larger paper, or smaller margins"));
        const std::string text = real_length(real).in(sheet.language);
        LabelBlock words = set_label(text, sheet);
        if (length + before + words.width > room.width) continue;
        const BarLevel level = level_of(words, sheet);
        const double middle = room.top + room.height - level.below;
        const double left = room.left + line / 2, right = left + length;
        page.scale = PageScale{
            text, length, real, {room.left, middle - level.above, length + before + words.width, level.above + level.below}};
        const auto draw = [&](Point from, Point to) { page.strokes.push_back({{from, to}, false, line, Role::scale}); };
        draw({left, middle}, {right, middle});
        for (const double x : {left, right}) draw({x, middle - tick / 2 + line / 2}, {x, middle + tick / 2 - line / 2});
        words = placed(std::move(words), Label{{}, 0, level.down, text}, {right + line / 2 + kClearOfBar, middle}, page.cell,
                       page.width, page.height);
        say(words, page, {WordsKind::scale, text});
        std::move(words.print.begin(), words.print.end(), std::back_inserter(page.print));
        std::move(words.braille.begin(), words.braille.end(), std::back_inserter(page.braille));
        return;
    }
}

}  // namespace tactics
