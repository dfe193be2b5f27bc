// SPDX-License-Identifier: Apache-2.0
#include "filters/inked_bars.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

#include "filters/darken.h"
#include "filters/lab.h"
#include "filters/opencv.h"
#include "tactics/geometry/bars_on_base.h"

namespace tactics {

namespace {

// Settings; mm on the page.
constexpr double kShortestRule = 3.2, kHatch = 4.8, kThinnestBar = 0.7;
constexpr double kLongerThanMarks = 12;  // of one at least: marks of a plot are at most 9 (known_parts.cpp)
constexpr int kFewestOfRule = 10, kFewestOfHatch = 8;
constexpr std::size_t kMostFills = 6;
constexpr double kMostOfPicture = 0.5;
constexpr BarSlack kBarSlack{3.5, 5};  // pixels

BarRectangle rectangle_of(const RuledCell& cell) {
    return {{cell.box.left - cell.lines[0] / 2, cell.box.top - cell.lines[1] / 2, cell.box.right + cell.lines[2] / 2,
             cell.box.bottom + cell.lines[3] / 2},
            cell.fill == CellFill::ground};
}

InkedBar inked(const Box& box, std::size_t fill) { return {box.left, box.top, box.right, box.bottom, fill}; }

// A rectangle that is mostly within another one is a piece of its pattern.
void drop_inner(std::vector<RuledCell>& cells) {
    std::sort(cells.begin(), cells.end(), [](const RuledCell& a, const RuledCell& b) {
        return std::int64_t{a.box.width()} * a.box.height() > std::int64_t{b.box.width()} * b.box.height();
    });
    std::vector<RuledCell> kept;
    for (const RuledCell& cell : cells) {
        const auto holds = [&](const RuledCell& other) {
            const PixelBox &a = other.box, &b = cell.box;
            const int wide = std::min(a.right, b.right) - std::max(a.left, b.left),
                      high = std::min(a.bottom, b.bottom) - std::max(a.top, b.top);
            return other.fill == CellFill::hatch && wide > 0 && high > 0 && 2 * wide * high > b.width() * b.height();
        };
        if (std::none_of(kept.begin(), kept.end(), holds)) kept.push_back(cell);
    }
    cells = std::move(kept);
}

// Those that stand on each other have the same sides, and the foot of one is the top of the one below. Two of one kind are one: a
// line of a grid parts them.
template <typename IsGrid>
void join_stacks(std::vector<StandingBar>& bars, std::vector<std::size_t>& kinds, const IsGrid& is_grid) {
    for (std::size_t i = 0; i < bars.size(); ++i)
        for (std::size_t j = 0; j < bars.size(); ++j) {
            if (i == j || !is_stacked_on(bars[i], bars[j], kBarSlack)) continue;
            StandingBar &upper = bars[i], &lower = bars[j];
            upper.left = lower.left = std::min(upper.left, lower.left);
            upper.right = lower.right = std::max(upper.right, lower.right);
            upper.foot = lower.top = (upper.foot + lower.top) / 2;
            if (kinds[i] != kinds[j] || !is_grid(kinds[i], lower)) continue;
            lower.top = upper.top;
            bars.erase(bars.begin() + static_cast<std::ptrdiff_t>(i));
            kinds.erase(kinds.begin() + static_cast<std::ptrdiff_t>(i));
            i = static_cast<std::size_t>(-1);
            break;
        }
}

// Of bars of one chart those far thinner than the middle one are pieces of something else.
void drop_thin(std::vector<StandingBar>& bars) {
    constexpr double kThin = 0.5;
    std::vector<double> widths;
    for (const StandingBar& bar : bars) widths.push_back(bar.width());
    const auto middle = widths.begin() + static_cast<std::ptrdiff_t>(widths.size() / 2);
    std::nth_element(widths.begin(), middle, widths.end());
    std::erase_if(bars, [&](const StandingBar& bar) { return bar.width() < kThin * *middle; });
}

// How deep the line at each side of a blank cell is, and that of the frame of a bar is the same all around; a grid is paler.
bool is_framed(const Image& picture, const PixelColour& ground, const RuledCell& cell) {
    constexpr int kOff = 4;  // pixels
    constexpr double kAsDeep = 0.6;
    const PixelBox& b = cell.box;
    const auto depth_at = [&](int x, int y, int step_x, int step_y) {
        int most = 0;
        for (int i = 0; i < kOff; ++i, x += step_x, y += step_y)
            if (x >= 0 && y >= 0 && x < picture.width && y < picture.height)
                most = std::max(most, channels_apart(pixel_colour(picture, x, y), ground));
        return most;
    };
    const int x = (b.left + b.right) / 2, y = (b.top + b.bottom) / 2;
    const std::array<int, 4> depths{depth_at(b.left - 1, y, -1, 0), depth_at(x, b.top - 1, 0, -1), depth_at(b.right, y, 1, 0),
                                    depth_at(x, b.bottom, 0, 1)};
    const auto [least, most] = std::minmax_element(depths.begin(), depths.end());
    return *least >= kAsDeep * *most;
}

// Sides that are nearly in line are in line.
void align(std::vector<InkedBar>& bars) {
    for (const auto& side : {std::pair{&InkedBar::left, &InkedBar::right}, std::pair{&InkedBar::top, &InkedBar::bottom}}) {
        std::vector<double*> all;
        for (InkedBar& bar : bars) all.insert(all.end(), {&(bar.*side.first), &(bar.*side.second)});
        std::sort(all.begin(), all.end(), [](const double* a, const double* b) { return *a < *b; });
        for (std::size_t begin = 0, end = 0; begin < all.size(); begin = end) {
            double sum = 0;
            while (end < all.size() && *all[end] - *all[begin] <= kBarSlack.touch) sum += *all[end++];
            for (std::size_t i = begin; i < end; ++i) *all[i] = sum / static_cast<double>(end - begin);
        }
    }
}

// The line at the height of the base, beyond the first bar or the last one.
std::optional<std::pair<int, int>> axis_of(const Image& picture, const PixelColour& ground, const InkedBars& found) {
    constexpr int kOutside = 6, kAround = 4, kInked = 40;  // pixels; levels
    double first = 1e9, last = -1e9;
    for (const InkedBar& bar : found.bars) {
        first = std::min(first, found.lying ? bar.top : bar.left);
        last = std::max(last, found.lying ? bar.bottom : bar.right);
    }
    const int base = static_cast<int>(found.base);
    for (const int along : {static_cast<int>(first) - kOutside, static_cast<int>(last) + kOutside}) {
        const auto is_inked = [&](int across) {
            const int x = found.lying ? across : along, y = found.lying ? along : across;
            return x >= 0 && y >= 0 && x < picture.width && y < picture.height &&
                   channels_apart(pixel_colour(picture, x, y), ground) > kInked;
        };
        int from = base - kAround, to = base + kAround;
        while (from <= to && !is_inked(from)) ++from;
        while (to >= from && !is_inked(to)) --to;
        if (from <= to) return std::pair(from, to);
    }
    return std::nullopt;
}

// How dark the darkest row is near there, along the bar's breadth or height.
double line_depth(const cv::Mat& dark, const InkedBar& bar, bool upright, double at) {
    constexpr int kNear = 3, kOff = 3;  // pixels
    double most = 0;
    for (int i = static_cast<int>(at) - kNear; i <= static_cast<int>(at) + kNear; ++i) {
        const cv::Rect line =
            upright ? cv::Rect(i, static_cast<int>(bar.top) + kOff, 1, static_cast<int>(bar.bottom - bar.top) - 2 * kOff)
                    : cv::Rect(static_cast<int>(bar.left) + kOff, i, static_cast<int>(bar.right - bar.left) - 2 * kOff, 1);
        if (line.width > 0 && line.height > 0 && (line & cv::Rect(0, 0, dark.cols, dark.rows)) == line)
            most = std::max(most, cv::mean(dark(line))[0]);
    }
    return most;
}

// What parts two pieces of a hatch is paler than the sides of the bar.
bool is_paler_than_sides(const cv::Mat& dark, const StandingBar& lower, bool lying) {
    constexpr double kPalerThanSides = 0.6;
    const InkedBar bar = inked(as_it_lies(lower, lying), 0);
    const double end = lying ? bar.right : bar.top, side = lying ? bar.top : bar.left;
    return line_depth(dark, bar, lying, end) < kPalerThanSides * line_depth(dark, bar, !lying, side);
}

// Without its border.
RuledCell inner_of(RuledCell cell) {
    constexpr int kOff = 2;  // pixels
    if (std::min(cell.box.width(), cell.box.height()) <= 2 * kOff) return cell;
    cell.box = {cell.box.left + kOff, cell.box.top + kOff, cell.box.right - kOff, cell.box.bottom - kOff};
    return cell;
}

std::vector<RuledCell> cells_in(const Image& picture, const PixelColour& ground, double mm, int flat, int widest) {
    std::vector<RuledCell> cells = ruled_cells_in(picture, ground,
                                                  {std::max(kFewestOfRule, static_cast<int>(std::lround(kShortestRule / mm))),
                                                   std::max(kFewestOfHatch, static_cast<int>(kHatch / mm)), flat, widest});
    const double thinnest = std::max(3.0, kThinnestBar / mm), most = kMostOfPicture * picture.width * picture.height;
    std::erase_if(cells, [&](const RuledCell& cell) {
        return std::min(cell.box.width(), cell.box.height()) < thinnest ||
               static_cast<double>(cell.box.width()) * cell.box.height() > most ||
               (cell.fill == CellFill::ground && !is_framed(picture, ground, cell));
    });
    drop_inner(cells);
    return cells;
}

double area_of(const std::vector<InkedBar>& bars) {
    return std::accumulate(bars.begin(), bars.end(), 0.0,
                           [](double sum, const InkedBar& bar) { return sum + (bar.right - bar.left) * (bar.bottom - bar.top); });
}

std::optional<InkedBars> bars_among(const std::vector<RuledCell>& cells, const Image& picture, double mm) {
    std::vector<BarRectangle> rectangles;
    for (const RuledCell& cell : cells) rectangles.push_back(rectangle_of(cell));
    BarsOnBase best = bars_on_base(rectangles, kBarSlack);
    if (best.bars.empty()) return std::nullopt;
    drop_thin(best.bars);
    InkedBars found;
    found.lying = best.lying;
    found.base = best.place();
    std::vector<BarFill> looks;
    std::vector<double> sizes;
    for (const StandingBar& bar : best.bars) {
        looks.push_back(bar_fill_of(picture, inner_of(cells[bar.number])));
        sizes.push_back(bar.area());
    }
    BarKinds kinds = kinds_of(looks, sizes);
    even_out(kinds, looks, bar_groups(best, kBarSlack));
    if (kinds.fills.size() > kMostFills || stand_as_boxes(best.bars, kBarSlack.touch)) return std::nullopt;
    found.fills = kinds.fills;
    const Image ink = ink_on_white(picture);
    const cv::Mat dark = 255 - view_of(ink);
    join_stacks(best.bars, kinds.of, [&](std::size_t kind, const StandingBar& lower) {
        return kinds.fills[kind].fill != CellFill::hatch || is_paler_than_sides(dark, lower, found.lying);
    });
    if (std::none_of(best.bars.begin(), best.bars.end(),
                     [&](const StandingBar& bar) { return (bar.foot - bar.top) * mm >= kLongerThanMarks; }))
        return std::nullopt;
    for (std::size_t i = 0; i < best.bars.size(); ++i)
        found.bars.push_back(inked(as_it_lies(best.bars[i], found.lying), kinds.of[i]));
    align(found.bars);
    return found;
}

}  // namespace

std::optional<InkedBars> inked_bars_in(const Image& picture, const PixelColour& ground, double mm) {
    // Settings for wide lines, for bars close together, and for thin ones; most pictures have not even one filled rectangle.
    constexpr std::array<std::array<int, 2>, 3> kFlatAndWidest{{{9, 7}, {9, 5}, {5, 5}}};
    constexpr std::ptrdiff_t kFewestFilled = 1;
    constexpr double kMore = 1.02;
    std::optional<InkedBars> best;
    for (std::size_t i = 0; i < kFlatAndWidest.size() && (i < 2 || !best); ++i) {
        const std::vector<RuledCell> cells = cells_in(picture, ground, mm, kFlatAndWidest[i][0], kFlatAndWidest[i][1]);
        const auto is_filled = [](const RuledCell& cell) { return cell.fill != CellFill::ground; };
        if (i == 0 && std::count_if(cells.begin(), cells.end(), is_filled) < kFewestFilled) return std::nullopt;
        auto found = bars_among(cells, picture, mm);
        if (found && (!best || area_of(found->bars) > kMore * area_of(best->bars))) best = std::move(found);
    }
    if (best) best->axis = axis_of(picture, ground, *best);
    return best;
}

ChartBars chart_bars_of(const InkedBars& found, double mm) {
    ChartBars bars{{}, {}, found.lying, found.base * mm, found.axis.has_value()};
    for (const InkedBar& b : found.bars) bars.bars.push_back({{b.left * mm, b.top * mm, b.right * mm, b.bottom * mm}, b.fill});
    for (const BarFill& fill : found.fills)
        bars.looks.push_back({fill.fill == CellFill::ground, fill.fill == CellFill::hatch, fill.dark});
    return bars;
}

}  // namespace tactics
