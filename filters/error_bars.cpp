// SPDX-License-Identifier: Apache-2.0
#include "filters/error_bars.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include "filters/opencv.h"

namespace tactics {

namespace {

// On the page, mm; settings, all.
constexpr double kWidestStem = 1.2, kShortestStem = 2.5, kLongestStem = 80, kShortestBare = 4, kLongestBare = 30,
                 kShortestCap = 1.5, kLongestCap = 14;

// Grey levels: of ink and what is beside it; of a bar and the ground.
constexpr int kDarker = 50, kStep = 20;

constexpr std::size_t kMostStrokes = 2000;  // more are a hatch, or a text

// Thin and straight: [begin, end) along it, [low, high) across.
struct Thin {
    int begin = 0, end = 0, low = 0, high = 0;
    bool operator==(const Thin&) const = default;
    int length() const { return end - begin; }
    double middle() const { return (low + high) / 2.0; }
};

// An upright stroke and its caps, which are level.
struct Stem {
    Thin line;
    std::vector<Thin> caps;
};

// Of an odd size, as others would shift what they close.
cv::Mat rectangle(int width, int height) { return cv::getStructuringElement(cv::MORPH_RECT, cv::Size(width | 1, height | 1)); }

// All upright ones. Level lines that they cross do not part them.
std::vector<Thin> thin_uprights(const cv::Mat& grey, int widest, int shortest) {
    cv::Mat closed, labels, boxes, middles;
    cv::morphologyEx(grey, closed, cv::MORPH_CLOSE, rectangle(widest + 1, 1));
    cv::Mat ink = closed - grey > kDarker;
    cv::morphologyEx(ink, ink, cv::MORPH_CLOSE, rectangle(1, widest + 3));
    cv::morphologyEx(ink, ink, cv::MORPH_OPEN, rectangle(1, shortest));
    const int count = cv::connectedComponentsWithStats(ink, labels, boxes, middles);
    std::vector<Thin> strokes;
    for (int i = 1; i < count; ++i) {
        const int left = boxes.at<int>(i, cv::CC_STAT_LEFT), width = boxes.at<int>(i, cv::CC_STAT_WIDTH),
                  top = boxes.at<int>(i, cv::CC_STAT_TOP), height = boxes.at<int>(i, cv::CC_STAT_HEIGHT);
        if (width <= widest) strokes.push_back({top, top + height, left, left + width});
    }
    return strokes;
}

// Finds stems among upright strokes of a grey picture. What is level is found with the picture turned over its diagonal.
class StemSearch {
public:
    StemSearch(const cv::Mat& grey, const std::vector<Thin>& uprights, const std::vector<Thin>& levels, double mm)
        : grey_(grey), uprights_(uprights), levels_(levels), mm_(mm), near_(static_cast<int>(kWidestStem / mm) + 1) {}

    std::vector<Stem> all() const {
        std::vector<Stem> stems;
        for (const Thin& line : uprights_)
            if (std::optional<Stem> stem = stem_of(line)) stems.push_back(std::move(*stem));
        return stems;
    }

private:
    std::optional<Stem> stem_of(const Thin& line) const {
        if (line.length() * mm_ > kLongestStem || line.length() * mm_ < kShortestStem) return std::nullopt;
        const std::optional<Thin> first = cap_at(line, line.begin), last = cap_at(line, line.end);
        if (first && last) {
            const bool alike = std::abs(first->length() - last->length()) <= 2;
            if (alike && is_crossed(line, line.begin + near_, line.end - near_)) return Stem{line, {*first, *last}};
        } else if (first || last) {
            const int foot = first ? line.end : line.begin;
            if (is_crossed(line, foot - near_, foot + near_)) return Stem{line, {first ? *first : *last}};
        } else if (line.length() * mm_ >= kShortestBare && line.length() * mm_ <= kLongestBare && is_free(line, line.begin - 3) &&
                   is_free(line, line.end + 2) && is_crossed(line, line.begin + 2, line.end - 2, beyond_a_letter(line))) {
            return Stem{line, {}};
        }
        return std::nullopt;
    }

    // As far to the left as to the right, but for whole pixels, where nothing goes on from it.
    std::optional<Thin> cap_at(const Thin& line, int end) const {
        for (const Thin& level : levels_) {
            const int left = line.low - level.begin, right = level.end - line.high;
            if (level.low - near_ > end || end > level.high + near_ || level.length() * mm_ > kLongestCap || left < 2 ||
                right < 2 || std::abs(left - right) > 2 + std::max(left, right) / 8)
                continue;
            const bool goes_on = std::any_of(uprights_.begin(), uprights_.end(), [&](const Thin& other) {
                return other.begin - near_ <= level.high && other.end + near_ >= level.low &&
                       (std::abs(other.middle() - level.begin) <= near_ || std::abs(other.middle() - level.end) <= near_) &&
                       (other.low >= line.high || other.high <= line.low);
            });
            if (!goes_on && is_outermost(level, end == line.begin)) return level;
        }
        return std::nullopt;
    }

    // Nothing is right beyond a cap: the base of an arrow's head is none.
    bool is_outermost(const Thin& cap, bool above) const {
        constexpr int kHalo = 3;
        const int depth = std::max(4, cap.length() / 4), from = above ? cap.low - kHalo - depth : cap.high + kHalo - 1;
        int least = 255, most = 0;
        for (int y = from; y <= from + depth; ++y)
            for (int x = cap.begin; x < cap.end; ++x) {
                least = std::min(least, grey_at(x, y));
                most = std::max(most, grey_at(x, y));
            }
        return most - least < 2 * kStep;
    }

