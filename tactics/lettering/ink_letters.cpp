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

// A point or a dash of a pixel and a half lies on two, each of which is less than dark: its box is larger than it is. Height of
// such a box in pixels at most, and the share of it that is ink at least. Settings.
constexpr double kSpeck = 3, kLeastSpeck = 0.35;

constexpr double kBar = 3;  // times as long as wide at least

// Each pixel is smoothed over itself and its neighbours, in both directions by 1, 2 and 1 of 4; at the border one is missing.
constexpr int kSmoothed = 4;
int smoothed_share(int place, int count) { return kSmoothed - (place == 0 ? 1 : 0) - (place == count - 1 ? 1 : 0); }

constexpr double kRounding = 1e-12;  // of all ink

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

// From where to where there is ink.
using Extent = std::pair<double, double>;
template <typename Dark>
Extent extent(int from, int to, Dark darkest) {
    return {from + edge(from, to, 1, darkest), to - edge(to - 1, from - 1, -1, darkest)};
}

// A stem or a dash of a pixel and a bit that lies on two fills neither.
template <typename Dark>
Extent of_bar(const Extent& measured, Dark darkest) {
    const int middle = static_cast<int>(std::floor(measured.first)) + 1;
    if (measured.second <= middle || measured.second > middle + 1) return measured;
    return {middle - darkest(middle - 1), middle + darkest(middle)};
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
    veil_ = std::move(strip.veiled);
    tie_units();
    if (!veil_.empty()) veil_units();
}

void InkStrip::veil_units() {
    veiled_.resize(units_.size());
    for (std::size_t at = 0; at < owner_.size(); ++at)
        if (owner_[at] >= 0 && veil_[at]) {
            veiled_[static_cast<std::size_t>(owner_[at])] = true;
            owner_[at] = -1;
        }
    constexpr int kBreak = 4;  // pixels that a stroke across a letter is wide at most, with its edges
    for (std::size_t i = 0; i + 1 < units_.size(); ++i)
        if (veiled_[i] && veiled_[i + 1] && units_[i + 1].left - units_[i].right <= kBreak) tied_[i] = true;
}

bool InkStrip::veiled(std::size_t first, std::size_t last) const {
    return !veiled_.empty() && std::any_of(veiled_.begin() + static_cast<std::ptrdiff_t>(first),
                                           veiled_.begin() + static_cast<std::ptrdiff_t>(last) + 1, [](bool one) { return one; });
}

void InkStrip::tie_units() {
    constexpr float kTies = 0.2F;  // ink of a stroke of .4 pixels that lies on two. A setting
    tied_.resize(units_.size());
    const auto tie = [&](std::size_t a, std::size_t b) {
        const int one = owner_[a], other = owner_[b];
        if (one >= 0 && other >= 0 && std::abs(one - other) == 1 && std::min(dark_[a], dark_[b]) >= kTies)
            tied_[static_cast<std::size_t>(std::min(one, other))] = true;
    };
    const auto width = static_cast<std::size_t>(width_);
    for (std::size_t at = 0; at < owner_.size(); ++at) {
        if (owner_[at] < 0) continue;
        const bool right = at % width + 1 < width, below = at + width < owner_.size();
        if (right) tie(at, at + 1);
        if (below) tie(at, at + width);
        if (below && right) {
            tie(at, at + width + 1);
            tie(at + 1, at + width);
        }
    }
}

bool InkStrip::is_stroke() const {
    constexpr double kLong = 3, kFilled = 0.75;  // times as long as wide; of a bar with its moments
    double all = 0, x = 0, y = 0, xx = 0, yy = 0, xy = 0;
    for (int row = 0; row < height_; ++row)
        for (int column = 0; column < width_; ++column) {
            const double ink =
                dark_[static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(column)];
            all += ink, x += ink * column, y += ink * row;
            xx += ink * column * column, yy += ink * row * row, xy += ink * column * row;
        }
    if (!(all > 0)) return false;
    constexpr double kPixel = 1.0 / 12;  // what each has by itself
    const double a = xx / all - x * x / (all * all) + kPixel, b = yy / all - y * y / (all * all) + kPixel,
                 c = xy / all - x * y / (all * all), middle = (a + b) / 2, spread = std::hypot((a - b) / 2, c);
    const double narrow = std::max(kPixel / 4, middle - spread), wide = middle + spread;
    return wide >= kLong * kLong * narrow && all >= kFilled * 12 * std::sqrt(wide * narrow);
}

bool InkStrip::tied(std::size_t first, std::size_t last) const {
    return std::all_of(tied_.begin() + static_cast<std::ptrdiff_t>(first), tied_.begin() + static_cast<std::ptrdiff_t>(last),
                       [](bool one) { return one; });
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
    Extent across = extent(box.left, box.right, column), down = extent(box.top, box.bottom, row);
    const double width = across.second - across.first, height = down.second - down.first;
    if (height >= kBar * width) across = of_bar(across, column);
    if (width >= kBar * height) down = of_bar(down, row);
    return {across.first, down.first, across.second, down.second};
}

