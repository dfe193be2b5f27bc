// SPDX-License-Identifier: Apache-2.0
#include "tactics/lettering/beyond_end.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "tactics/drawing.h"

namespace tactics {

namespace {

// What stands beyond one end of a line, row by row across it, from the end outwards.
class BeyondEnd {
public:
    // With the line's veil, or without it.
    BeyondEnd(const Image& grey, const LetteringLine& line, bool before, bool sees_veil)
        : grey_(grey), line_(line), before_(before), sees_veil_(sees_veil) {}

    // Something that is none of the line stands right there and is no straight line across, or sticks out of such a line, or
    // the picture ends: a letter that touches what is drawn, and is part of that now, or one that is cut off. `part` of the
    // line is looked at, from above.
    bool is_cut(double near, double part = 1) const {
        const int reach = std::max(4, static_cast<int>(std::ceil(near * line_.letter_height)));
        if (is_out(std::max(1, line_.letter_height / 8))) return true;
        int nearest = reach + 2, farthest = 0, thinnest = kThick, thickest = 0, first = across(), last = -1;
        for (int row = 0; row < part * across(); ++row) {
            const auto [step, thick] = first_ink(row, reach + 2);
            nearest = std::min(nearest, step);
            farthest = std::max(farthest, step);
            thinnest = std::min(thinnest, thick);
            thickest = std::max(thickest, thick);
            if (step > reach) continue;
            first = std::min(first, row);
            last = row;
        }
        if (nearest > reach || (part == 1 && (passes_corner(first, last, reach) || passes_straight()))) return false;
        return farthest > nearest + 1 || thickest > thinnest + 1;
    }

    // A letter that touches a straight line which passes: it sticks out of that, and reaches as far up and down as some letter
    // here.
    bool hides_letter() const {
        const int most = 3 * line_.letter_height;
        const auto line = line_past(most);
        if (!line) return false;
        int first = across(), last = -1;
        Out nearest{0, most};
        for (int row = -1; row <= across(); ++row) {
            const int step = first_ink(row, most).step;
            if (step > line->at(row) - kOut) continue;
            first = std::min(first, row);
            last = row;
            if (step < nearest.step) nearest = {row, step};
        }
        const auto is_as_high = [&](const InkPiece& one) {
            const int top = line_.upwards ? one.box.left - line_.box.left : one.box.top - line_.box.top;
            const int foot = line_.upwards ? one.box.right - line_.box.left : one.box.bottom - line_.box.top;
            return std::abs(top - first) <= 1 && std::abs(foot - 1 - last) <= 1;
        };
        return nearest.step <= line_.letter_height && !is_shaft(nearest, most) &&
               std::any_of(line_.letters.begin(), line_.letters.end(), is_as_high) && leads_to(nearest, *line, most);
    }

private:
    static constexpr int kThick = 6;  // pixels

    struct Ink {
        int step, thick;  // pixels from the end; the latter kThick at most
    };
    // Where a straight line is that passes, row by row.
    struct Straight {
        double step, slope;
        double at(int row) const { return step + slope * row; }
    };
    struct Out {
        int row, step;
    };
    static constexpr int kPast = 3, kOut = 2;  // pixels: above and below the letters; out of the line

    // As it is above the letters, it is below them.
    std::optional<Straight> line_past(int most) const {
        constexpr int kRows = 4;
        const auto seen = [&](int row) { return first_ink(row, most).step; };
        const int end = across() - 1 + kPast, above = seen(-kPast), below = seen(end);
        if (above >= most || below >= most) return std::nullopt;
        const double slope = static_cast<double>(below - above) / (end + kPast);
        const Straight line{above + slope * kPast, slope};
        for (int row = kPast; row < kPast + kRows; ++row)
            if (std::abs(seen(-row) - line.at(-row)) > 1 || std::abs(seen(end - kPast + row) - line.at(end - kPast + row)) > 1)
                return std::nullopt;
        return line;
    }

