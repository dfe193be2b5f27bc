// SPDX-License-Identifier: Apache-2.0
#include "filters/field_levels.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "filters/opencv.h"

namespace tactics {

namespace {

constexpr int kFieldRim = 3;  // pixels: the frame and its blur

struct FieldValues {
    cv::Mat position;  // bytes, for 0 to 1
    std::vector<bool> marked;
};

// What has none of the scale's colours has the value of what is nearest.
FieldValues field_values_of(const cv::Mat& picture, const ColourField& field) {
    constexpr double kMark = 60;  // levels off the scale
    const int width = field.box.width(), height = field.box.height();
    FieldValues values{cv::Mat(height, width, CV_8UC1),
                       std::vector<bool>(static_cast<std::size_t>(width) * static_cast<std::size_t>(height))};
    cv::Mat outside(height, width, CV_8UC1), away, nearest;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const auto found =
                field.scale.nearest(picture.ptr(y + field.box.top) + static_cast<std::ptrdiff_t>(3) * (x + field.box.left));
            const bool rim = x < kFieldRim || y < kFieldRim || x >= width - kFieldRim || y >= height - kFieldRim;
            values.position.ptr(y)[x] = static_cast<std::uint8_t>(std::lround(255 * found.position));
            outside.ptr(y)[x] = rim || found.away > kOnScale ? 255 : 0;
            values.marked[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)] =
                !rim && found.away > kMark;
        }
    // Beside a line its blur may have any colour.
    cv::dilate(outside, outside, cv::getStructuringElement(cv::MORPH_RECT, {3, 3}));
    cv::distanceTransform(outside, away, nearest, cv::DIST_L2, cv::DIST_MASK_5, cv::DIST_LABEL_PIXEL);
    std::vector<std::uint8_t> own(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) + 1);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            if (outside.ptr(y)[x] == 0) own[static_cast<std::size_t>(nearest.at<int>(y, x))] = values.position.ptr(y)[x];
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            if (outside.ptr(y)[x] != 0) values.position.ptr(y)[x] = own[static_cast<std::size_t>(nearest.at<int>(y, x))];
    return values;
}

// A limit at the tick nearby; else between two colours, so that a piece of one colour is not cut by its noise.
double settled_limit(double limit, double reach, const std::vector<double>& ticks, const ColourScale& scale) {
    double best = limit, least = reach;
    for (const double tick : ticks)
        if (std::abs(tick - limit) <= least) least = std::abs(tick - limit), best = tick;
    double between = best, nearest = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i + 1 < scale.knots().size(); ++i)
        if (const double middle = (scale.knots()[i].position + scale.knots()[i + 1].position) / 2;
            std::abs(middle - best) < nearest)
            nearest = std::abs(middle - best), between = middle;
    return between;
}

std::vector<double> limits_for(int most, const std::vector<double>& ticks, const ColourScale& scale) {
    constexpr double kReach = 0.4;  // of a level's height
    std::vector<double> limits;
    for (int k = 1; k < most; ++k)
        if (const double limit = settled_limit(static_cast<double>(k) / most, kReach / most, ticks, scale);
            limits.empty() || limit > limits.back())
            limits.push_back(limit);
    return limits;
}

std::vector<std::vector<double>> unlike_levels(std::size_t count) {
    std::vector<std::vector<double>> apart(count, std::vector<double>(count));
    for (std::size_t a = 0; a < count; ++a)
        for (std::size_t b = 0; b < count; ++b) apart[a][b] = 1 + std::abs(static_cast<double>(a) - static_cast<double>(b));
    return apart;
}

// The smallest first, measured anew each time: a region full of specks is as narrow as what is between them.
ClassMap felt_levels(ClassMap map, std::size_t count, double smallest) {
    const auto apart = unlike_levels(count);
    for (double least = std::min(2.0, smallest);; least = std::min(2 * least, smallest)) {
        Merging merging(map, apart);
        merging.merge(least, std::numeric_limits<std::size_t>::max());
        map = merging.result();
        if (least >= smallest) break;
    }
    map = without_necks(without_thin_parts(map, smallest / 2), smallest / 2);
    Merging merging(map, apart);
    merging.merge(smallest, std::numeric_limits<std::size_t>::max());
    return merging.result();
}

// Levels that are in no place of the map are no levels.
void drop_unused_levels(FieldLevels& levels) {
    std::vector<bool> used(levels.limits.size() + 1);
    for (const std::uint8_t level : levels.map.classes) used[level] = true;
    std::vector<std::uint8_t> number(used.size());
    std::vector<double> limits;
    std::uint8_t next = 0;
    for (std::size_t i = 0; i < used.size(); ++i) {
        number[i] = next;
        if (!used[i]) continue;
        if (next > 0) limits.push_back(levels.limits[i - 1]);
        ++next;
    }
    for (std::uint8_t& level : levels.map.classes) level = number[level];
    levels.limits = std::move(limits);
}

}  // namespace

