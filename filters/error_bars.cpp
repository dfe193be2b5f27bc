// SPDX-License-Identifier: Apache-2.0
#include "filters/error_bars.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "filters/thin_strokes.h"

namespace tactics {

namespace {

// On the page, mm; settings, all.
constexpr double kShortestStem = 2.5, kLongestStem = 80, kShortestBare = 4, kLongestBare = 30, kShortestCap = 1.5,
                 kLongestCap = 14;

constexpr int kStep = 20;  // grey levels, of a bar and the ground

// An upright stroke and its caps, which are level.
struct Stem {
    ThinStroke line;
    std::vector<ThinStroke> caps;
};

// Finds stems among upright strokes of a grey picture. What is level is found with the picture turned over its diagonal.
class StemSearch {
public:
    StemSearch(const Image& grey, const std::vector<ThinStroke>& uprights, const std::vector<ThinStroke>& levels, double mm)
        : grey_(grey), uprights_(uprights), levels_(levels), mm_(mm), near_(static_cast<int>(kWidestStroke / mm) + 1) {}

    std::vector<Stem> all() const {
        std::vector<Stem> stems;
        for (const ThinStroke& line : uprights_)
            if (std::optional<Stem> stem = stem_of(line)) stems.push_back(std::move(*stem));
        return stems;
    }

private:
    std::optional<Stem> stem_of(const ThinStroke& line) const {
        if (line.length() * mm_ > kLongestStem || line.length() * mm_ < kShortestStem) return std::nullopt;
        const std::optional<ThinStroke> first = cap_at(line, line.begin), last = cap_at(line, line.end);
        if (first && last) {
            const bool alike = std::abs(first->length() - last->length()) <= 2;
            if (alike && is_crossed(line, line.begin + near_, line.end - near_)) return Stem{line, {*first, *last}};
        } else if (first || last) {
            const int foot = first ? line.end : line.begin;
            if (is_crossed(line, foot - near_, foot + near_)) return Stem{line, {first ? *first : *last}};
        } else if (line.length() * mm_ >= kShortestBare && line.length() * mm_ <= kLongestBare &&
                   leads_across(line, line.begin - 3, line.end + 2) && is_crossed(line, line.begin + 2, line.end - 2)) {
            return Stem{line, {}};
        }
        return std::nullopt;
    }

    // As far to the left as to the right, but for whole pixels, where nothing goes on from it.
    std::optional<ThinStroke> cap_at(const ThinStroke& line, int end) const {
        for (const ThinStroke& level : levels_) {
            const int left = line.low - level.begin, right = level.end - line.high;
            if (level.low - near_ > end || end > level.high + near_ || level.length() * mm_ > kLongestCap || left < 2 ||
                right < 2 || std::abs(left - right) > 2 + std::max(left, right) / 8)
                continue;
            const bool goes_on = std::any_of(uprights_.begin(), uprights_.end(), [&](const ThinStroke& other) {
                return other.begin - near_ <= level.high && other.end + near_ >= level.low &&
                       (std::abs(other.middle() - level.begin) <= near_ || std::abs(other.middle() - level.end) <= near_) &&
                       (other.low >= line.high || other.high <= line.low);
            });
            if (!goes_on && is_outermost(level, end == line.begin)) return level;
        }
        return std::nullopt;
    }

    // Nothing is right beyond a cap: the base of an arrow's head is none.
    bool is_outermost(const ThinStroke& cap, bool above) const {
        constexpr int kHalo = 3;
        const int depth = std::max(4, cap.length() / 4), from = above ? cap.low - kHalo - depth : cap.high + kHalo - 1;
        int least = 255, most = 0;
        for (int y = from; y <= from + depth; ++y)
            for (int x = cap.begin; x < cap.end; ++x) {
                least = std::min(least, grey_at(grey_, x, y));
                most = std::max(most, grey_at(grey_, x, y));
            }
        return most - least < 2 * kStep;
    }

    // What is beside it changes in one row on both sides.
    bool is_crossed(const ThinStroke& line, int from, int to) const {
        const auto step = [&](int x, int y) { return std::abs(grey_at(grey_, x, y - 2) - grey_at(grey_, x, y + 2)); };
        for (int y = from; y < to; ++y)
            if (step(line.low - 4, y) >= kStep && step(line.high + 3, y) >= kStep) return true;
        return false;
    }

    // From one surface into another; a letter crosses no border.
    bool leads_across(const ThinStroke& line, int before, int behind) const {
        const int middle = static_cast<int>(line.middle());
        return is_free(line, before) && is_free(line, behind) &&
               std::abs(grey_at(grey_, middle, before) - grey_at(grey_, middle, behind)) >= kStep;
    }

    // The same colour all around that end.
    bool is_free(const ThinStroke& line, int beyond) const {
        if (beyond < 0 || beyond >= grey_.height) return false;
        const int middle = static_cast<int>(line.middle()), own = grey_at(grey_, middle, beyond);
        for (const int x : {line.low - 4, middle, line.high + 3})
            for (const int y : {beyond - 2, beyond, beyond + 2, beyond < line.begin ? line.begin + 1 : line.end - 2})
                if ((x != middle || y == beyond) && std::abs(grey_at(grey_, x, y) - own) >= kStep) return false;
        return true;
    }

    const Image& grey_;
    const std::vector<ThinStroke>&uprights_, &levels_;
    double mm_;
    int near_;  // pixels
};

// Caps first: what is beside a cap where its stem meets it is the stem.
void take_out(Image& picture, const std::vector<Stem>& stems, bool level, std::vector<std::array<Point, 2>>& taken) {
    for (const Stem& stem : stems)
        for (const ThinStroke& cap : stem.caps) {
            take_out(picture, cap, !level);
            taken.push_back(ends_of(cap, !level));
        }
    for (const Stem& stem : stems) {
        ThinStroke line = stem.line;
        for (const ThinStroke& cap : stem.caps) {
            line.begin = std::min(line.begin, cap.low);
            line.end = std::max(line.end, cap.high);
        }
        take_out(picture, line, level);
        for (const ThinStroke& cap : stem.caps) {  // on the page it ends in the middle of its cap
            if (line.begin == cap.low) line.begin = static_cast<int>(cap.middle());
            if (line.end == cap.high) line.end = static_cast<int>(cap.middle());
        }
        taken.push_back(ends_of(line, level));
    }
}

}  // namespace

std::vector<std::array<Point, 2>> take_error_bars(Image& picture) {
    const double mm = picture.mm_per_pixel;
    const ThinStrokes strokes = thin_strokes_in(picture, kShortestCap);
    const std::vector<Stem> upright = StemSearch(strokes.grey, strokes.upright, strokes.level, mm).all(),
                            level = StemSearch(strokes.turned, strokes.level, strokes.upright, mm).all();
    std::vector<std::array<Point, 2>> taken;
    take_out(picture, upright, false, taken);
    take_out(picture, level, true, taken);
    return taken;
}

}  // namespace tactics