    // Of an arrow: at half the height something sticks out of what is behind it.
    bool is_shaft(const Out& nearest, int most) const {
        constexpr double kShaft = 0.35, kOffMiddle = 0.2;  // of the height
        for (int row = -1; row <= across(); ++row)
            if (first_ink(row, most).step <= nearest.step + kShaft * line_.letter_height &&
                std::abs(row - 0.5 * (across() - 1)) > std::max(1.5, kOffMiddle * across()))
                return false;
        return true;
    }

    // Its ink goes on to that line.
    bool leads_to(const Out& from, const Straight& line, int most) const {
        std::set<std::pair<int, int>> seen{{from.row, from.step}};
        std::vector<std::pair<int, int>> open(seen.begin(), seen.end());
        while (!open.empty()) {
            const auto [row, step] = open.back();
            open.pop_back();
            if (step >= line.at(row)) return true;
            for (int r = std::max(-1, row - 1); r <= std::min(across(), row + 1); ++r)
                for (int s = std::max(1, step - 1); s <= std::min(most, step + 1); ++s)
                    if (has_ink(r, s) && seen.insert({r, s}).second) open.emplace_back(r, s);
        }
        return false;
    }

    // `most`: no farther off than that.
    Ink first_ink(int row, int most) const {
        int step = 1;
        while (step < most && !has_ink(row, step)) ++step;
        int end = step;
        while (end < step + kThick && has_ink(row, end)) ++end;
        return {step, end - step};
    }

    // Of a line that leads to it, such as the tick of a pie, the end may be level with the top or the foot of its letters.
    bool passes_corner(int first, int last, int reach) const {
        constexpr double kCorner = 0.2;  // of the height
        const auto goes_on = [&](int row) {
            for (int step = 1; step <= reach + 1; ++step)
                if (has_ink(row, step)) return true;
            return false;
        };
        return (last < kCorner * across() && goes_on(-1)) || (first >= (1 - kCorner) * across() && goes_on(across()));
    }

    // A line at any slope, such as an arrow beside its label, that goes on above and below and touches no letter behind it. A
    // letter by itself may be the last of a word that is hidden.
    bool passes_straight() const {
        constexpr int kBeyond = 2;  // pixels
        if (line_.letters.size() < 2) return false;
        std::vector<int> steps;
        int thinnest = kThick, thickest = 0;
        for (int row = -kBeyond; row < across() + kBeyond; ++row) {
            const auto [step, thick] = first_ink(row, 2 * across() + 1);
            if (step > 2 * across()) return false;
            thinnest = std::min(thinnest, thick);
            thickest = std::max(thickest, thick);
            steps.push_back(step);
        }
        const double slope = (steps.back() - steps.front()) / static_cast<double>(steps.size() - 1);
        for (std::size_t i = 0; i < steps.size(); ++i)
            if (std::abs(steps[i] - steps.front() - slope * static_cast<double>(i)) > 1) return false;
        return thickest <= thinnest + 1;
    }

    int along() const { return line_.upwards ? line_.box.height() : line_.box.width(); }
    int across() const { return line_.upwards ? line_.box.width() : line_.box.height(); }
    Point at(int row, int step) const {
        const int beyond = before_ ? -step : along() - 1 + step;
        return line_.upwards ? Point{1.0 * line_.box.left + row, line_.box.bottom - 1.0 - beyond}
                             : Point{1.0 * line_.box.left + beyond, 1.0 * line_.box.top + row};
    }
    bool has_ink(int row, int step) const {
        const Point p = at(row, step);
        const int x = static_cast<int>(p.x), y = static_cast<int>(p.y);
        return is_ink(grey_, line_, x, y) && (sees_veil_ || !is_veiled(line_, x, y));
    }
    bool is_out(int step) const {
        const Point p = at(0, step);
        return p.x < 0 || p.y < 0 || p.x >= grey_.width || p.y >= grey_.height;
    }

