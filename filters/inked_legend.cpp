// SPDX-License-Identifier: Apache-2.0
#include "filters/inked_legend.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <utility>
#include <vector>

#include "filters/bar_legend.h"
#include "filters/darken.h"
#include "filters/dash_rows.h"
#include "filters/inked_fills.h"
#include "filters/key_samples.h"
#include "filters/lab.h"
#include "filters/opencv.h"

namespace tactics {

namespace {

constexpr int kSame = 45;          // levels in each channel
constexpr int kSameOfDashes = 70;  // thin dashes are blurred, and thin curves
constexpr int kPalestDash = 0xb0;

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

// A curve of one pixel's width has its own colour only where it runs level or upright, and JPEG mixes it with the ground. A pixel
// is of the ink that explains it best.
cv::Mat thinly_painted(const Image& picture, const KeySample& sample, const std::vector<KeySample>& samples) {
    constexpr double kLeastInk = 0.4, kMostInk = 1.2;  // a pale band around a curve has less. Settings
    constexpr double kMostOfThin = 2.2;                // of a sample whose line is half in each of two rows
    constexpr int kThinSample = 2;                     // pixels
    constexpr double kRest = 32, kSameInk = 12;        // levels
    const double most = sample.box.height() <= kThinSample ? kMostOfThin : kMostInk;
    const PixelColour ground = ground_of(picture);
    cv::Mat own = cv::Mat::zeros(picture.height, picture.width, CV_8U);
    for (const KeySample& other : samples)
        if (other.words != sample.words && share_of_ink(other.colour, ground, sample.colour).rest <= kSameInk) return own;
    for (int y = 0; y < own.rows; ++y)
        for (int x = 0; x < own.cols; ++x) {
            const PixelColour pixel = pixel_colour(picture, x, y);
            const InkShare found = share_of_ink(pixel, ground, sample.colour);
            if (found.rest > kRest || found.share < kLeastInk || found.share > most) continue;
            const bool is_best = std::none_of(samples.begin(), samples.end(), [&](const KeySample& other) {
                return other.words != sample.words && share_of_ink(pixel, ground, other.colour).rest < found.rest;
            });
            if (is_best) own.at<std::uint8_t>(y, x) = 255;
        }
    return own;
}

// Within so many levels of its colour, and no nearer to that of another sample.
cv::Mat painted_like(const Image& picture, const KeySample& sample, const std::vector<KeySample>& samples, int same) {
    cv::Mat own = cv::Mat::zeros(picture.height, picture.width, CV_8U);
    for (int y = 0; y < own.rows; ++y)
        for (int x = 0; x < own.cols; ++x) {
            const PixelColour pixel = pixel_colour(picture, x, y);
            const int apart = channels_apart(pixel, sample.colour);
            if (apart <= same && std::none_of(samples.begin(), samples.end(), [&](const KeySample& other) {
                    return other.line == sample.line && !other.hatch && channels_apart(pixel, other.colour) < apart;
                }))
                own.at<std::uint8_t>(y, x) = 255;
        }
    return own;
}

// On the longer pieces of it.
std::optional<Point> place_on_curve(const cv::Mat& own, const KeySample& sample, const Image& ink,
                                    const std::vector<LegendEntry>& before) {
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

// A place on what is painted so, without the samples; on a curve where all else is far, in a surface where it is widest.
std::optional<Point> place_of(const Image& picture, const Image& ink, const KeySample& sample,
                              const std::vector<KeySample>& samples, const cv::Mat& elsewhere,
                              const std::vector<LegendEntry>& before) {
    // Pale surfaces are nearer to the ground than curves are.
    const int same = std::clamp(sample.off_ground / 2, 3, kSame);
    cv::Mat field, own = painted_like(picture, sample, samples, same);
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
    if (const auto at = place_on_curve(own, sample, ink, before)) return at;
    return place_on_curve(thinly_painted(picture, sample, samples) & elsewhere, sample, ink, before);
}

std::vector<DashRow> dashed_lines_of(const Image& ink, const Image& picture, const std::vector<KeySample>& samples) {
    constexpr double kLongest = 3, kWidest = 0.5, kWidestGap = 2;  // heights of letters
    double height = 0;
    for (const KeySample& one : samples) height = std::max(height, one.height);
    Image black = ink;
    for (std::uint8_t& pixel : black.pixels) pixel = pixel < kPalestDash ? 0 : 255;
    return dash_rows_in(black, picture, {kLongest * height, std::max(2.0, kWidest * height), kWidestGap * height});
}

// Its deepest ink has its colour; borders are paler.
PixelColour colour_of(const DashRow& row, const Image& picture, const Image& ink) {
    int deepest = 256;
    PixelColour colour{};
    for (const Run& run : row.ink)
        for (int x = run.begin; x < run.end; ++x) {
            if (ink.row(run.row)[x] >= deepest) continue;
            deepest = ink.row(run.row)[x];
            colour = pixel_colour(picture, x, run.row);
        }
    return colour;
}

// Of the samples of its colour; nothing where none is much like it.
const KeySample* most_like(const DashRow& row, const PixelColour& colour, const std::vector<KeySample>& samples) {
    constexpr double kMostUnlike = 0.4;
    const DashLengths own = lengths_of(row);
    const bool both = row.kind == DashKind::dashes_and_dots;
    const KeySample* best = nullptr;
    double least = kMostUnlike;
    for (const KeySample& one : samples) {
        if (!one.dashes || (*one.dashes == DashKind::dashes_and_dots) != both) continue;
        if (channels_apart(colour, one.colour) > kSameOfDashes) continue;
        if (const double off = both ? 0 : unlike(own, one.lengths); off < least) {
            least = off;
            best = &one;
        }
    }
    return best;
}

// The sample that each of these lines is like.
std::vector<const KeySample*> samples_of(const std::vector<DashRow>& rows, const std::vector<KeySample>& samples,
                                         const Image& picture, const Image& ink) {
    std::vector<const KeySample*> like;
    for (const DashRow& row : rows) like.push_back(row.leads ? nullptr : most_like(row, colour_of(row, picture, ink), samples));
    return like;
}

// The dashed lines that are like it.
std::optional<Point> place_on_dashes(const Image& ink, const KeySample& sample, const std::vector<DashRow>& rows,
                                     const std::vector<const KeySample*>& like, const cv::Mat& elsewhere,
                                     const std::vector<LegendEntry>& before) {
    cv::Mat own = cv::Mat::zeros(ink.height, ink.width, CV_8U);
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const DashRow& row = rows[k];
        if (like[k] != &sample) continue;
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
            const PixelColour c = pixel_colour(picture, x, y);
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

std::vector<LegendEntry> entries_of_bars(const Image& picture, const std::vector<KeySample>& surfaces, const InkedBars& bars) {
    std::vector<PixelBox> boxes;
    for (const KeySample& one : surfaces) boxes.push_back(one.box);
    const std::vector<Point> places = places_like(boxes, bars, picture);
    std::vector<LegendEntry> entries;
    for (std::size_t i = 0; i < places.size(); ++i) entries.push_back({surfaces[i].words, surfaces[i].box, places[i]});
    return entries;
}

// A hatch of few marks may look like the ground: neither it nor another hatch can be told from the others.
bool is_blank_sample(const KeySample& one) {
    constexpr int kAsGround = 6;  // levels
    return !one.line && !one.hatch && one.off_ground <= kAsGround;
}

}  // namespace

std::vector<LegendEntry> legend_in(const Image& picture, const std::vector<LegendWords>& words) {
    const Image ink = ink_on_white(picture);
    const std::vector<KeySample> all = key_samples_in(picture, ink, words);
    std::vector<KeySample> surfaces = all;
    std::erase_if(surfaces, [](const KeySample& one) { return one.line; });
    const std::optional<InkedBars> bars = surfaces.size() > 1 ? bars_of(picture) : std::nullopt;
    std::vector<LegendEntry> entries = bars ? entries_of_bars(picture, surfaces, *bars) : std::vector<LegendEntry>();
    const bool several = (bars && bars->fills.size() > 1) || std::any_of(surfaces.begin(), surfaces.end(), is_blank_sample);
    const std::vector<KeySample> samples = unlike_others(all);
    if (samples.size() < 2) return entries;
    cv::Mat elsewhere(picture.height, picture.width, CV_8U, cv::Scalar(255));
    for (const KeySample& one : samples) {
        const int room = static_cast<int>(one.height / 2);
        cv::rectangle(elsewhere, cv::Point(one.box.left - room, one.box.top - room),
                      cv::Point(one.box.right + room, one.box.bottom + room), cv::Scalar(0), cv::FILLED);
    }
    const bool any_dashes =
        std::any_of(samples.begin(), samples.end(), [](const KeySample& one) { return one.dashes.has_value(); });
    const std::vector<DashRow> rows = any_dashes ? dashed_lines_of(ink, picture, samples) : std::vector<DashRow>{};
    const std::vector<const KeySample*> like = samples_of(rows, samples, picture, ink);
    const bool of_bars = !entries.empty();
    for (const KeySample& one : samples) {
        if ((of_bars && !one.line) || (several && one.hatch) || is_blank_sample(one)) continue;
        if (one.line && is_grey(one.colour) && !any_dashes) continue;
        const auto at = one.hatch                         ? hatched_place(picture)
                        : one.dashes                      ? place_on_dashes(ink, one, rows, like, elsewhere, entries)
                        : one.line && is_grey(one.colour) ? place_on_grey(picture, ink, one, rows, elsewhere, entries)
                                                          : place_of(picture, ink, one, samples, elsewhere, entries);
        if (at) entries.push_back({one.words, one.box, *at});
    }
    return entries;
}

}  // namespace tactics
