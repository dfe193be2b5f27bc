// SPDX-License-Identifier: Apache-2.0
#include "tactics/information/likeness.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "tactics/error.h"
#include "tactics/information/entropy.h"

namespace tactics {

namespace {

constexpr int kBoxSide = 44;   // of the box, which leaves room to move and for lines that are near from outside
constexpr int kLeastBox = 16;  // of a box that is compared: of a straight line it has what is beside it, too
constexpr int kLevels = kNearest + 1;
constexpr std::size_t kCells = static_cast<std::size_t>(kLookSide) * kLookSide;

using Square = std::array<int, kCells>;

struct Box {
    int left = 0, top = 0, right = -1, bottom = -1;  // cells, inclusive
};

Box box_of(const LevelGrid& drawn) {
    Box box{drawn.columns, drawn.rows, -1, -1};
    for (int y = 0; y < drawn.rows; ++y)
        for (int x = 0; x < drawn.columns; ++x) {
            if (drawn.values[static_cast<std::size_t>(y) * drawn.columns + x] == 0) continue;
            box = {std::min(box.left, x), std::min(box.top, y), std::max(box.right, x), std::max(box.bottom, y)};
        }
    return box;
}

// Squared distances along one row or column of places: `step` apart, with what is known so far (Meijster et al. 2000 do it in one
// pass; a square this small needs no more than this).
void spread(Square& far, std::size_t first, std::size_t step) {
    std::array<int, kLookSide> line{};
    for (int i = 0; i < kLookSide; ++i) {
        int least = far[first + i * step];
        for (int j = 0; j < kLookSide; ++j) least = std::min(least, far[first + j * step] + (i - j) * (i - j));
        line[i] = least;
    }
    for (int i = 0; i < kLookSide; ++i) far[first + i * step] = line[i];
}

std::uint8_t nearness_of(int squared) {
    constexpr std::array<int, 4> reach{1, 2, 4, 7};
    if (squared == 0) return kNearest;
    for (std::size_t i = 0; i < reach.size(); ++i)
        if (squared <= reach[i] * reach[i]) return static_cast<std::uint8_t>(kNearest - 1 - i);
    return 0;
}

// The cell of the second that comes to each cell of the first.
class Mover {
public:
    Mover(const Alignment& alignment, int right, int down) : alignment_(alignment), right_(right), down_(down) {
        for (int turn = 0; turn < alignment.quarter_turns; ++turn) std::swap(cos_, sin_), sin_ = -sin_;
    }

    // kCells: outside.
    std::size_t from(int column, int row) const {
        constexpr double middle = (kLookSide - 1) / 2.0;
        const double x = (column - right_ - middle) / alignment_.scale, y = (row - down_ - middle) / alignment_.scale;
        double across = cos_ * x - sin_ * y;
        const double down = sin_ * x + cos_ * y;
        if (alignment_.mirrored) across = -across;
        const auto at_x = std::lround(across + middle), at_y = std::lround(down + middle);
        if (at_x < 0 || at_y < 0 || at_x >= kLookSide || at_y >= kLookSide) return kCells;
        return static_cast<std::size_t>(at_y) * kLookSide + static_cast<std::size_t>(at_x);
    }

private:
    Alignment alignment_;
    int right_, down_;
    int cos_ = 1, sin_ = 0;
};

class Comparison {
public:
    // Over the box of the first only: that around both there is nothing tells nothing.
    Comparison(const Look& first, const Look& second)
        : first_(first),
          second_(second),
          wide_(std::max(first.wide, kLeastBox)),
          high_(std::max(first.high, kLeastBox)),
          left_((kLookSide - wide_) / 2),
          top_((kLookSide - high_) / 2),
          own_(mutual_of(first, {}, 0, 0, 1)) {}

    // Every `step` cells each way, bits a cell.
    double mutual(const Alignment& alignment, int right, int down, int step) const {
        return mutual_of(second_, alignment, right, down, step);
    }

