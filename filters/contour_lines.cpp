// SPDX-License-Identifier: Apache-2.0
#include "filters/contour_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>

#include "filters/ticks.h"

namespace tactics {

namespace {

// A side of the grid is known by its first sample and whether it goes on upwards in y.
using SideKey = std::uint64_t;

class Marching {
public:
    Marching(const PlotSurface& surface, double level) : surface_(surface), level_(level), columns_(surface.x.size()) {}

    std::vector<ContourLine> lines() {
        for (std::size_t row = 0; row + 1 < surface_.y.size(); ++row)
            for (std::size_t column = 0; column + 1 < columns_; ++column) look_at(column, row);
        std::vector<ContourLine> all;
        for (const SideKey side : order_)  // lines that end come first: a closed one has no beginning
            if (joined_.at(side).count == 1 && !joined_.at(side).seen) all.push_back(follow(side));
        for (const SideKey side : order_)
            if (!joined_.at(side).seen) all.push_back(follow(side));
        std::erase_if(all, [](const ContourLine& line) { return line.points.size() < 2; });
        return all;
    }

private:
    // A line goes from side to side, through at most two squares at each.
    struct Joined {
        std::array<SideKey, 2> to{};
        int count = 0;
        bool seen = false;
    };

    SideKey across(std::size_t column, std::size_t row) const { return 2 * (row * columns_ + column); }
    SideKey up(std::size_t column, std::size_t row) const { return across(column, row) + 1; }

    void join(SideKey a, SideKey b) {
        for (const auto& [from, to] : {std::pair{a, b}, std::pair{b, a}}) {
            const auto [found, fresh] = joined_.try_emplace(from);
            if (fresh) order_.push_back(from);
            found->second.to[static_cast<std::size_t>(found->second.count++)] = to;
        }
    }

    void look_at(std::size_t column, std::size_t row) {
        const double z[4] = {surface_.at(column, row), surface_.at(column + 1, row), surface_.at(column + 1, row + 1),
                             surface_.at(column, row + 1)};
        const SideKey sides[4] = {across(column, row), up(column + 1, row), across(column, row + 1), up(column, row)};
        unsigned high = 0;  // a bit for each corner, the way round
        for (unsigned corner = 0; corner < 4; ++corner) {
            if (std::isnan(z[corner])) return;
            if (z[corner] >= level_) high |= 1u << corner;
        }
        if (high == 0 || high == 15) return;
        if (high == 5 || high == 10) {
            const bool middle = (z[0] + z[1] + z[2] + z[3]) / 4 >= level_;
            // What is not joined through the middle is cut off at its corner: 1 and 3, or 0 and 2.
            const bool odd_cut = (high == 5) == middle;
            join(sides[odd_cut ? 0 : 3], sides[odd_cut ? 1 : 0]);
            join(sides[odd_cut ? 2 : 1], sides[odd_cut ? 3 : 2]);
            return;
        }
        SideKey ends[2] = {};
        int found = 0;
        for (unsigned corner = 0; corner < 4; ++corner)
            if ((high >> corner & 1) != (high >> (corner + 1) % 4 & 1)) ends[found++] = sides[corner];
        join(ends[0], ends[1]);
    }

    PlotPoint point_on(SideKey side) const {
        const std::size_t sample = side / 2, column = sample % columns_, row = sample / columns_;
        const bool upwards = side % 2 == 1;
        const double from = surface_.at(column, row), to = upwards ? surface_.at(column, row + 1) : surface_.at(column + 1, row);
        const double share = (level_ - from) / (to - from);
        const auto between = [&](double a, double b) { return a + share * (b - a); };
        return upwards ? PlotPoint{surface_.x[column], between(surface_.y[row], surface_.y[row + 1])}
                       : PlotPoint{between(surface_.x[column], surface_.x[column + 1]), surface_.y[row]};
    }

    ContourLine follow(SideKey first) {
        ContourLine line;
        const auto take = [&](SideKey side) {
            const PlotPoint point = point_on(side);
            if (line.points.empty() || point.x != line.points.back().x || point.y != line.points.back().y)
                line.points.push_back(point);
        };
        for (SideKey at = first;;) {
            Joined& here = joined_.at(at);
            here.seen = true;
            take(at);
            SideKey next = at;
            for (int i = 0; i < here.count; ++i)
                if (!joined_.at(here.to[static_cast<std::size_t>(i)]).seen) next = here.to[static_cast<std::size_t>(i)];
            if (next == at) {
                line.closed = joined_.at(first).count == 2;
                break;
            }
            at = next;
        }
        const auto same = [](const PlotPoint& a, const PlotPoint& b) { return a.x == b.x && a.y == b.y; };
        if (line.closed && line.points.size() > 1 && same(line.points.front(), line.points.back())) line.points.pop_back();
        if (line.points.size() < 3) line.closed = false;
        return line;
    }

    const PlotSurface& surface_;
    double level_;
    std::size_t columns_;
    std::unordered_map<SideKey, Joined> joined_;
    std::vector<SideKey> order_;  // as they were met
};

}  // namespace

std::vector<ContourLine> contour_lines(const PlotSurface& surface, double level) { return Marching(surface, level).lines(); }

std::vector<double> contour_levels(const PlotSurface& surface, int most) {
    double low = INFINITY, high = -INFINITY;
    for (const double z : surface.z)
        if (!std::isnan(z)) {
            low = std::min(low, z);
            high = std::max(high, z);
        }
    if (!(low < high)) return {};
    // The ends of the range are no lines, so up to two round values more may be asked for.
    for (int ticks = most + 2; ticks >= 3; --ticks) {
        std::vector<double> levels = ticks_for(low, high, false, ticks).at;
        std::erase_if(levels, [&](double level) { return level <= low || level >= high; });
        if (levels.size() <= static_cast<std::size_t>(most)) return levels;
    }
    return {(low + high) / 2};
}

}  // namespace tactics
