// SPDX-License-Identifier: Apache-2.0
#include "filters/key_samples.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <utility>
#include <vector>

#include "filters/lab.h"
#include "filters/opencv.h"

namespace tactics {

namespace {

// In heights of the letters beside them. Settings; those of legends in SVG (readers/svg/legend.cpp) are alike.
constexpr double kLeastWide = 0.8, kMostWide = 7, kMostHigh = 2.2, kNearest = 0.25, kAroundRow = 1.2, kLineHigh = 0.6;
constexpr double kSameColumn = 0.8, kNextRow = 5, kNextColumn = 30;
constexpr double kMostSwatch = 3.2, kSwatchRow = 0.5;  // the boxes of ggplot2 are 2.7 high
constexpr double kSwatchWide = 0.7;                    // of its height
constexpr int kAlikeSamples = 25;                      // levels in each channel

// Dots and dashes of little samples may be taken for each other, if they are told apart by how long they are.
bool dashed_alike(const KeySample& a, const KeySample& b) {
    constexpr double kAlikeLengths = 0.3;
    if (a.dashes.has_value() != b.dashes.has_value()) return false;
    if (!a.dashes) return true;
    const bool both = *a.dashes == DashKind::dashes_and_dots;
    return both == (*b.dashes == DashKind::dashes_and_dots) && (both || unlike(a.lengths, b.lengths) < kAlikeLengths);
}

bool alike(const KeySample& a, const KeySample& b) {
    return a.line == b.line && a.hatch == b.hatch && dashed_alike(a, b) &&
           (a.hatch || channels_apart(a.colour, b.colour) <= kAlikeSamples);
}

// The middle level of each channel; black if there are none.
PixelColour middle_of(std::vector<PixelColour> colours) {
    PixelColour middle{};
    if (colours.empty()) return middle;
    const auto half = colours.begin() + static_cast<std::ptrdiff_t>(colours.size() / 2);
    for (std::size_t c = 0; c < 3; ++c) {
        std::nth_element(colours.begin(), half, colours.end(),
                         [c](const PixelColour& a, const PixelColour& b) { return a[c] < b[c]; });
        middle[c] = (*half)[c];
    }
    return middle;
}

PixelColour middle_colour(const Image& picture, const PixelBox& box) {
    std::vector<PixelColour> colours;
    for (int y = box.top; y < box.bottom; ++y)
        for (int x = box.left; x < box.right; ++x) colours.push_back(pixel_colour(picture, x, y));
    return middle_of(std::move(colours));
}

// Ink on white in that window.
cv::Mat ink_on(const PixelColour& ground, const Image& picture, const PixelBox& window) {
    cv::Mat ink(window.height(), window.width(), CV_8U);
    for (int y = 0; y < ink.rows; ++y)
        for (int x = 0; x < ink.cols; ++x)
            ink.at<std::uint8_t>(y, x) =
                static_cast<std::uint8_t>(255 - channels_apart(pixel_colour(picture, window.left + x, window.top + y), ground));
    return ink;
}

struct KeyInk {
    PixelBox box;
    double depth = 0;  // how far off the ground
};

// What stands free in that window: neither through it nor out of it, nor towards the words. What is far paler than the darkest of
// it is a piece of a legend's frame, or noise around the letters.
std::vector<KeyInk> free_pieces(const cv::Mat& ink, const PixelBox& window, bool left) {
    constexpr double kPaler = 0.35;  // of the darkest ink's depth. Setting
    cv::Mat labels, stats, middles;
    const int count = cv::connectedComponentsWithStats(ink < kInkOfKeys, labels, stats, middles, 8, CV_32S);
    std::vector<KeyInk> pieces;
    double deepest = 0;
    for (int i = 1; i < count; ++i) {
        const int x = stats.at<int>(i, cv::CC_STAT_LEFT), y = stats.at<int>(i, cv::CC_STAT_TOP);
        const int right = x + stats.at<int>(i, cv::CC_STAT_WIDTH), bottom = y + stats.at<int>(i, cv::CC_STAT_HEIGHT);
        if (y == 0 || bottom == ink.rows || (left ? right == ink.cols : x == 0)) continue;
        double darkest = 255;
        cv::minMaxLoc(ink, &darkest, nullptr, nullptr, nullptr, labels == i);
        pieces.push_back({{window.left + x, window.top + y, window.left + right, window.top + bottom}, 255 - darkest});
        deepest = std::max(deepest, 255 - darkest);
    }
    std::erase_if(pieces, [&](const KeyInk& piece) { return piece.depth < kPaler * deepest; });
    return pieces;
}

// The piece that is nearest to the words, and what is in a row with it: a curve may run by beyond the legend.
std::optional<PixelBox> sample_among(const std::vector<KeyInk>& pieces, bool left) {
    if (pieces.empty()) return std::nullopt;
    PixelBox box = std::min_element(pieces.begin(), pieces.end(), [left](const KeyInk& a, const KeyInk& b) {
                       return left ? a.box.right > b.box.right : a.box.left < b.box.left;
                   })->box;
    for (bool grows = true; grows;) {
        grows = false;
        for (const KeyInk& piece : pieces) {
            if (piece.box.bottom <= box.top || piece.box.top >= box.bottom || around(box, piece.box) == box) continue;
            box = around(box, piece.box);
            grows = true;
        }
    }
    return box;
}

// An upright line, as the side of a box that the words stand in, is between them and the sample.
bool is_walled_off(const cv::Mat& ink, const PixelBox& window, const PixelBox& sample, bool left) {
    const int from = (left ? sample.right : window.left) - window.left, to = (left ? window.right : sample.left) - window.left;
    for (int x = std::max(0, from); x < std::min(ink.cols, to); ++x)
        if (cv::countNonZero(ink.col(x) >= kInkOfKeys) == 0) return true;
    return false;
}

// The marks of a dashed line go on beyond it, away from the words, as those of an arrow do.
bool goes_on(const Image& ink, const PixelBox& sample, bool left, double height) {
    const int reach = static_cast<int>(kMostWide * height / 2), above = std::max(0, sample.top - static_cast<int>(height / 2)),
              below = std::min(ink.height, sample.bottom + static_cast<int>(height / 2));
    const auto is_mark = [&](int x) {
        bool any = false;
        for (int y = above; y < below; ++y) {
            if (ink.row(y)[x] >= kInkOfKeys) continue;
            if (y < sample.top - 1 || y > sample.bottom) return false;
            any = true;
        }
        return any;
    };
    for (int step = 1; step <= reach; ++step) {
        const int x = left ? sample.left - step : sample.right - 1 + step;
        if (x < 0 || x >= ink.width) break;
        if (is_mark(x)) return true;
    }
    return false;
}

// The colour of most of it, and whether it is one.
void find_look(const Image& picture, const Image& ink, KeySample& sample) {
    std::vector<PixelColour> colours;
    int darkest = 255;
    for (int y = sample.box.top; y < sample.box.bottom; ++y)
        for (int x = sample.box.left; x < sample.box.right; ++x) darkest = std::min<int>(darkest, ink.row(y)[x]);
    const int dx = sample.line ? 0 : sample.box.width() / 4, dy = sample.line ? 0 : sample.box.height() / 4;
    int white = 0, all = 0;
    for (int y = sample.box.top + dy; y < sample.box.bottom - dy; ++y)
        for (int x = sample.box.left + dx; x < sample.box.right - dx; ++x, ++all) {
            white += ink.row(y)[x] >= kInkOfKeys ? 1 : 0;
            if (sample.line && ink.row(y)[x] > darkest + 40) continue;
            colours.push_back(pixel_colour(picture, x, y));
        }
    const int middle_x = (sample.box.left + sample.box.right) / 2, middle_y = (sample.box.top + sample.box.bottom) / 2;
    sample.off_ground = 255 - (sample.line ? darkest : ink.row(middle_y)[middle_x]);
    sample.colour = middle_of(std::move(colours));
    // In a pale surface all is as white.
    sample.hatch = !sample.line && white > 0.1 * all && white < 0.95 * all;
}

// By the ink along it. The last mark may be cut off.
void find_dashes(const Image& ink, KeySample& sample) {
    const PixelBox& box = sample.box;
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
    std::vector<double> marks, gaps;  // before the first mark and behind the last one its blurred ends are no gaps
    double gap = 0;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        if (columns[i] >= halfway) {
            ++gap;
            continue;
        }
        if (marks.empty() || gap > 0) {
            if (!marks.empty()) gaps.push_back(gap);
            marks.push_back(0);
        }
        ++marks.back();
        gap = 0;
    }
    if (marks.size() < 2) return;
    // As much ink as that is, if it were evenly dark.
    const double width = all / (255.0 - darkest) / std::accumulate(marks.begin(), marks.end(), 0.0);
    if (marks.size() > 2) marks.pop_back();
    sample.lengths = {middle_length(marks), middle_length(gaps)};
    for (double& length : marks) length /= std::max(1.0, width);
    sample.dashes = dash_kind(std::move(marks));
}

// Pixels that touch along their sides, of one colour.
struct ColourPatch {
    PixelBox box;
    std::vector<cv::Point> pixels;
};

// What has about that colour and touches the pixel at `from`; nothing if it leaves the window.
std::optional<ColourPatch> patch_at(const Image& picture, cv::Point from, const PixelBox& window) {
    const PixelColour colour = pixel_colour(picture, from.x, from.y);
    cv::Mat known = cv::Mat::zeros(window.height(), window.width(), CV_8U);
    ColourPatch patch{{from.x, from.y, from.x + 1, from.y + 1}, {}};
    const auto add = [&](int x, int y) {
        if (x < window.left || y < window.top || x >= window.right || y >= window.bottom) return false;
        std::uint8_t& pixel = known.at<std::uint8_t>(y - window.top, x - window.left);
        if (pixel != 0 || channels_apart(pixel_colour(picture, x, y), colour) > kAlikeSamples) return true;
        pixel = 1;
        patch.pixels.emplace_back(x, y);
        patch.box = around(patch.box, {x, y, x + 1, y + 1});
        return true;
    };
    add(from.x, from.y);
    for (std::size_t i = 0; i < patch.pixels.size(); ++i) {
        const cv::Point at = patch.pixels[i];
        if (!add(at.x - 1, at.y) || !add(at.x + 1, at.y) || !add(at.x, at.y - 1) || !add(at.x, at.y + 1)) return std::nullopt;
    }
    return patch;
}

// A rectangle, full or only its sides.
bool is_rectangle(const ColourPatch& patch) {
    constexpr int kSide = 2;  // pixels
    constexpr double kWhole = 0.95;
    const PixelBox& box = patch.box;
    if (std::min(box.width(), box.height()) <= 2 * kSide) return false;
    std::vector<bool> sides[4] = {std::vector<bool>(static_cast<std::size_t>(box.height())), {}, {}, {}};
    sides[1] = sides[0];
    sides[2] = sides[3] = std::vector<bool>(static_cast<std::size_t>(box.width()));
    for (const cv::Point& at : patch.pixels) {
        const auto row = static_cast<std::size_t>(at.y - box.top), column = static_cast<std::size_t>(at.x - box.left);
        if (at.x < box.left + kSide) sides[0][row] = true;
        if (at.x >= box.right - kSide) sides[1][row] = true;
        if (at.y < box.top + kSide) sides[2][column] = true;
        if (at.y >= box.bottom - kSide) sides[3][column] = true;
    }
    return std::all_of(std::begin(sides), std::end(sides), [](const std::vector<bool>& side) {
        return static_cast<double>(std::count(side.begin(), side.end(), true)) >= kWhole * static_cast<double>(side.size());
    });
}

// A box of one colour, or the border of one, that others may touch above and below it. A border is a sample of a line.
std::optional<KeySample> swatch_beside(const Image& picture, const Image& ink, const LegendWords& words, std::size_t number,
                                       bool left) {
    const double h = words.height;
    const int y = (words.box.top + words.box.bottom) / 2, step = left ? -1 : 1;
    const int nearest = left ? words.box.left - static_cast<int>(kNearest * h) : words.box.right + static_cast<int>(kNearest * h);
    const int reach = static_cast<int>(kMostWide * h);
    const PixelBox window{std::max(0, left ? nearest - reach : nearest), std::max(0, y - reach),
                          std::min(picture.width, left ? nearest + 1 : nearest + reach), std::min(picture.height, y + reach)};
    if (y < 0 || y >= picture.height) return std::nullopt;
    int x = nearest;
    const auto in_window = [&] { return x >= window.left && x < window.right; };
    while (in_window() && ink.row(y)[x] >= kInkOfKeys) x += step;
    // Where it begins it is blurred.
    while (in_window() && x + step >= window.left && x + step < window.right && ink.row(y)[x + step] < ink.row(y)[x]) x += step;
    if (!in_window()) return std::nullopt;
    const auto patch = patch_at(picture, {x, y}, window);
    if (!patch || !is_rectangle(*patch)) return std::nullopt;
    const PixelBox& box = patch->box;
    if (box.width() < kLeastWide * h || box.height() < kLeastWide * h || box.height() > kMostSwatch * h ||
        box.width() < kSwatchWide * box.height() || std::abs((box.top + box.bottom) / 2.0 - y) > kSwatchRow * h)
        return std::nullopt;
    const bool border = ink.row((box.top + box.bottom) / 2)[(box.left + box.right) / 2] >= kInkOfKeys;
    KeySample sample{number, box, border, false, {}, h};
    find_look(picture, ink, sample);
    return sample;
}

// A line with a mark on its middle.
bool is_marked_line(const Image& ink, const PixelBox& box) {
    constexpr double kThin = 0.45, kEnd = 0.15, kOffMiddle = 0.25, kLonger = 1.4;  // of its height; of its width; of its height
    if (box.width() < kLonger * box.height()) return false;
    const int ends = std::max(1, static_cast<int>(kEnd * box.width()));
    const auto is_thin = [&](int x) {
        int inked = 0;
        double middle = 0;
        for (int y = box.top; y < box.bottom; ++y)
            if (ink.row(y)[x] < kInkOfKeys) ++inked, middle += y + 0.5;
        if (inked == 0) return true;  // between dashes
        return inked <= kThin * box.height() &&
               std::abs(middle / inked - (box.top + box.bottom) / 2.0) <= kOffMiddle * box.height();
    };
    for (int i = 0; i < ends; ++i)
        if (!is_thin(box.left + i) || !is_thin(box.right - 1 - i)) return false;
    return true;
}

std::optional<KeySample> sample_beside(const Image& picture, const Image& ink, const LegendWords& words, std::size_t number,
                                       bool left) {
    const double h = words.height, y = (words.box.top + words.box.bottom) / 2.0;
    const double from = left ? words.box.left - kMostWide * h : words.box.right + kNearest * h;
    const double to = left ? words.box.left - kNearest * h : words.box.right + kMostWide * h;
    const PixelBox window{std::max(0, static_cast<int>(from)), std::max(0, static_cast<int>(y - kAroundRow * h)),
                          std::min(picture.width, static_cast<int>(to)),
                          std::min(picture.height, static_cast<int>(y + kAroundRow * h))};
    if (window.width() < 2 || window.height() < 2) return std::nullopt;
    const cv::Mat own_ink = ink_on(middle_colour(picture, words.box), picture, window);
    const auto box = sample_among(free_pieces(own_ink, window, left), left);
    if (!box || box->width() < kLeastWide * h || box->height() > kMostHigh * h || box->width() < box->height())
        return std::nullopt;
    if (box->left <= window.left || box->right >= window.right) return std::nullopt;
    if (std::abs((box->top + box->bottom) / 2.0 - y) > kSameColumn * h || is_walled_off(own_ink, window, *box, left))
        return std::nullopt;
    KeySample sample{number, *box, box->height() <= kLineHigh * h || is_marked_line(ink, *box), false, {}, h};
    find_look(picture, ink, sample);
    if (sample.line) find_dashes(ink, sample);
    if (sample.dashes && goes_on(ink, *box, left, h)) return std::nullopt;
    // With a mark on it nobody knows what its dashes are: its colour must do.
    if (sample.dashes && box->height() > kLineHigh * h) {
        if (is_grey(sample.colour)) return std::nullopt;
        sample.dashes.reset();
    }
    return sample;
}

std::optional<KeySample> key_beside(const Image& picture, const Image& ink, const LegendWords& words, std::size_t number,
                                    bool left) {
    const auto sample = sample_beside(picture, ink, words, number, left);
    return sample ? sample : swatch_beside(picture, ink, words, number, left);
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

// Those that are in a row or a column with another one.
std::vector<KeySample> in_rows(const std::vector<KeySample>& all) {
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
    return rows;
}

double mean_off_words(const std::vector<KeySample>& samples, const std::vector<LegendWords>& words) {
    double sum = 0;
    for (const KeySample& one : samples) sum += off_words(one, words);
    return sum / static_cast<double>(std::max<std::size_t>(1, samples.size()));
}

}  // namespace

double unlike(const DashLengths& a, const DashLengths& b) {
    const double one = a.mark + a.gap, other = b.mark + b.gap;
    return std::abs(std::log(one / other)) + std::abs(a.mark / one - b.mark / other);
}

// In a row the sample of the next words may be as close, so all words have theirs on the side where most have one.
std::vector<KeySample> key_samples_in(const Image& picture, const Image& ink, const std::vector<LegendWords>& words) {
    std::vector<KeySample> sides[2];
    for (const bool left : {true, false}) {
        std::vector<KeySample> all;
        for (std::size_t i = 0; i < words.size(); ++i)
            if (const auto sample = words[i].height > 0 ? key_beside(picture, ink, words[i], i, left) : std::nullopt)
                all.push_back(*sample);
        keep_nearest_words(all, words);
        sides[left ? 0 : 1] = in_rows(all);
    }
    if (sides[0].size() != sides[1].size()) return sides[sides[0].size() > sides[1].size() ? 0 : 1];
    return sides[mean_off_words(sides[0], words) <= mean_off_words(sides[1], words) ? 0 : 1];
}

std::vector<KeySample> unlike_others(const std::vector<KeySample>& samples) {
    std::vector<KeySample> unlike;
    for (const KeySample& one : samples)
        if (std::none_of(samples.begin(), samples.end(),
                         [&](const KeySample& other) { return one.words != other.words && alike(one, other); }))
            unlike.push_back(one);
    return unlike;
}

}  // namespace tactics
