// SPDX-License-Identifier: Apache-2.0
#include "tactics/measure/consensus.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "tactics/measure/distance.h"
#include "tactics/measure/lines.h"
#include "tactics/measure/regions.h"
#include "tactics/measure/score.h"

namespace tactics {

namespace {

double share(std::size_t part, std::size_t all) { return static_cast<double>(part) / static_cast<double>(all); }

}  // namespace

std::vector<std::uint32_t> main_outline(const PixelSet& annotator) {
    constexpr double kLeast = 0.01, kMost = 0.6;
    constexpr int kSteps = 2;
    const int width = annotator.width, height = annotator.height;
    std::vector<std::uint32_t> line(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0);
    for (const std::uint32_t pixel : annotator.pixels) line[pixel] = 1;
    const LabelMap parts = connected(line, width, height);
    std::vector<long long> area(parts.regions, 0);
    std::vector<bool> apart(parts.regions, true);  // from the frame and from lines
    for (std::size_t i = 0; i < line.size(); ++i) {
        const int x = static_cast<int>(i) % width, y = static_cast<int>(i) / width;
        ++area[parts.label[i]];
        if (x == 0 || y == 0 || x + 1 == width || y + 1 == height || line[i] != 0) apart[parts.label[i]] = false;
    }
    const auto pixels = static_cast<double>(line.size());
    std::optional<std::uint32_t> main;
    for (std::uint32_t part = 0; part < parts.regions; ++part) {
        const auto own = static_cast<double>(area[part]);
        if (apart[part] && own > kLeast * pixels && own < kMost * pixels && (!main || area[part] >= area[*main])) main = part;
    }
    std::vector<std::uint32_t> outline;
    if (!main) return outline;
    for (const std::uint32_t pixel : annotator.pixels) {
        const int x = static_cast<int>(pixel) % width, y = static_cast<int>(pixel) / width;
        bool beside = false;
        for (int dy = -kSteps; dy <= kSteps; ++dy)
            for (int dx = std::abs(dy) - kSteps; dx <= kSteps - std::abs(dy); ++dx)
                beside = beside || (x + dx >= 0 && y + dy >= 0 && x + dx < width && y + dy < height &&
                                    parts.label[static_cast<std::size_t>(y + dy) * static_cast<std::size_t>(width) +
                                                static_cast<std::size_t>(x + dx)] == *main);
        if (beside) outline.push_back(pixel);
    }
    return outline;
}

Consensus::Consensus(std::span<const PixelSet> annotators)
    : diagonal_(std::hypot(annotators.front().width, annotators.front().height)) {
    const double reach = reach_of(annotators.front().width, annotators.front().height);
    reach_ = reach * reach;
    near_.assign(static_cast<std::size_t>(annotators.front().width) * static_cast<std::size_t>(annotators.front().height), 0);
    for (const PixelSet& annotator : annotators) {
        const std::vector<std::int64_t> squares = squared_distances(annotator);
        for (std::size_t i = 0; i < near_.size(); ++i)
            if (static_cast<double>(squares[i]) <= reach_) ++near_[i];
        if (auto outline = main_outline(annotator); !outline.empty()) objects_.push_back(std::move(outline));
    }
    std::vector<bool> agreed(near_.size(), false);
    for (const PixelSet& annotator : annotators)
        for (const std::uint32_t pixel : thinned(annotator).pixels) {
            if (near_[pixel] < kAgree || agreed[pixel]) continue;
            agreed[pixel] = true;
            agreed_.push_back(pixel);
        }
}

PageShares Consensus::shares_of(const PixelSet& lines) const {
    PageShares shares;
    if (!agreed_.empty()) shares.r3 = 0;
    if (!objects_.empty()) shares.main_object = 0;
    if (lines.pixels.empty()) return shares;
    const auto drawn_by = [&](int people) {
        return share(static_cast<std::size_t>(std::count_if(lines.pixels.begin(), lines.pixels.end(),
                                                            [&](std::uint32_t pixel) { return near_[pixel] >= people; })),
                     lines.pixels.size());
    };
    shares.p3 = drawn_by(kAgree);
    shares.p1 = drawn_by(1);
    shares.diagonals = static_cast<double>(lines.pixels.size()) / diagonal_;
    const std::vector<std::int64_t> squares = squared_distances(lines);
    const auto found = [&](const std::vector<std::uint32_t>& pixels) {
        return share(static_cast<std::size_t>(
                         std::count_if(pixels.begin(), pixels.end(),
                                       [&](std::uint32_t pixel) { return static_cast<double>(squares[pixel]) <= reach_; })),
                     pixels.size());
    };
    if (shares.r3) shares.r3 = found(agreed_);
    for (const auto& outline : objects_) *shares.main_object += found(outline) / static_cast<double>(objects_.size());
    return shares;
}

bool is_poor(const PageShares& page, const PageShares& person) {
    constexpr double kLine = 2.0 / 3, kFound = 0.45, kMain = 0.6, kBetter = 0.1;
    if (page.p3 < kLine && person.p3 >= page.p3 + kBetter) return true;
    return page.r3 && person.r3 && *page.r3 < kFound && *person.r3 >= *page.r3 + kBetter && page.main_object.value_or(0) < kMain;
}

std::size_t simplest_of(std::span<const PixelSet> annotators) {
    std::size_t simplest = 0;
    std::uint32_t fewest = 0;
    for (std::size_t i = 0; i < annotators.size(); ++i) {
        const std::uint32_t regions = regions_between(annotators[i]).regions;
        if (i > 0 && regions >= fewest) continue;
        simplest = i;
        fewest = regions;
    }
    return simplest;
}

std::vector<PixelSet> others_than(std::span<const PixelSet> annotators, std::size_t one) {
    std::vector<PixelSet> others;
    for (std::size_t i = 0; i < annotators.size(); ++i)
        if (i != one) others.push_back(annotators[i]);
    return others;
}

}  // namespace tactics
