// SPDX-License-Identifier: Apache-2.0
#include "tactics/lettering/ink_letters.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <utility>

#include "tactics/lettering/strip.h"

namespace tactics {

namespace {

// Anything lighter is noise of the background. A setting.
constexpr double kFaint = 0.12;

// A point of a pixel and a half lies on two, each of which is less than dark: its box is larger than it is. Pixels of such a box
// at most, and the share of it that is ink at least. Settings.
constexpr double kSpeck = 3, kLeastSpeck = 0.35;

// The beginning of the ink, from the darkest pixel of each row or column: in one half as dark as the next, the ink fills half.
// Thin serifs are pale throughout.
template <typename Dark>
double edge(int from, int to, int step, Dark darkest) {
    for (int at = from; at != to; at += step) {
        const double own = darkest(at);
        if (own < kFaint) continue;
        const double next = at + step == to ? own : darkest(at + step);
        return std::abs(at - from) + 1 - own / std::max(own, next);
    }
    return 0;
}

}  // namespace

InkStrip::InkStrip(const Image& grey, const LetteringLine& line) {
    BareStrip strip = bare_strip(grey, line);
    width_ = strip.image.width;
    height_ = strip.image.height;
    dark_.resize(strip.image.pixels.size());
    for (std::size_t i = 0; i < dark_.size(); ++i) dark_[i] = static_cast<float>(255 - strip.image.pixels[i]) / 255;
    std::vector<std::size_t> order(strip.pieces.size()), unit_of(strip.pieces.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return strip.pieces[a].left < strip.pieces[b].left; });
    for (const std::size_t i : order) {
        const PixelBox& piece = strip.pieces[i];
        const auto joins = [&](const PixelBox& unit) {
            // Side by side, slanted letters reach over each other. Above each other, as a dot is, they may be slanted, too.
            const int down = std::min(unit.bottom, piece.bottom) - std::max(unit.top, piece.top);
            if (5 * down > std::min(unit.height(), piece.height())) return around(unit, piece) == unit;
            const double slant = 0.15 * (unit.height() + piece.height());
            const double both =
                std::min(unit.right + slant, piece.right + slant) - std::max<double>(unit.left, piece.left) - slant;
            const double near = std::min(both + slant, 1.0 * std::min(unit.width(), piece.width()));
            return 2 * both >= std::min(unit.width(), piece.width()) ||
                   (near > 0.9 * std::min(unit.width(), piece.width()) && both > 0);
        };
        const auto found = std::find_if(units_.rbegin(), units_.rend(), joins);
        unit_of[i] = found == units_.rend() ? units_.size() : static_cast<std::size_t>(units_.rend() - found) - 1;
        if (found == units_.rend())
            units_.push_back(piece);
        else
            *found = around(*found, piece);
    }
    owner_ = std::move(strip.owner);
    for (int& owner : owner_)
        if (owner >= 0) owner = static_cast<int>(unit_of[static_cast<std::size_t>(owner)]);
}

double InkStrip::dark(int x, int y, const Part& part) const {
    if (x < 0 || y < 0 || x >= width_ || y >= height_) return 0;
    const std::size_t at = static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
    return owner_[at] >= static_cast<int>(part.first) && owner_[at] <= static_cast<int>(part.last) ? double{dark_[at]} : 0.0;
}

InkBox InkStrip::measure(std::size_t first_unit, std::size_t last_unit) const {
    const Part part{first_unit, last_unit};
    PixelBox box = units_[first_unit];
    for (std::size_t i = first_unit + 1; i <= last_unit; ++i) box = around(box, units_[i]);
    constexpr int kFading = 2;  // pixels
    box = {std::max(0, box.left - kFading), std::max(0, box.top - kFading), std::min(width_, box.right + kFading),
           std::min(height_, box.bottom + kFading)};
    const auto row = [&](int y) {
        double most = 0;
        for (int x = box.left; x < box.right; ++x) most = std::max(most, dark(x, y, part));
        return most;
    };
    const auto column = [&](int x) {
        double most = 0;
        for (int y = box.top; y < box.bottom; ++y) most = std::max(most, dark(x, y, part));
        return most;
    };
    const int right = box.right - 1, bottom = box.bottom - 1;
    return {box.left + edge(box.left, right + 1, 1, column), box.top + edge(box.top, bottom + 1, 1, row),
            box.right - edge(right, box.left - 1, -1, column), box.bottom - edge(bottom, box.top - 1, -1, row)};
}

double InkStrip::likeness(std::size_t first, std::size_t last, const InkBox& box, const LetterForm& form) const {
    if (form.empty() || !(box.width() > 0) || !(box.height() > 0)) return 0;
    const int left = static_cast<int>(std::floor(box.left)) - 1, right = static_cast<int>(std::ceil(box.right)) + 1;
    const int top = static_cast<int>(std::floor(box.top)) - 1, bottom = static_cast<int>(std::ceil(box.bottom)) + 1;
    const int columns = right - left, rows = bottom - top;
    const auto at = [&](int x, int y) {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(x);
    };
    std::vector<double> apart(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows)), wants(apart.size());
    std::vector<double> above(static_cast<std::size_t>(columns) + 1), below(above.size());
    const double area = box.width() * box.height();
    const auto corners = [&](int y, std::vector<double>& sums) {
        for (int x = 0; x <= columns; ++x)
            sums[static_cast<std::size_t>(x)] =
                area * form.ink_before((left + x - box.left) / box.width(), (top + y - box.top) / box.height());
    };
    double all = 0, is_ink = 0;
    corners(0, above);
    for (int y = 0; y < rows; ++y) {
        corners(y + 1, below);
        for (int x = 0; x < columns; ++x) {
            const auto i = static_cast<std::size_t>(x);
            const double wanted = below[i + 1] - below[i] - above[i + 1] + above[i];
            const double is = dark(left + x, top + y, {first, last});
            all += wanted + is;
            is_ink += is;
            apart[at(x, y)] = is - wanted;
            wants[at(x, y)] = wanted;
        }
        above.swap(below);
    }
    if (!(all > 0)) return 0;
    if (box.width() <= kSpeck && box.height() <= kSpeck) {
        const double share = std::clamp(is_ink / (all - is_ink), kLeastSpeck, 1.0);
        for (std::size_t i = 0; i < apart.size(); ++i) apart[i] += (1 - share) * wants[i];
        all -= (1 - share) * (all - is_ink);
    }
    // Smoothed, for a stem that was moved by half a pixel is the same stem.
    double differs = 0;
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x) {
            double sum = 0;
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx)
                    if (y + dy >= 0 && y + dy < rows && x + dx >= 0 && x + dx < columns)
                        sum += (2 - std::abs(dx)) * (2 - std::abs(dy)) * apart[at(x + dx, y + dy)];
            differs += std::abs(sum) / 16;
        }
    return std::clamp(1 - 2 * differs / all, 0.0, 1.0);
}

}  // namespace tactics
