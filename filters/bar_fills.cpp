// SPDX-License-Identifier: Apache-2.0
#include "filters/bar_fills.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>

#include "filters/lab.h"
#include "filters/opencv.h"

namespace tactics {

namespace {

constexpr int kSameFill = 20;  // levels in any channel
// Logarithms, shares and levels by which two hatches differ; settings.
constexpr double kSameDark = 0.5, kSameMarks = 0.5, kSameWays = 0.6, kSamePieces = 0.7, kSameTint = 15;

// How many begin along rows, for each pixel.
double marks_in(const cv::Mat& grey) {
    const double middle = cv::mean(grey)[0];
    int begun = 0;
    for (int y = 0; y < grey.rows; ++y)
        for (int x = 1; x < grey.cols; ++x)
            if (grey.at<std::uint8_t>(y, x - 1) > middle && grey.at<std::uint8_t>(y, x) <= middle) ++begun;
    return static_cast<double>(begun) / static_cast<double>(grey.total());
}

int pieces_in(const cv::Mat& grey) {
    cv::Mat labels;
    return cv::connectedComponents(grey < cv::mean(grey)[0], labels, 8, CV_32S) - 1;
}

// Dots, rings and crosses; of lines there are not more in a larger surface for its size.
bool is_of_marks(const BarFill& fill) {
    constexpr double kNoWay = 0.2;
    return *std::max_element(fill.ways.begin(), fill.ways.end()) < kNoWay;
}

void drop_kind(BarKinds& kinds, std::size_t gone) {
    for (std::size_t& kind : kinds.of)
        if (kind > gone) --kind;
    kinds.fills.erase(kinds.fills.begin() + static_cast<std::ptrdiff_t>(gone));
}

// The commonest kind at that place of all groups, if most have it.
std::optional<std::size_t> kind_at(const BarKinds& kinds, const std::vector<std::vector<std::size_t>>& groups,
                                   std::size_t place) {
    constexpr double kMost = 0.55;
    std::vector<std::size_t> counts(kinds.fills.size());
    for (const auto& group : groups) ++counts[kinds.of[group[place]]];
    const auto most = std::max_element(counts.begin(), counts.end());
    if (static_cast<double>(*most) < kMost * static_cast<double>(groups.size())) return std::nullopt;
    return static_cast<std::size_t>(most - counts.begin());
}

// Those of the commonest size, if that is two or more, and most have it; else none.
std::vector<std::vector<std::size_t>> groups_of_one_size(std::vector<std::vector<std::size_t>> groups) {
    constexpr std::size_t kFewestGroups = 3;
    constexpr double kMostGroups = 0.6;
    std::map<std::size_t, std::size_t> sizes;
    for (const auto& group : groups) ++sizes[group.size()];
    std::size_t size = 0;
    for (const auto& [one, count] : sizes)
        if (one > 1 && count >= kFewestGroups && static_cast<double>(count) >= kMostGroups * static_cast<double>(groups.size()))
            size = one;
    std::erase_if(groups, [&](const auto& group) { return group.size() != size; });
    return groups;
}

// A kind of one surface only that is nearly like another one is that: something crosses it.
void join_strays(BarKinds& kinds) {
    constexpr double kNearlyLike = 2;
    const auto count = [&](std::size_t kind) { return std::count(kinds.of.begin(), kinds.of.end(), kind); };
    for (std::size_t stray = kinds.fills.size(); stray-- > 0;) {
        if (count(stray) > 1) continue;
        std::size_t nearest = stray;
        double least = kNearlyLike;
        for (std::size_t i = 0; i < kinds.fills.size(); ++i)
            if (const double off = unlike(kinds.fills[i], kinds.fills[stray]); i != stray && count(i) > 1 && off < least) {
                least = off;
                nearest = i;
            }
        if (nearest == stray) continue;
        std::replace(kinds.of.begin(), kinds.of.end(), stray, nearest);
        drop_kind(kinds, stray);
    }
}

}  // namespace

BarFill bar_fill_of(const Image& picture, const RuledCell& cell) {
    BarFill look{cell.fill, cell.colour, 0, 0, 0, {}, {}};
    const cv::Rect box(cell.box.left, cell.box.top, cell.box.width(), cell.box.height());
    cv::Mat grey = view_of(picture)(box).clone(), dx, dy;
    if (grey.channels() == 3) {
        const cv::Scalar mean = cv::mean(grey);
        for (int c = 0; c < 3; ++c) look.tint[static_cast<std::size_t>(c)] = mean[c] - (mean[0] + mean[1] + mean[2]) / 3;
        cv::cvtColor(grey, grey, cv::COLOR_RGB2GRAY);
    }
    look.dark = 1 - cv::mean(grey)[0] / 255;
    cv::Sobel(grey, dx, CV_32F, 1, 0, 3, 0.25 / 255);
    cv::Sobel(grey, dy, CV_32F, 0, 1, 3, 0.25 / 255);
    double all = 0;
    for (int y = 0; y < grey.rows; ++y)
        for (int x = 0; x < grey.cols; ++x) {
            const double across = static_cast<double>(dx.at<float>(y, x)), down = static_cast<double>(dy.at<float>(y, x)),
                         step = std::hypot(across, down), ways = static_cast<double>(look.ways.size());
            if (step <= 0) continue;
            // Between two of the directions it counts for both.
            const double turn = (std::atan2(down, across) / std::numbers::pi + 1) * ways, share = turn - std::floor(turn);
            const auto first = static_cast<std::size_t>(turn);
            look.ways[first % look.ways.size()] += step * (1 - share);
            look.ways[(first + 1) % look.ways.size()] += step * share;
            all += step;
        }
    for (double& way : look.ways) way /= std::max(all, 1e-9);
    look.marks = marks_in(grey) + marks_in(grey.t());
    look.pieces = static_cast<double>(pieces_in(grey)) / static_cast<double>(grey.total());
    return look;
}

double unlike(const BarFill& a, const BarFill& b) {
    constexpr double kOtherKind = 10;
    if ((a.fill == CellFill::hatch) != (b.fill == CellFill::hatch)) return kOtherKind;
    if (a.fill != CellFill::hatch) return channels_apart(a.colour, b.colour) / (kSameFill + 0.5);
    const auto apart = [](double x, double y) { return std::abs(std::log(std::max(x, 1e-5) / std::max(y, 1e-5))); };
    double ways = 0;
    for (std::size_t i = 0; i < a.ways.size(); ++i) ways += std::abs(a.ways[i] - b.ways[i]);
    const double pieces = is_of_marks(a) && is_of_marks(b) ? apart(a.pieces, b.pieces) : 0;
    double tint = 0;
    for (std::size_t c = 0; c < 3; ++c) tint = std::max(tint, std::abs(a.tint[c] - b.tint[c]));
    return pieces / kSamePieces + tint / kSameTint + apart(a.dark, b.dark) / kSameDark + apart(a.marks, b.marks) / kSameMarks +
           ways / kSameWays;
}

BarKinds kinds_of(const std::vector<BarFill>& fills, const std::vector<double>& sizes) {
    std::vector<std::size_t> order(fills.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return sizes[a] > sizes[b]; });
    BarKinds kinds{{}, std::vector<std::size_t>(fills.size())};
    for (const std::size_t i : order) {
        const auto nearest = std::min_element(kinds.fills.begin(), kinds.fills.end(), [&](const BarFill& a, const BarFill& b) {
            return unlike(a, fills[i]) < unlike(b, fills[i]);
        });
        if (nearest != kinds.fills.end() && unlike(*nearest, fills[i]) < 1) {
            kinds.of[i] = static_cast<std::size_t>(nearest - kinds.fills.begin());
            continue;
        }
        kinds.of[i] = kinds.fills.size();
        kinds.fills.push_back(fills[i]);
    }
    join_strays(kinds);
    return kinds;
}

