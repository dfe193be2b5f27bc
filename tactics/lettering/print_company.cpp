// SPDX-License-Identifier: Apache-2.0
#include "tactics/lettering/print_company.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace tactics {

bool has_room_around(const Image& grey, const LetteringLine& line) {
    const int room = std::max(2, line.letter_height / 6);
    // More than a speck of a noisy scan.
    constexpr int kMostSpeck = 12;  // pixels
    const auto speck = static_cast<std::size_t>(std::min(room * room, kMostSpeck));
    const auto goes_on = [&](int x, int y) {
        if (!is_ink(grey, line, x, y)) return false;
        std::vector<std::pair<int, int>> piece{{x, y}};
        for (std::size_t i = 0; i < piece.size() && piece.size() <= speck; ++i)
            for (int v = piece[i].second - 1; v <= piece[i].second + 1; ++v)
                for (int u = piece[i].first - 1; u <= piece[i].first + 1; ++u)
                    if (is_ink(grey, line, u, v) && std::find(piece.begin(), piece.end(), std::pair(u, v)) == piece.end())
                        piece.emplace_back(u, v);
        return piece.size() > speck;
    };
    for (int x = line.box.left - room; x < line.box.right + room; ++x)
        if (goes_on(x, line.box.top - room) || goes_on(x, line.box.bottom - 1 + room)) return false;
    for (int y = line.box.top - room; y < line.box.bottom + room; ++y)
        if (goes_on(line.box.left - room, y) || goes_on(line.box.right - 1 + room, y)) return false;
    return true;
}

// A scan is not quite level. By chance things in a plot stand in a row with some print; figures of an axis stand near others of
// it, or right beside one.
bool in_line_with_print(const LetteringLine& line, const KnownPrint& known) {
    constexpr double kNear = 0.3;                // of its size
    constexpr double kBeside = 4, kNotFar = 12;  // heights of letters
    const PixelBox& box = line.box;
    const int size = std::max(box.width(), box.height());
    int count = 0;
    constexpr double kWithinSight = 15, kClose = 0.4;  // heights of letters; of `near`
    constexpr std::size_t kFigures = 3;
    bool beside = false, not_far = false;
    for (const LetteringLine* other : known) {
        if (other == &line) continue;
        const PixelBox& b = other->box;
        const double height = other->letter_height;
        const double near = kNear * std::min<double>(size, kMostOfKnown * height);
        const bool row = std::abs(box.bottom - b.bottom) <= near;
        const bool column = std::abs(box.right - b.right) <= near || std::abs(box.left - b.left) <= near ||
                            std::abs(box.left + box.right - b.left - b.right) <= 2 * near;
        if (!row && !column) continue;
        ++count;
        const int gap = row ? std::max(box.left, b.left) - std::min(box.right, b.right)
                            : std::max(box.top, b.top) - std::min(box.bottom, b.bottom);
        // Close to the foot or middle of a figure of its height, it may stand farther off.
        const double off = row ? std::abs(box.bottom - b.bottom)
                               : 0.5 * std::min({std::abs(box.left + box.right - b.left - b.right),
                                                 2 * std::abs(box.left - b.left), 2 * std::abs(box.right - b.right)});
        const bool exact =
            other->letters.size() <= kFigures && off <= kClose * near && std::abs(line.letter_height - height) <= kClose * near;
        beside = beside || gap <= (exact ? kWithinSight : kBeside) * height;
        not_far = not_far || gap <= kNotFar * height;
    }
    return beside || (count > 1 && not_far);
}

// Figures of an axis, whether or not they are read: three in even steps along a row or column that need not be quite level, one
// of which is known print; or four of one height. Columns may end or begin at one place.
bool is_on_scale(std::size_t which, const std::vector<ReadLine>& lines) {
    constexpr double kOneHeight = 0.2, kKnownHeight = 0.4, kLevel = 0.05,
                     kOff = 0.3;  // of the height; of the step; of the height
    constexpr int kOfKnown = 3, kOfUnread = 4;
    const PixelBox& box = lines[which].line.box;
    const double height = lines[which].line.letter_height;
    const auto is_alike = [&](const ReadLine& one) {
        return std::abs(one.line.letter_height - height) <= (is_doubtful(one) ? kOneHeight : kKnownHeight) * height;
    };
    // From its box to another, which is some of these steps away.
    const auto is_at = [&](const PixelBox& b, double x, double y, bool row) {
        const auto off = [&](double moved) { return std::abs(moved) <= kOff * height; };
        const double left = b.left - box.left - x, right = b.right - box.right - x;
        return off(0.5 * (b.top + b.bottom - box.top - box.bottom) - y) &&
               (off(0.5 * (left + right)) || (!row && (off(left) || off(right))));
    };
    for (const ReadLine& next : lines) {
        const PixelBox& b = next.line.box;
        const double across = 0.5 * (b.left + b.right - box.left - box.right),
                     y = 0.5 * (b.top + b.bottom - box.top - box.bottom);
        const bool row = std::abs(across) > std::abs(y);
        const double edge = std::abs(b.left - box.left) < std::abs(b.right - box.right) ? b.left - box.left : b.right - box.right;
        const double x = row || std::abs(across) < std::abs(edge) ? across : edge, step = std::max(std::abs(x), std::abs(y));
        if (!is_alike(next) || step < 2 * height || std::min(std::abs(x), std::abs(y)) > kLevel * step) continue;
        int count = 1;
        bool known = false;
        for (const int side : {1, -1})
            for (int k = side;; k += side) {
                const auto found = std::find_if(lines.begin(), lines.end(), [&](const ReadLine& one) {
                    return is_alike(one) && is_at(one.line.box, k * x, k * y, row);
                });
                if (found == lines.end()) break;
                ++count;
                known = known || !is_doubtful(*found);
            }
        if (count >= (known ? kOfKnown : kOfUnread)) return true;
    }
    return false;
}

// They reach from one upright line to another, and are wider than high, as no mark is, but not as flat as dashes are.
bool is_climbing_figure(std::size_t which, const std::vector<ReadLine>& lines, const KnownPrint& known) {
    constexpr double kLow = 0.3, kFlat = 0.8, kOff = 0.1, kLevel = 0.01;  // of the width; of the way between them
    constexpr int kFigures = 3;
    const auto is_flat = [&](const ReadLine& one) {
        const PixelBox& box = one.line.box;
        return is_doubtful(one) && !is_words(one.line) && box.height() >= kLow * box.width() &&
               box.height() <= kFlat * box.width();
    };
    if (!is_flat(lines[which])) return false;
    const PixelBox& own = lines[which].line.box;
    int figures = 0;
    bool letter = false;
    for (const ReadLine& other : lines) {
        if (!is_flat(other)) continue;
        const PixelBox& box = other.line.box;
        const double off = std::max(1.0, kOff * own.width()) + kLevel * std::abs(box.top - own.top);
        if (std::abs(box.left - own.left) > off || std::abs(box.right - own.right) > off) continue;
        const MarkShape shape = mark_shape(other.line.letters.front());
        ++figures;
        letter = letter || (is_letter_like(shape) && (known.empty() || as_large_as_print(shape, known)));
    }
    return letter && figures >= kFigures;
}

}  // namespace tactics