    double own() const { return own_; }

private:
    double mutual_of(const Look& other, const Alignment& alignment, int right, int down, int step) const {
        std::array<std::uint64_t, kLevels> mine{}, theirs{};
        std::array<std::uint64_t, static_cast<std::size_t>(kLevels) * kLevels> both{};
        const Mover mover(alignment, right, down);
        for (int row = top_; row < top_ + high_; row += step)
            for (int column = left_; column < left_ + wide_; column += step) {
                const std::size_t from = mover.from(column, row);
                const std::uint8_t here = first_.nearness[static_cast<std::size_t>(row) * kLookSide + column];
                const std::uint8_t there = from == kCells ? std::uint8_t{0} : other.nearness[from];
                ++mine[here];
                ++theirs[there];
                ++both[static_cast<std::size_t>(here) * kLevels + there];
            }
        return std::max(0.0, entropy_of(mine).corrected + entropy_of(theirs).corrected - entropy_of(both).corrected);
    }

    const Look& first_;
    const Look& second_;
    int wide_, high_, left_, top_;
    double own_;  // I of the first and itself, which is its H
};

struct Found {
    double mutual = -1;
    Alignment alignment;
    int right = 0, down = 0;
};

// Coarsely everywhere, then finely where it was best.
Found best_of(const Comparison& comparison, const Alignment& turned) {
    constexpr std::array<double, 5> scales{1, 0.9, 1.1, 0.8, 1.25};
    constexpr int most = kLookSide / 8, coarse = 2;
    Found best;
    const auto attempt = [&](const Alignment& alignment, int right, int down, int step) {
        if (const double mutual = comparison.mutual(alignment, right, down, step); mutual > best.mutual)
            best = {mutual, alignment, right, down};
    };
    for (const double scale : scales)
        for (int down = -most; down <= most; down += 2 * coarse)
            for (int right = -most; right <= most; right += 2 * coarse)
                attempt({turned.quarter_turns, turned.mirrored, scale}, right, down, coarse);
    const Found rough = best;
    best.mutual = -1;  // of a quarter of the cells
    for (const double finer : {1.0, 0.95, 1.05})
        for (int down = -coarse; down <= coarse; ++down)
            for (int right = -coarse; right <= coarse; ++right)
                attempt({turned.quarter_turns, turned.mirrored, rough.alignment.scale * finer}, rough.right + right,
                        rough.down + down, 1);
    return best;
}

}  // namespace

Look look_of(const LevelGrid& drawn, std::string_view name) {
    const Box box = box_of(drawn);
    if (box.right < box.left) throw Error(Fault::failed, name, phrase("nothing is drawn of it that could be compared"));
    const int wide = box.right - box.left + 1, high = box.bottom - box.top + 1;
    const double scale = static_cast<double>(kBoxSide) / std::max(wide, high);
    const double left = (kLookSide - wide * scale) / 2, top = (kLookSide - high * scale) / 2;
    constexpr int far_away = 4 * kLookSide * kLookSide;
    Square far;
    far.fill(far_away);
    for (int y = box.top; y <= box.bottom; ++y)
        for (int x = box.left; x <= box.right; ++x) {
            if (drawn.values[static_cast<std::size_t>(y) * drawn.columns + x] == 0) continue;
            const auto column = static_cast<std::size_t>(left + (x - box.left + 0.5) * scale);
            const auto row = static_cast<std::size_t>(top + (y - box.top + 0.5) * scale);
            far[row * kLookSide + column] = 0;
        }
    for (std::size_t row = 0; row < kLookSide; ++row) spread(far, row * kLookSide, 1);
    for (std::size_t column = 0; column < kLookSide; ++column) spread(far, column, kLookSide);
    Look look;
    look.wide = std::clamp(static_cast<int>(std::lround(wide * scale)), 1, kBoxSide);
    look.high = std::clamp(static_cast<int>(std::lround(high * scale)), 1, kBoxSide);
    look.nearness.reserve(kCells);
    for (const int squared : far) look.nearness.push_back(nearness_of(squared));
    return look;
}

Likeness likeness(const Look& first, const Look& second, bool any_way_up) {
    const Comparison comparison(first, second);
    Found best;
    for (int way = 0; way < (any_way_up ? 8 : 1); ++way)
        if (Found found = best_of(comparison, {way % 4, way >= 4, 1}); found.mutual > best.mutual) best = found;
    return {comparison.own() > 0 ? std::min(1.0, best.mutual / comparison.own()) : 0, best.mutual, best.alignment};
}

}  // namespace tactics