    int grey_at(int x, int y) const {
        return grey_.at<std::uint8_t>(std::clamp(y, 0, grey_.rows - 1), std::clamp(x, 0, grey_.cols - 1));
    }

    // So far from it the bar of a t ends, which goes through its stem, too.
    int beyond_a_letter(const Thin& line) const {
        constexpr double kFarthest = 3;  // mm
        return static_cast<int>(std::min(line.length() / 3.0, kFarthest / mm_));
    }

    // What is beside it, that far away, changes in one row on both sides.
    bool is_crossed(const Thin& line, int from, int to, int away = 3) const {
        const auto step = [&](int x, int y) { return std::abs(grey_at(x, y - 2) - grey_at(x, y + 2)); };
        for (int y = from; y < to; ++y)
            if (step(line.low - 1 - away, y) >= kStep && step(line.high + away, y) >= kStep) return true;
        return false;
    }

    // The same colour all around that end.
    bool is_free(const Thin& line, int beyond) const {
        if (beyond < 0 || beyond >= grey_.rows) return false;
        const int middle = static_cast<int>(line.middle()), own = grey_at(middle, beyond);
        for (const int x : {line.low - 4, middle, line.high + 3})
            for (const int y : {beyond - 2, beyond, beyond + 2, beyond < line.begin ? line.begin + 1 : line.end - 2})
                if ((x != middle || y == beyond) && std::abs(grey_at(x, y) - own) >= kStep) return false;
        return true;
    }

    const cv::Mat& grey_;
    const std::vector<Thin>&uprights_, &levels_;
    double mm_;
    int near_;  // pixels
};

// Across the stroke each pixel gets the colour of what is beside it, on its own side.
void paint_over(cv::Mat& pixels, const Thin& line, bool level) {
    constexpr int kHalo = 2;
    const int along = level ? pixels.cols : pixels.rows, across = level ? pixels.rows : pixels.cols;
    const int low = std::max(0, line.low - kHalo), high = std::min(across, line.high + kHalo);
    const auto pixel = [&](int at, int beside) {
        return pixels(level ? cv::Rect(at, beside, 1, 1) : cv::Rect(beside, at, 1, 1));
    };
    for (int at = std::max(0, line.begin - kHalo); at < std::min(along, line.end + kHalo); ++at)
        for (int beside = low; beside < high; ++beside) {
            const int from = 2 * beside < low + high ? std::max(0, low - 1) : std::min(across - 1, high);
            pixel(at, from).copyTo(pixel(at, beside));
        }
}

std::array<Point, 2> ends_of(const Thin& line, bool level) {
    const double begin = line.begin, end = line.end, middle = line.middle();
    if (level) return {Point{begin, middle}, Point{end, middle}};
    return {Point{middle, begin}, Point{middle, end}};
}

// Caps first: what is beside a cap where its stem meets it is the stem.
void take_out(cv::Mat pixels, const std::vector<Stem>& stems, bool level, std::vector<std::array<Point, 2>>& taken) {
    for (const Stem& stem : stems)
        for (const Thin& cap : stem.caps) {
            paint_over(pixels, cap, !level);
            taken.push_back(ends_of(cap, !level));
        }
    for (const Stem& stem : stems) {
        Thin line = stem.line;
        for (const Thin& cap : stem.caps) {
            line.begin = std::min(line.begin, cap.low);
            line.end = std::max(line.end, cap.high);
        }
        paint_over(pixels, line, level);
        for (const Thin& cap : stem.caps) {  // on the page it ends in the middle of its cap
            if (line.begin == cap.low) line.begin = static_cast<int>(cap.middle());
            if (line.end == cap.high) line.end = static_cast<int>(cap.middle());
        }
        taken.push_back(ends_of(line, level));
    }
}

// A cap on the border of two bars crosses it, but is no stem.
void leave_caps_of(const std::vector<Stem>& others, std::vector<Stem>& stems) {
    std::erase_if(stems, [&](const Stem& stem) {
        return std::any_of(others.begin(), others.end(), [&](const Stem& other) {
            return std::find(other.caps.begin(), other.caps.end(), stem.line) != other.caps.end();
        });
    });
}

}  // namespace

std::vector<std::array<Point, 2>> take_error_bars(Image& picture) {
    const double mm = picture.mm_per_pixel;
    const int widest = std::max(2, static_cast<int>(std::lround(kWidestStem / mm))),
              shortest = std::max(4, static_cast<int>(std::lround(kShortestCap / mm)));
    const Image in_grey = to_grey(picture);
    const cv::Mat grey = view_of(in_grey), turned = grey.t();
    const std::vector<Thin> uprights = thin_uprights(grey, widest, shortest), levels = thin_uprights(turned, widest, shortest);
    if (std::max(uprights.size(), levels.size()) > kMostStrokes) return {};
    std::vector<Stem> upright = StemSearch(grey, uprights, levels, mm).all(),
                      level = StemSearch(turned, levels, uprights, mm).all();
    leave_caps_of(upright, level);
    leave_caps_of(level, upright);
    std::vector<std::array<Point, 2>> taken;
    take_out(view_of(picture), upright, false, taken);
    take_out(view_of(picture), level, true, taken);
    return taken;
}

}  // namespace tactics
