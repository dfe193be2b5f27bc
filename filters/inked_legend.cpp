// SPDX-License-Identifier: Apache-2.0
#include "filters/inked_legend.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <optional>

#include "filters/darken.h"
#include "filters/inked_fills.h"
#include "filters/lab.h"
#include "filters/opencv.h"

namespace tactics {

namespace {

// In heights of the letters beside them. Settings; those of legends in SVG (readers/svg/legend.cpp) are alike.
constexpr double kLeastWide = 0.8, kMostWide = 7, kMostHigh = 2.2, kNearest = 0.25, kAroundRow = 1.2, kLineHigh = 0.6;
constexpr double kSameColumn = 0.8, kNextRow = 5, kNextColumn = 30;
constexpr int kInkOfKeys = 215;  // of 255 is the ground
constexpr int kSame = 45;        // levels in each channel
constexpr double kColour = 40;   // levels between the channels of what is not grey

using PixelColour = std::array<int, 3>;

struct KeySample {
    std::size_t words = 0;
    PixelBox box;
    bool line = false, hatch = false;
    PixelColour colour{};
    double height = 0;   // of the words
    int off_ground = 0;  // levels
};

PixelColour colour_at(const Image& picture, int x, int y) {
    const std::uint8_t* at = picture.row(y) + x * picture.channels;
    return picture.channels == 3 ? PixelColour{at[0], at[1], at[2]} : PixelColour{at[0], at[0], at[0]};
}

bool is_grey(const PixelColour& c) {
    return *std::max_element(c.begin(), c.end()) - *std::min_element(c.begin(), c.end()) < kColour;
}
bool alike(const KeySample& a, const KeySample& b) {
    return a.line == b.line && a.hatch == b.hatch && (a.hatch || channels_apart(a.colour, b.colour) <= kSame);
}

// What stands free in that window: neither through it nor out of it.
std::optional<PixelBox> free_ink(const Image& ink, const PixelBox& window) {
    if (window.width() < 2 || window.height() < 2) return std::nullopt;
    const cv::Mat part = view_of(ink)(cv::Rect(window.left, window.top, window.width(), window.height())) < kInkOfKeys;
    cv::Mat labels, stats, middles;
    const int count = cv::connectedComponentsWithStats(part, labels, stats, middles, 8, CV_32S);
    std::optional<PixelBox> box;
    for (int i = 1; i < count; ++i) {
        const int x = stats.at<int>(i, cv::CC_STAT_LEFT), y = stats.at<int>(i, cv::CC_STAT_TOP);
        const int wide = stats.at<int>(i, cv::CC_STAT_WIDTH), high = stats.at<int>(i, cv::CC_STAT_HEIGHT);
        if (y == 0 || y + high == window.height()) continue;
        const PixelBox one{window.left + x, window.top + y, window.left + x + wide, window.top + y + high};
        box = box ? around(*box, one) : one;
    }
    return box;
}

// The colour of most of it, and whether it is one.
void find_look(const Image& picture, const Image& ink, KeySample& sample) {
    std::array<std::vector<int>, 3> values;
    int darkest = 255;
    for (int y = sample.box.top; y < sample.box.bottom; ++y)
        for (int x = sample.box.left; x < sample.box.right; ++x) darkest = std::min<int>(darkest, ink.row(y)[x]);
    const int dx = sample.line ? 0 : sample.box.width() / 4, dy = sample.line ? 0 : sample.box.height() / 4;
    int white = 0, all = 0;
    for (int y = sample.box.top + dy; y < sample.box.bottom - dy; ++y)
        for (int x = sample.box.left + dx; x < sample.box.right - dx; ++x, ++all) {
            white += ink.row(y)[x] >= kInkOfKeys ? 1 : 0;
            if (sample.line && ink.row(y)[x] > darkest + 40) continue;
            const PixelColour colour = colour_at(picture, x, y);
            for (std::size_t c = 0; c < 3; ++c) values[c].push_back(colour[c]);
        }
    const int middle_x = (sample.box.left + sample.box.right) / 2, middle_y = (sample.box.top + sample.box.bottom) / 2;
    sample.off_ground = 255 - (sample.line ? darkest : ink.row(middle_y)[middle_x]);
    for (std::size_t c = 0; c < 3; ++c) {
        if (values[c].empty()) continue;
        const auto middle = values[c].begin() + static_cast<std::ptrdiff_t>(values[c].size() / 2);
        std::nth_element(values[c].begin(), middle, values[c].end());
        sample.colour[c] = *middle;
    }
    // In a pale surface all is as white.
    sample.hatch = !sample.line && white > 0.1 * all && white < 0.95 * all;
}

std::optional<KeySample> sample_beside(const Image& picture, const Image& ink, const LegendWords& words, std::size_t number,
                                       bool left) {
    const double h = words.height, y = (words.box.top + words.box.bottom) / 2.0;
    const double from = left ? words.box.left - kMostWide * h : words.box.right + kNearest * h;
    const double to = left ? words.box.left - kNearest * h : words.box.right + kMostWide * h;
    const PixelBox window{std::max(0, static_cast<int>(from)), std::max(0, static_cast<int>(y - kAroundRow * h)),
                          std::min(picture.width, static_cast<int>(to)),
                          std::min(picture.height, static_cast<int>(y + kAroundRow * h))};
    const auto box = free_ink(ink, window);
    if (!box || box->width() < kLeastWide * h || box->height() > kMostHigh * h || box->width() < box->height())
        return std::nullopt;
    if (box->left <= window.left || box->right >= window.right) return std::nullopt;
    if (std::abs((box->top + box->bottom) / 2.0 - y) > kSameColumn * h) return std::nullopt;
    KeySample sample{number, *box, box->height() <= kLineHigh * h, false, {}, h};
    find_look(picture, ink, sample);
    return sample;
}

std::vector<KeySample> samples_of(const Image& picture, const Image& ink, const std::vector<LegendWords>& words) {
    std::vector<KeySample> all;
    for (std::size_t i = 0; i < words.size(); ++i)
        for (const bool left : {true, false})
            if (const auto sample = words[i].height > 0 ? sample_beside(picture, ink, words[i], i, left) : std::nullopt) {
                all.push_back(*sample);
                break;
            }
    std::vector<KeySample> rows;
    for (const KeySample& one : all)
        if (std::any_of(all.begin(), all.end(), [&](const KeySample& other) {
                const double across = std::abs(one.box.left - other.box.left), down = std::abs(one.box.top - other.box.top);
                const double h = one.height;
                return one.words != other.words && one.line == other.line &&
                       ((across < kSameColumn * h && down < kNextRow * h) ||
                        (down < kSameColumn * h && across < kNextColumn * h));
            }))
            rows.push_back(one);
    std::vector<KeySample> unlike;
    for (const KeySample& one : rows)
        if (std::none_of(rows.begin(), rows.end(),
                         [&](const KeySample& other) { return one.words != other.words && alike(one, other); }))
            unlike.push_back(one);
    return unlike;
}

std::optional<Point> highest_in(const cv::Mat& field, const cv::Mat& mask) {
    double most = 0;
    cv::Point at;
    cv::minMaxLoc(field, nullptr, &most, nullptr, &at, mask);
    if (!(most > 0)) return std::nullopt;
    return Point{at.x + 0.5, at.y + 0.5};
}

// A place on what is painted so, without the samples; on a curve where all else is far, in a surface where it is widest.
std::optional<Point> place_of(const Image& picture, const Image& ink, const KeySample& sample, const cv::Mat& elsewhere,
                              const std::vector<LegendEntry>& before) {
    // Pale surfaces are nearer to the ground than curves are.
    const int same = std::clamp(sample.off_ground / 2, 3, kSame);
    const cv::Scalar low(sample.colour[0] - same, sample.colour[1] - same, sample.colour[2] - same);
    const cv::Scalar high(sample.colour[0] + same, sample.colour[1] + same, sample.colour[2] + same);
    cv::Mat own, field;
    cv::inRange(view_of(picture), low, high, own);
    own &= elsewhere;
    if (!sample.line) {
        cv::distanceTransform(own, field, cv::DIST_L2, cv::DIST_MASK_PRECISE);
        const auto at = highest_in(field, own);
        // Wider than the sample: else it is an outline in that colour.
        if (!at ||
            static_cast<double>(field.at<float>(static_cast<int>(at->y), static_cast<int>(at->x))) < 0.5 * sample.box.height())
            return std::nullopt;
        return at;
    }
    cv::Mat labels, stats, middles, mask = cv::Mat::zeros(own.size(), CV_8U);
    const int count = cv::connectedComponentsWithStats(own, labels, stats, middles, 8, CV_32S);
    std::vector<bool> large(static_cast<std::size_t>(count));
    for (int i = 1; i < count; ++i)
        large[static_cast<std::size_t>(i)] =
            std::hypot(stats.at<int>(i, cv::CC_STAT_WIDTH), stats.at<int>(i, cv::CC_STAT_HEIGHT)) > 1.5 * sample.height;
    for (int y = 0; y < mask.rows; ++y)
        for (int x = 0; x < mask.cols; ++x)
            if (large[static_cast<std::size_t>(labels.at<int>(y, x))]) mask.at<std::uint8_t>(y, x) = 255;
    // Its own paler border is no other ink.
    cv::Mat own_wide, others = view_of(ink) < kInkOfKeys;
    cv::dilate(own, own_wide, cv::getStructuringElement(cv::MORPH_RECT, cv::Size(7, 7)));
    others &= ~own_wide;
    // Nor do its words stand where those of another do.
    for (const LegendEntry& entry : before)
        others.at<std::uint8_t>(static_cast<int>(entry.at.y), static_cast<int>(entry.at.x)) = 255;
    cv::distanceTransform(~others, field, cv::DIST_L2, cv::DIST_MASK_PRECISE);
    return highest_in(field, mask);
}

}  // namespace

std::vector<LegendEntry> legend_in(const Image& picture, const std::vector<LegendWords>& words) {
    const Image ink = ink_on_white(picture);
    const std::vector<KeySample> samples = samples_of(picture, ink, words);
    if (samples.size() < 2) return {};
    cv::Mat elsewhere(picture.height, picture.width, CV_8U, cv::Scalar(255));
    for (const KeySample& one : samples) {
        const int room = static_cast<int>(one.height / 2);
        cv::rectangle(elsewhere, cv::Point(one.box.left - room, one.box.top - room),
                      cv::Point(one.box.right + room, one.box.bottom + room), cv::Scalar(0), cv::FILLED);
    }
    std::vector<LegendEntry> entries;
    for (const KeySample& one : samples) {
        if (one.line && is_grey(one.colour)) continue;
        const auto at = one.hatch ? hatched_place(picture) : place_of(picture, ink, one, elsewhere, entries);
        if (at) entries.push_back({one.words, one.box, *at});
    }
    return entries;
}

}  // namespace tactics