FieldLevels field_levels_of(const Image& picture, const ColourField& field, const std::vector<double>& ticks,
                            const LevelWish& wish) {
    FieldValues values = field_values_of(three_channels(picture), field);
    // Noise of the values themselves; steps between cells stay where they are.
    const int across = 2 * std::max(1, static_cast<int>(wish.smallest / 4)) + 1;
    cv::Mat smooth;
    cv::medianBlur(values.position, smooth, std::min(across, 31));
    FieldLevels levels{
        limits_for(wish.most, ticks, field.scale), {field.box.width(), field.box.height(), {}}, std::move(values.marked), {}, 0};
    for (int y = 0; y < smooth.rows; ++y)
        for (int x = 0; x < smooth.cols; ++x) {
            const double value = smooth.ptr(y)[x] / 255.0;
            levels.values.push_back(value);
            levels.map.classes.push_back(static_cast<std::uint8_t>(
                std::upper_bound(levels.limits.begin(), levels.limits.end(), value) - levels.limits.begin()));
        }
    const std::vector<std::uint8_t> before = levels.map.classes;
    levels.map = felt_levels(std::move(levels.map), levels.limits.size() + 1, wish.smallest);
    std::size_t lost = 0;
    for (std::size_t i = 0; i < before.size(); ++i) lost += before[i] != levels.map.classes[i] ? 1 : 0;
    levels.lost = static_cast<double>(lost) / static_cast<double>(before.size());
    drop_unused_levels(levels);
    return levels;
}

std::vector<double> ticks_of(const Image& picture, const ColourField& field) {
    if (!field.bar) return {};
    const cv::Mat pixels = three_channels(picture);
    const PixelBox box = field.bar->box;
    const bool upright = field.bar->upright;
    const int length = upright ? box.height() : box.width();
    const auto grey_at = [&](int x, int y) {
        return x < 0 || y < 0 || x >= picture.width || y >= picture.height
                   ? -1
                   : luma(pixels.ptr(y) + static_cast<std::ptrdiff_t>(3) * x);
    };
    // On the right or below, as they are nearly always.
    constexpr int kOut = 2, kInk = 64;
    std::vector<double> ticks;
    int begin = -1;
    for (int k = 0; k <= length; ++k) {
        const auto grey = [&](int along) {
            return upright ? grey_at(box.right + kOut, box.bottom - 1 - along) : grey_at(box.left + along, box.bottom + kOut);
        };
        const int own = k < length ? grey(k) : -1;
        const bool ink = own >= 0 && own < 255 - kInk;
        if (ink && begin < 0) begin = k;
        if (!ink && begin >= 0) {
            ticks.push_back(static_cast<double>(begin + k) / 2 / length);
            begin = -1;
        }
    }
    constexpr std::size_t kMostTicks = 40;
    if (ticks.size() > kMostTicks) ticks.clear();
    return ticks;
}

namespace {

// The share of the field where its values jump.
double share_of_jumps(const FieldLevels& levels) {
    constexpr double kJump = 0.08;  // of the scale, in two pixels
    std::size_t jumps = 0;
    const auto width = static_cast<std::size_t>(levels.map.width);
    const std::vector<double>& values = levels.values;
    for (std::size_t i = 2 * width + 2; i < values.size(); ++i)
        jumps += std::max(std::abs(values[i] - values[i - 2]), std::abs(values[i] - values[i - 2 * width])) > kJump ? 1 : 0;
    return static_cast<double>(jumps) / static_cast<double>(values.size());
}

// The bar of filled contours has a knot for each of its colours.
bool has_all_shades(const ColourField& field) {
    constexpr std::size_t kMostOfContours = 36;
    return field.scale.knots().size() > kMostOfContours;
}

// Cells of a few colours, though the bar has all shades. Their own borders say more than levels do.
bool is_table_of_cells(const Image& picture, const ColourField& field) {
    constexpr std::size_t kFew = 64;
    constexpr double kRare = 0.0005, kNearlyAll = 0.9;  // of the field; the rest is print and what lies between
    if (!field.bar || !has_all_shades(field)) return false;
    const cv::Mat pixels = three_channels(picture);
    const PixelBox& box = field.box;
    std::map<int, std::size_t> counts;
    for (int y = box.top + kFieldRim; y < box.bottom - kFieldRim; ++y)
        for (int x = box.left + kFieldRim; x < box.right - kFieldRim; ++x) {
            const std::uint8_t* at = pixels.ptr(y) + static_cast<std::ptrdiff_t>(3) * x;
            ++counts[at[0] << 16 | at[1] << 8 | at[2]];
        }
    const double all = static_cast<double>(box.width()) * box.height();
    std::size_t colours = 0, covered = 0;
    for (const auto& [colour, count] : counts)
        if (static_cast<double>(count) >= kRare * all) {
            ++colours;
            covered += count;
        }
    return colours <= kFew && static_cast<double>(covered) >= kNearlyAll * all;
}

// Levels tell of it what it shows: not so of a texture, noise or a photograph, where too much is lost, nor of a table of cells.
bool is_told_by_levels(const Image& picture, const ColourField& field) {
    // A page of 250 mm, on which a level is 9 mm wide at least.
    constexpr double kPage = 250, kWide = 9, kMostLost = 0.12, kMostJumps = 0.03;
    const double side = std::max(picture.width, picture.height);
    const FieldLevels levels = field_levels_of(picture, field, {}, {4, kWide / kPage * side});
    if (levels.limits.empty() || levels.lost > kMostLost || is_table_of_cells(picture, field)) return false;
    // Filled contours jump, and their bar does, too. Other pictures with jumps may be no field.
    return share_of_jumps(levels) <= kMostJumps || (field.bar && !has_all_shades(field));
}

}  // namespace

Phrase levels_told(const Image& picture) {
    const std::vector<ColourField> fields = colour_fields_in(picture);
    if (fields.empty() ||
        std::any_of(fields.begin(), fields.end(), [&](const ColourField& field) { return !is_told_by_levels(picture, field); }))
        return {};
    return std::any_of(fields.begin(), fields.end(), [](const ColourField& field) { return field.bar.has_value(); })
               ? phrase("a field in the colours of a bar")
               : phrase("a field of colours on one scale");
}

}  // namespace tactics