LetterInk::LetterInk(const InkStrip& strip, std::size_t first, std::size_t last, const InkBox& box)
    : box_(box),
      left_(static_cast<int>(std::floor(box.left)) - 1),
      top_(static_cast<int>(std::floor(box.top)) - 1),
      columns_(static_cast<int>(std::ceil(box.right)) + 1 - left_),
      rows_(static_cast<int>(std::ceil(box.bottom)) + 1 - top_),
      area_(box.width() * box.height()) {
    if (!(box.width() > 0) || !(box.height() > 0)) return;
    is_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
    in_rows_.resize(static_cast<std::size_t>(rows_));
    in_columns_.resize(static_cast<std::size_t>(columns_));
    for (int y = 0; y < rows_; ++y)
        for (int x = 0; x < columns_; ++x) {
            if (strip.is_veiled(left_ + x, top_ + y)) {
                hidden_.resize(is_.size());
                hidden_[at(x, y)] = true;
                continue;
            }
            const double is = is_[at(x, y)] = strip.dark(left_ + x, top_ + y, {first, last});
            all_ink_ += is;
            in_rows_[static_cast<std::size_t>(y)] += is * smoothed_share(x, columns_);
            in_columns_[static_cast<std::size_t>(x)] += is * smoothed_share(y, rows_);
        }
    wants_.resize(is_.size());
    apart_.resize(static_cast<std::size_t>(columns_ + 2) * static_cast<std::size_t>(rows_ + 2));
    above_.resize(static_cast<std::size_t>(columns_) + 1);
    below_.resize(above_.size());
    across_.resize(above_.size());
}

double LetterInk::likeness(const LetterForm& form, double least) {
    if (form.empty() || is_.empty()) return 0;
    for (std::size_t x = 0; x < across_.size(); ++x)
        across_[x] = form.across((left_ + static_cast<int>(x) - box_.left) / box_.width());
    const bool speck = box_.height() <= kSpeck;
    if (least > 0 && !speck && hidden_.empty() && !may_be(form, least)) return 0;
    double all = wanted_apart(form);
    if (!(all > 0)) return 0;
    if (!hidden_.empty()) seen_ = std::min(1.0, (all - all_ink_) / (area_ * form.ink_before(1, 1)));
    if (speck) {
        const double share = std::clamp(all_ink_ / (all - all_ink_), kLeastSpeck, 1.0);
        for (int y = 0; y < rows_; ++y)
            for (int x = 0; x < columns_; ++x) apart_[framed(x, y)] += (1 - share) * wants_[at(x, y)];
        all -= (1 - share) * (all - all_ink_);
    }
    const double differs = differing(((1 - least) / 2 + kRounding) * all);
    return std::clamp(1 - 2 * differs / all, 0.0, 1.0);
}

// Rows and columns of pixels that have more ink than the letter, or less, differ by that much at least.
bool LetterInk::may_be(const LetterForm& form, double least) {
    const LetterForm::Place end_across = form.across(1), end_down = form.down(1);
    const double most = ((1 - least) / 2 + kRounding) * (all_ink_ + area_ * form.ink_before(end_across, end_down));
    // The letter has no ink at the border, where less is smoothed.
    const auto differ = [&](const std::vector<double>& weighed, auto ink_before) {
        double sum = 0, before = 0, own = 0, ink = 0;
        for (std::size_t i = 0; i <= weighed.size(); ++i) {
            double next = 0;
            if (i < weighed.size()) {
                const double more = ink_before(i + 1);
                next = weighed[i] - kSmoothed * area_ * (more - ink);
                ink = more;
            }
            if (i > 0) sum += std::abs(before + 2 * own + next);
            before = own;
            own = next;
        }
        return sum / (kSmoothed * kSmoothed);
    };
    const auto across = [&](std::size_t x) { return form.ink_before(across_[x], end_down); };
    if (differ(in_columns_, across) > most) return false;
    const auto down = [&](std::size_t y) {
        return form.ink_before(end_across, form.down((top_ + static_cast<int>(y) - box_.top) / box_.height()));
    };
    return differ(in_rows_, down) <= most;
}

// Fills what is apart, and gives the ink of both.
double LetterInk::wanted_apart(const LetterForm& form) {
    const auto corners = [&](int y, std::vector<double>& sums) {
        const LetterForm::Place down = form.down((top_ + y - box_.top) / box_.height());
        for (std::size_t x = 0; x < sums.size(); ++x) sums[x] = area_ * form.ink_before(across_[x], down);
    };
    double all = 0;
    corners(0, above_);
    for (int y = 0; y < rows_; ++y) {
        corners(y + 1, below_);
        for (int x = 0; x < columns_; ++x) {
            const auto i = static_cast<std::size_t>(x);
            const bool known = hidden_.empty() || !hidden_[at(x, y)];
            const double wanted = known ? below_[i + 1] - below_[i] - above_[i + 1] + above_[i] : 0;
            const double is = is_[at(x, y)];
            all += wanted + is;
            apart_[framed(x, y)] = is - wanted;
            wants_[at(x, y)] = wanted;
        }
        above_.swap(below_);
    }
    return all;
}

// Smoothed, for a stem that was moved by half a pixel is the same stem. It ends when it is more than `most`.
double LetterInk::differing(double most) const {
    double differs = 0;
    for (int y = 0; y < rows_ && differs <= most; ++y) {
        const double *above = &apart_[framed(-1, y - 1)], *own = &apart_[framed(-1, y)], *below = &apart_[framed(-1, y + 1)];
        for (int x = 0; x < columns_; ++x) {
            const double sum = above[x] + 2 * above[x + 1] + above[x + 2] + 2 * own[x] + 4 * own[x + 1] + 2 * own[x + 2] +
                               below[x] + 2 * below[x + 1] + below[x + 2];
            differs += std::abs(sum) / (kSmoothed * kSmoothed);
        }
    }
    return differs;
}

}  // namespace tactics