    const Image& grey_;
    const LetteringLine& line_;
    bool before_;
    bool sees_veil_;
};

// Alike, and side by side, as the dots of a line are.
bool is_dashed_line(const std::vector<InkPiece>& pieces) {
    constexpr std::size_t kDashes = 3;
    const PixelBox& first = pieces.front().box;
    return pieces.size() >= kDashes && std::all_of(pieces.begin(), pieces.end(), [&](const InkPiece& piece) {
               return std::abs(piece.box.top - first.top) <= 1 && std::abs(piece.box.bottom - first.bottom) <= 1 &&
                      std::abs(piece.box.width() - first.width()) <= 1;
           });
}

// How much paler than a line's ink something may be that is no ground. Print on a coloured ground is not much darker than that.
int paler_ink(const Image& grey, const PixelBox& box, int level, bool light) {
    constexpr int kPaler = 40;  // grey levels; a setting
    std::array<int, 256> count{};
    int all = 0;
    for (int y = box.top; y < box.bottom; ++y)
        for (int x = box.left; x < box.right; ++x)
            if (const int value = grey.row(y)[x]; (value < level) == light) ++count[static_cast<std::size_t>(value)], ++all;
    int middle = 0;
    for (int seen = count[0]; 2 * seen < all; seen += count[static_cast<std::size_t>(middle)]) ++middle;
    return std::min(kPaler, std::abs(middle - level) / 2);
}

}  // namespace

bool is_cut(const Image& grey, const LetteringLine& line, double near) {
    const auto is_at = [&](bool before) {
        return BeyondEnd(grey, line, before, false).is_cut(near) || BeyondEnd(grey, line, before, true).hides_letter();
    };
    return is_at(true) || is_at(false);
}

bool may_hide_sign(const Image& grey, const LetteringLine& line) {
    constexpr double kUpperPart = 0.5, kRoomOfSigns = 0.45;
    return BeyondEnd(grey, line, false, false).is_cut(kRoomOfSigns, kUpperPart);
}

bool has_strange_ink(const Image& grey, const LetteringLine& line) {
    const int below = std::max(3, line.letter_height / 2);
    PixelBox box = line.box;
    (line.upwards ? box.right : box.bottom) += below;
    box.right = std::min(box.right, grey.width);
    box.bottom = std::min(box.bottom, grey.height);
    const int paler = paler_ink(grey, box, line.level, line.light);
    const int level = line.light ? line.level - paler : line.level + paler;
    Image part = make_image(box.width(), box.height(), 1, 0, 255);
    for (int y = box.top; y < box.bottom; ++y)
        for (int x = box.left; x < box.right; ++x)
            if ((grey.row(y)[x] < level) != line.light) part.row(y - box.top)[x - box.left] = 0;
    const auto clear = [&](const std::vector<InkRun>& runs) {
        for (const InkRun& run : runs) {
            const int left = std::max(box.left, run.left - 1), right = std::min(box.right, run.right + 1);
            for (int y = std::max(box.top, run.y - 1); y <= std::min(box.bottom - 1, run.y + 1) && left < right; ++y)
                std::fill(part.row(y - box.top) + (left - box.left), part.row(y - box.top) + (right - box.left),
                          std::uint8_t{255});
        }
    };
    for (const auto* pieces : {&line.letters, &line.marks, &line.raised})
        for (const InkPiece& piece : *pieces) clear(piece.runs);
    clear(line.veil);
    std::vector<InkPiece> strange = pieces_of(part, 128, false, kMostInkHeight);
    // The bar of an e that lies across two rows of pixels is paler than the rest of it.
    const auto is_within_letter = [&](const PixelBox& own) {
        const PixelBox there{own.left + box.left, own.top + box.top, own.right + box.left, own.bottom + box.top};
        return std::any_of(line.letters.begin(), line.letters.end(),
                           [&](const InkPiece& letter) { return around(letter.box, there) == letter.box; });
    };
    std::erase_if(strange, [&](const InkPiece& piece) {
        return !ends_within(piece, part) || piece.box.width() + piece.box.height() <= 2 || is_within_letter(piece.box);
    });
    return !strange.empty() && !is_dashed_line(strange);
}

}  // namespace tactics
