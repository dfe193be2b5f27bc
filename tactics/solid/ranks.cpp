// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/ranks.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace tactics {

std::vector<std::array<std::uint32_t, 3>> ranks_of(const std::vector<Point3>& places, double grain) {
    std::vector<std::array<std::uint32_t, 3>> ranks(places.size());
    std::vector<std::size_t> order(places.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    constexpr double Point3::*kAxes[] = {&Point3::x, &Point3::y, &Point3::z};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto at = [&](std::size_t i) { return places[i].*kAxes[axis]; };
        std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return at(a) < at(b); });
        std::uint32_t rank = 0;
        for (std::size_t i = 0; i < order.size(); ++i) {
            rank += i > 0 && at(order[i]) > at(order[i - 1]) + grain;
            ranks[order[i]][axis] = rank;
        }
    }
    return ranks;
}

std::vector<std::uint32_t> by_area_and_place(const std::vector<Point3>& areas, double same, const std::vector<Point3>& places,
                                             double grain) {
    const auto large = ranks_of(areas, same), where = ranks_of(places, grain);
    std::vector<std::uint32_t> order(areas.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return large[a] != large[b] ? large[a] > large[b] : where[a] < where[b];
    });
    return order;
}

std::vector<Point3>::iterator first_corner(std::vector<Point3>& ring, double grain) {
    std::vector<std::size_t> left(ring.size());
    std::iota(left.begin(), left.end(), std::size_t{0});
    for (double Point3::*along : {&Point3::x, &Point3::y, &Point3::z}) {
        double least = std::numeric_limits<double>::infinity();
        for (const std::size_t i : left) least = std::min(least, ring[i].*along);
        std::erase_if(left, [&](std::size_t i) { return ring[i].*along > least + grain; });
    }
    return ring.begin() + static_cast<std::ptrdiff_t>(left.front());
}

}  // namespace tactics
