// SPDX-License-Identifier: Apache-2.0
#include "tactics/lettering/beyond_end.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "tactics/drawing.h"

namespace tactics {

namespace {

bool is_ink(const Image& grey, const LetteringLine& line, int x, int y) {
    return x >= 0 && y >= 0 && x < grey.width && y < grey.height && (grey.row(y)[x] < line.level) != line.light;
}

// What stands beyond one end of a line, row by row across it, from the end outwards.
class BeyondEnd {
public:
    BeyondEnd(const Image& grey, const LetteringLine& line, bool before) : grey_(grey), line_(line), before_(before) {}

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

private:
    static constexpr int kThick = 6;  // pixels

    struct Ink {
        int step, thick;  // pixels from the end; the latter kThick at most
    };
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
        return is_ink(grey_, line_, static_cast<int>(p.x), static_cast<int>(p.y));
    }
    bool is_out(int step) const {
        const Point p = at(0, step);
        return p.x < 0 || p.y < 0 || p.x >= grey_.width || p.y >= grey_.height;
    }

    const Image& grey_;
    const LetteringLine& line_;
    bool before_;
};

}  // namespace

bool is_cut(const Image& grey, const LetteringLine& line, double near) {
    return BeyondEnd(grey, line, true).is_cut(near) || BeyondEnd(grey, line, false).is_cut(near);
}

bool may_hide_sign(const Image& grey, const LetteringLine& line) {
    constexpr double kUpperPart = 0.5, kRoomOfSigns = 0.45;
    return BeyondEnd(grey, line, false).is_cut(kRoomOfSigns, kUpperPart);
}

}  // namespace tactics
