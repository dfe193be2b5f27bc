// SPDX-License-Identifier: Apache-2.0
#include "filters/inked_legend.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "filters/darken.h"
#include "filters/dash_rows.h"
#include "filters/inked_fills.h"
#include "filters/lab.h"
#include "filters/opencv.h"

namespace tactics {

namespace {

// In heights of the letters beside them. Settings; those of legends in SVG (readers/svg/legend.cpp) are alike.
constexpr double kLeastWide = 0.8, kMostWide = 7, kMostHigh = 2.2, kNearest = 0.25, kAroundRow = 1.2, kLineHigh = 0.6;
constexpr double kSameColumn = 0.8, kNextRow = 5, kNextColumn = 30;
constexpr int kInkOfKeys = 215;    // of 255 is the ground
constexpr int kSame = 45;          // levels in each channel
constexpr int kSameOfDashes = 70;  // thin dashes are blurred, and thin curves
constexpr int kPalestDash = 0xb0;
constexpr double kColour = 40;  // levels between the channels of what is not grey

using PixelColour = std::array<int, 3>;

struct KeySample {
    std::size_t words = 0;
    PixelBox box;
    bool line = false, hatch = false;
    PixelColour colour{};
    double height = 0;                    // of the words
    int off_ground = 0;                   // levels
    std::optional<DashKind> dashes = {};  // of a line that is not whole
};

PixelColour colour_at(const Image& picture, int x, int y) {
    const std::uint8_t* at = picture.row(y) + x * picture.channels;
    return picture.channels == 3 ? PixelColour{at[0], at[1], at[2]} : PixelColour{at[0], at[0], at[0]};
}

bool is_grey(const PixelColour& c) {
    return *std::max_element(c.begin(), c.end()) - *std::min_element(c.begin(), c.end()) < kColour;
}
bool alike(const KeySample& a, const KeySample& b) {
    return a.line == b.line && a.hatch == b.hatch && a.dashes == b.dashes &&
           (a.hatch || channels_apart(a.colour, b.colour) <= kSame);
}

// What stands free in that window: neither through it nor out of it. What is far paler than the darkest of it is a piece of a
// legend's frame, or noise around the letters.
std::optional<PixelBox> free_ink(const Image& ink, const PixelBox& window) {
    constexpr double kPaler = 0.35;  // of the darkest ink's depth. Setting
    if (window.width() < 2 || window.height() < 2) return std::nullopt;
    const cv::Mat levels = view_of(ink)(cv::Rect(window.left, window.top, window.width(), window.height()));
    cv::Mat labels, stats, middles;
    const int count = cv::connectedComponentsWithStats(levels < kInkOfKeys, labels, stats, middles, 8, CV_32S);
    std::vector<std::pair<PixelBox, double>> pieces;  // and how far off the ground
    double deepest = 0;
    for (int i = 1; i < count; ++i) {
        const int x = stats.at<int>(i, cv::CC_STAT_LEFT), y = stats.at<int>(i, cv::CC_STAT_TOP);
        const int wide = stats.at<int>(i, cv::CC_STAT_WIDTH), high = stats.at<int>(i, cv::CC_STAT_HEIGHT);
        if (y == 0 || y + high == window.height()) continue;
        double darkest = 255;
        cv::minMaxLoc(levels, &darkest, nullptr, nullptr, nullptr, labels == i);
        pieces.push_back({{window.left + x, window.top + y, window.left + x + wide, window.top + y + high}, 255 - darkest});
        deepest = std::max(deepest, 255 - darkest);
    }
    std::optional<PixelBox> box;
    for (const auto& [piece, depth] : pieces)
        if (depth >= kPaler * deepest) box = box ? around(*box, piece) : piece;
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

// By the ink along it. The last mark may be cut off.
std::optional<DashKind> dashes_along(const Image& ink, const PixelBox& box) {
    std::vector<int> columns;
    double all = 0;
    for (int x = box.left; x < box.right; ++x) {
        int darkest = 255;
        for (int y = box.top; y < box.bottom; ++y) {
            darkest = std::min<int>(darkest, ink.row(y)[x]);
            all += 255 - ink.row(y)[x];
        }
        columns.push_back(darkest);
    }
    const int darkest = *std::min_element(columns.begin(), columns.end()), halfway = (darkest + 255) / 2;
    std::vector<double> lengths;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        if (columns[i] >= halfway) continue;
        if (i == 0 || columns[i - 1] >= halfway) lengths.push_back(0);
        ++lengths.back();
    }
    if (lengths.size() < 2) return std::nullopt;
    // As much ink as that is, if it were evenly dark.
    const double width = all / (255.0 - darkest) / std::accumulate(lengths.begin(), lengths.end(), 0.0);
    if (lengths.size() > 2) lengths.pop_back();
    for (double& length : lengths) length /= std::max(1.0, width);
    return dash_kind(std::move(lengths));
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
    if (sample.line) sample.dashes = dashes_along(ink, *box);
    return sample;
}

// How far its words are from it.
int off_words(const KeySample& sample, const std::vector<LegendWords>& words) {
    const PixelBox& box = words[sample.words].box;
    return std::max(box.left - sample.box.right, sample.box.left - box.right);
}

// A number beside an axis may be as far from a sample as the words are that it belongs to.
void keep_nearest_words(std::vector<KeySample>& samples, const std::vector<LegendWords>& words) {
    const std::vector<KeySample> all = samples;
    std::erase_if(samples, [&](const KeySample& one) {
        return std::any_of(all.begin(), all.end(), [&](const KeySample& other) {
            return other.words != one.words && overlap(other.box, one.box) && off_words(other, words) < off_words(one, words);
        });
    });
}

std::vector<KeySample> samples_of(const Image& picture, const Image& ink, const std::vector<LegendWords>& words) {
    std::vector<KeySample> all;
    for (std::size_t i = 0; i < words.size(); ++i)
        for (const bool left : {true, false})
            if (const auto sample = words[i].height > 0 ? sample_beside(picture, ink, words[i], i, left) : std::nullopt) {
                all.push_back(*sample);
                break;
            }
    keep_nearest_words(all, words);
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

// On the mask, where all ink but its own is farthest.
std::optional<Point> farthest_on(const cv::Mat& mask, const cv::Mat& own, const Image& ink,
                                 const std::vector<LegendEntry>& before) {
    // Its own paler border is no other ink.
    cv::Mat field, own_wide, others = view_of(ink) < kInkOfKeys;
    cv::dilate(own, own_wide, cv::getStructuringElement(cv::MORPH_RECT, cv::Size(7, 7)));
    others &= ~own_wide;
    // Nor do its words stand where those of another do.
    for (const LegendEntry& entry : before)
        others.at<std::uint8_t>(static_cast<int>(entry.at.y), static_cast<int>(entry.at.x)) = 255;
    cv::distanceTransform(~others, field, cv::DIST_L2, cv::DIST_MASK_PRECISE);
    return highest_in(field, mask);
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
    return farthest_on(mask, own, ink, before);
}

std::vector<DashRow> dashed_lines_of(const Image& ink, const Image& picture, const std::vector<KeySample>& samples) {
    constexpr double kLongest = 3, kWidest = 0.5, kWidestGap = 2;  // heights of letters
    double height = 0;
    for (const KeySample& one : samples) height = std::max(height, one.height);
    Image black = ink;
    for (std::uint8_t& pixel : black.pixels) pixel = pixel < kPalestDash ? 0 : 255;
    return dash_rows_in(black, picture, {kLongest * height, std::max(2.0, kWidest * height), kWidestGap * height});
}

// The dashed lines that are like it.
std::optional<Point> place_on_dashes(const Image& picture, const Image& ink, const KeySample& sample,
                                     const std::vector<DashRow>& rows, const cv::Mat& elsewhere,
                                     const std::vector<LegendEntry>& before) {
    cv::Mat own = cv::Mat::zeros(picture.height, picture.width, CV_8U);
    for (const DashRow& row : rows) {
        if (row.leads || row.kind != *sample.dashes) continue;
        // Its darkest ink has its colour; borders are paler.
        int darkest = 255 * 3;
        PixelColour own_colour{};
        for (const Run& run : row.ink)
            for (int x = run.begin; x < run.end; ++x) {
                const PixelColour colour = colour_at(picture, x, run.row);
                const int sum = colour[0] + colour[1] + colour[2];
                if (sum >= darkest) continue;
                darkest = sum;
                own_colour = colour;
            }
        if (channels_apart(own_colour, sample.colour) > kSameOfDashes) continue;
        for (std::size_t i = 0; i + 1 < row.points.size(); ++i)
            cv::line(own, cv::Point(static_cast<int>(row.points[i].x), static_cast<int>(row.points[i].y)),
                     cv::Point(static_cast<int>(row.points[i + 1].x), static_cast<int>(row.points[i + 1].y)), cv::Scalar(255),
                     std::max(1, static_cast<int>(row.width)));
    }
    own &= elsewhere;
    return farthest_on(own, own, ink, before);
}

// Ink without a colour of its own: the paler border of a coloured line has as much less of it as it is paler.
cv::Mat grey_ink(const Image& picture, const Image& ink) {
    constexpr double kLeastOfColour = 15, kShare = 0.3;  // levels between the channels, and of those off the ground. Settings
    cv::Mat grey = view_of(ink) < kInkOfKeys;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const PixelColour c = colour_at(picture, x, y);
            const int apart = *std::max_element(c.begin(), c.end()) - *std::min_element(c.begin(), c.end());
            if (apart > std::max(kLeastOfColour, kShare * (255 - ink.row(y)[x]))) grey.at<std::uint8_t>(y, x) = 0;
        }
    return grey;
}

// How far off the ground the darkest tenth of that ink is.
int ink_depth(const Image& ink, const cv::Mat& mask) {
    std::array<int, 256> counts{};
    int all = 0;
    for (int y = 0; y < mask.rows; ++y)
        for (int x = 0; x < mask.cols; ++x)
            if (mask.at<std::uint8_t>(y, x) != 0) ++all, ++counts[ink.row(y)[x]];
    int level = 0;
    for (int darker = counts[0]; level < 255 && darker < (all + 9) / 10;) darker += counts[static_cast<std::size_t>(++level)];
    return 255 - level;
}

// What of that ink is as deep as the sample: a black line has a pale border, and a thin one is paler for a while.
cv::Mat as_deep_as(const KeySample& sample, const cv::Mat& own, const Image& ink) {
    constexpr double kShare = 0.4;  // of its depth: the frame of a legend is paler than any curve
    constexpr int kAround = 7;      // pixels
    const double apart = std::min<double>(kSameOfDashes, kShare * sample.off_ground), depth = 255 - sample.off_ground;
    cv::Mat darkest, deep;
    cv::erode(view_of(ink), darkest, cv::getStructuringElement(cv::MORPH_RECT, cv::Size(kAround, kAround)));
    cv::inRange(darkest, cv::Scalar(depth - apart), cv::Scalar(depth + apart), deep);
    return own & deep;
}

// Black or grey and whole, as axes are, and the only curve that is. What crosses it in colour does not end it, and what covers it
// for a while leaves pieces of it one beside the other.
std::optional<Point> place_on_grey(const Image& picture, const Image& ink, const KeySample& sample,
                                   const std::vector<DashRow>& rows, const cv::Mat& elsewhere,
                                   const std::vector<LegendEntry>& before) {
    constexpr double kLong = 0.25;  // of the picture
    constexpr double kCrossed = 9;  // pixels of other ink on each side, as of a line that crosses at a small angle
    cv::Mat own = grey_ink(picture, ink) & elsewhere;
    for (const DashRow& row : rows)
        for (const Run& run : row.ink) own(cv::Rect(run.begin, run.row, run.end - run.begin, 1)) = 0;
    const int long_across = std::max(3, static_cast<int>(kLong * ink.width)),
              long_down = std::max(3, static_cast<int>(kLong * ink.height));
    cv::Mat level, upright, whole;
    cv::morphologyEx(own, level, cv::MORPH_OPEN, cv::getStructuringElement(cv::MORPH_RECT, cv::Size(long_across, 1)));
    cv::morphologyEx(own, upright, cv::MORPH_OPEN, cv::getStructuringElement(cv::MORPH_RECT, cv::Size(1, long_down)));
    own &= ~(level | upright);
    own = as_deep_as(sample, own, ink);
    cv::distanceTransform(~own, whole, cv::DIST_L2, cv::DIST_MASK_PRECISE);
    whole = (whole <= kCrossed) & (view_of(ink) < kInkOfKeys);
    cv::Mat labels, stats, middles;
    const int count = cv::connectedComponentsWithStats(whole, labels, stats, middles, 8, CV_32S);
    constexpr int kOverlap = 2 * static_cast<int>(kCrossed);  // pixels
    cv::Mat curve = cv::Mat::zeros(own.size(), CV_8U);
    std::vector<std::pair<int, int>> spans;  // across, of its pieces
    for (int i = 1; i < count; ++i) {
        if (std::hypot(stats.at<int>(i, cv::CC_STAT_WIDTH), stats.at<int>(i, cv::CC_STAT_HEIGHT)) < long_across) continue;
        const cv::Mat mask = (labels == i) & own;
        if (std::abs(ink_depth(ink, mask) - sample.off_ground) > kSameOfDashes) continue;
        const int left = stats.at<int>(i, cv::CC_STAT_LEFT), right = left + stats.at<int>(i, cv::CC_STAT_WIDTH);
        for (const auto& [begin, end] : spans)
            if (std::min(right, end) - std::max(left, begin) > kOverlap) return std::nullopt;
        spans.emplace_back(left, right);
        curve |= mask;
    }
    if (spans.empty()) return std::nullopt;
    return farthest_on(curve, curve, ink, before);
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
    const bool any_dashes =
        std::any_of(samples.begin(), samples.end(), [](const KeySample& one) { return one.dashes.has_value(); });
    const std::vector<DashRow> rows = any_dashes ? dashed_lines_of(ink, picture, samples) : std::vector<DashRow>{};
    std::vector<LegendEntry> entries;
    for (const KeySample& one : samples) {
        if (one.line && is_grey(one.colour) && !any_dashes) continue;
        const auto at = one.hatch                         ? hatched_place(picture)
                        : one.dashes                      ? place_on_dashes(picture, ink, one, rows, elsewhere, entries)
                        : one.line && is_grey(one.colour) ? place_on_grey(picture, ink, one, rows, elsewhere, entries)
                                                          : place_of(picture, ink, one, elsewhere, entries);
        if (at) entries.push_back({one.words, one.box, *at});
    }
    return entries;
}

}  // namespace tactics
