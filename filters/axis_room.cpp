// SPDX-License-Identifier: Apache-2.0
#include "filters/axis_room.h"

#include <algorithm>
#include <cmath>

#include "tactics/error.h"

namespace tactics {

double height_of(const std::vector<std::string>& lines, const Sheet& sheet) {
    double height = 0;
    for (const std::string& line : lines) height += set_label(line, sheet).height + (height > 0 ? kChartLines : 0);
    return height;
}

LabelBlock widest_words(const Axis& axis, const AxisExtent& extent, const Sheet& sheet) {
    LabelBlock widest;
    for (int most = kFewestTicks; most <= kMostAxisTicks; ++most)
        for (const std::string& word : axis_ticks(axis, extent, most).words) {
            const LabelBlock words = set_label(word, sheet);
            widest.width = std::max(widest.width, words.width);
            widest.height = std::max(widest.height, words.height);
        }
    return widest;
}

namespace {

// The words of both ends as far apart as they must be: below the middle of their ticks, or outwards from there, equally if the
// drawing has room for that. False: there is no room.
bool move_apart(AxisScale& ends, const AxisRoom& room, const Sheet& sheet) {
    const double left = ends.at(ends.ticks()[0]), right = ends.at(ends.ticks()[1]), cell = sheet.cell.cell_pitch;
    const double first = set_label(ends.words()[0], sheet).width, last = set_label(ends.words()[1], sheet).width;
    double begin = std::max(left - first / 2, 0.0), end = std::min(right + last / 2, room.width);
    // A tick stays over its words.
    const double least = std::min(begin, std::max(left + cell - first, 0.0));
    const double most = std::max(end, std::min(right - cell + last, room.width));
    const auto lack = [&] { return begin + first + room.words + last - end; };
    if (lack() > 0) begin = std::max(begin - lack() / 2, least);
    if (lack() > 0) end = std::min(end + lack(), most);
    if (lack() > 0) begin = std::max(begin - lack(), least);
    if (lack() > 1e-9) return false;
    ends.move_words((left - begin) / first, (right - end + last) / last);
    return true;
}

}  // namespace

AxisScale scale_for(const Axis& axis, const AxisExtent& extent, const AxisRoom& room, const Sheet& sheet) {
    const auto needs = [&](const std::string& word) {
        const LabelBlock words = set_label(word, sheet);
        return room.upright ? words.height + kChartLines : words.width + room.words;
    };
    for (int most = kMostAxisTicks;; --most) {
        AxisScale scale(axis, extent, most, room.from, room.to);
        const std::vector<double>& ticks = scale.ticks();
        bool fits = true;
        for (std::size_t i = 1; i < ticks.size(); ++i)
            fits = fits && 2 * std::abs(scale.at(ticks[i]) - scale.at(ticks[i - 1])) >=
                               needs(scale.words()[i]) + needs(scale.words()[i - 1]);
        if (fits) return scale;
        if (most > kFewestTicks) continue;
        // Two ticks are left: the first and the last of as few as lie far enough apart.
        for (int more = kFewestTicks; more <= kMostAxisTicks; ++more) {
            AxisScale ends(axis, extent, more, room.from, room.to);
            ends.keep_ends();
            const double apart = std::abs(ends.at(ends.ticks()[1]) - ends.at(ends.ticks()[0])) - sheet.cell.cell_pitch;
            const double widths = set_label(ends.words()[0], sheet).width + set_label(ends.words()[1], sheet).width;
            if (room.upright || 2 * apart >= widths) return ends;
        }
        AxisScale ends(axis, axis_ends(axis, extent), room.from, room.to);
        if (move_apart(ends, room, sheet)) return ends;
        throw Error(
            Fault::usage, "",
            phrase("\"{0}\" and \"{1}\" have no room beside each other at an axis; take larger paper, or turn it to landscape",
                   scale.words().front(), scale.words().back()));
    }
}

}  // namespace tactics