void even_out(BarKinds& kinds, const std::vector<BarFill>& fills, const std::vector<std::vector<std::size_t>>& groups) {
    constexpr double kMayBe = 4;
    const auto even = groups_of_one_size(groups);
    if (even.empty()) return;
    std::vector<std::size_t> common;
    for (std::size_t place = 0; place < even[0].size(); ++place) {
        const auto kind = kind_at(kinds, even, place);
        if (!kind || std::find(common.begin(), common.end(), *kind) != common.end()) return;
        common.push_back(*kind);
    }
    const auto off = [&](std::size_t fill, std::size_t kind) { return unlike(fills[fill], kinds.fills[kind]); };
    const auto become = [&](std::size_t fill, std::size_t kind) {
        if (fills[fill].fill == CellFill::hatch && off(fill, kind) < kMayBe) kinds.of[fill] = kind;
    };
    for (const auto& group : groups)
        for (std::size_t place = 0; place < group.size(); ++place) {
            if (group.size() == common.size())
                become(group[place], common[place]);
            else if (std::find(common.begin(), common.end(), kinds.of[group[place]]) == common.end())
                become(group[place], *std::min_element(common.begin(), common.end(), [&](std::size_t a, std::size_t b) {
                           return off(group[place], a) < off(group[place], b);
                       }));
        }
    for (std::size_t kind = kinds.fills.size(); kind-- > 0;)
        if (std::find(kinds.of.begin(), kinds.of.end(), kind) == kinds.of.end()) drop_kind(kinds, kind);
}

}  // namespace tactics
