// SPDX-License-Identifier: Apache-2.0
#include "tactics/lettering/tick_ends.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <initializer_list>
#include <optional>

namespace tactics {

namespace {

PixelBox around_all(std::initializer_list<const std::vector<InkPiece>*> kinds, PixelBox box) {
    for (const auto* pieces : kinds)
        for (const InkPiece& piece : *pieces) box = around(box, piece.box);
    return box;
}

// The number of the mark that may be a tick. Longer lines may be text that is broken at a hyphen, which stands closer.
std::optional<std::size_t> last_stroke(const LetteringLine& line) {
    constexpr std::size_t kFewLetters = 6;                                       // "100000"
    constexpr double kApart = 0.25;                                              // of the height of letters
    constexpr double kLong = 1.5, kThin = 0.3, kHighest = 0.25, kLowest = 0.75;  // of its thickness; of the height of letters
    if (line.upwards || line.marks.empty()) return std::nullopt;
    const auto last = std::max_element(line.marks.begin(), line.marks.end(),
                                       [](const InkPiece& a, const InkPiece& b) { return a.box.right < b.box.right; });
    const PixelBox letters = around_all({&line.letters, &line.raised}, line.letters.front().box);
    const PixelBox& box = last->box;
    const double middle = (box.top + box.bottom) / 2.0 - letters.top;
    const double apart = line.letters.size() > kFewLetters ? kApart * letters.height() : 0;
    if (box.left < letters.right + apart || box.width() < kLong * box.height() || box.height() > kThin * letters.height() ||
        middle < kHighest * letters.height() || middle > kLowest * letters.height())
        return std::nullopt;
    return static_cast<std::size_t>(last - line.marks.begin());
}

}  // namespace

void drop_tick_ends(std::vector<LetteringLine>& lines) {
    struct Tick {
        std::size_t line, mark;
        PixelBox box;
    };
    std::vector<Tick> ticks;
    for (std::size_t i = 0; i < lines.size(); ++i)
        if (const auto mark = last_stroke(lines[i])) ticks.push_back({i, *mark, lines[i].marks[*mark].box});
    for (const Tick& one : ticks) {
        const bool several = std::any_of(ticks.begin(), ticks.end(), [&](const Tick& other) {
            return other.line != one.line && std::abs(other.box.left - one.box.left) <= 1 &&
                   std::abs(other.box.right - one.box.right) <= 1;
        });
        if (!several) continue;
        LetteringLine& line = lines[one.line];
        line.marks.erase(line.marks.begin() + static_cast<std::ptrdiff_t>(one.mark));
        line.box = around_all({&line.letters, &line.marks, &line.raised}, line.letters.front().box);
    }
}

}  // namespace tactics
