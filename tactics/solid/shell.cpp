// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/shell.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "tactics/solid/ranks.h"

namespace tactics {

namespace {

// Two faces are one plane to a finger: half a degree over 10 cm lifts it by
// less than 1 mm. Cylinders of up to 360 sides stay round.
constexpr double kOnePlane = 0.00873;  // sine
constexpr double kUnsure = 0.5;        // tolerances of welding by which a corner may lift a face that is a sliver
constexpr double kInPlane = 3;         // tolerances of welding within which corners are in one plane
constexpr double kOffPlane = 20;       // and those that a corner may be off the plane of its patch
constexpr double kSamePlace = 50;      // tolerances by which a place may differ from file to file
constexpr double kSameShare = 1e-4;    // of the largest area, by which another may

using FaceLot = std::vector<std::uint32_t>;  // faces that are one

struct LotPlane {
    Point3 doubled;  // area, as doubled_area
    Point3 middle;
};

LotPlane plane_of(const Shell& shell, const FaceLot& lot) {
    LotPlane plane;
    double weight = 0;
    for (const std::uint32_t face : lot) {
        const double area = length_of(shell.doubled[face]);
        Point3 sum;
        for (const Corner corner : shell.rings[face]) sum = sum + shell.surface.corners[corner];
        plane.middle = plane.middle + (area / static_cast<double>(shell.rings[face].size())) * sum;
        plane.doubled = plane.doubled + shell.doubled[face];
        weight += area;
    }
    plane.middle = (1 / weight) * plane.middle;
    return plane;
}

double longest_side(const Shell& shell, std::uint32_t face) {
    const CornerRing& ring = shell.rings[face];
    double longest = 0;
    for (std::size_t i = 0; i < ring.size(); ++i)
        longest =
            std::max(longest, length_of(shell.surface.corners[ring[(i + 1) % ring.size()]] - shell.surface.corners[ring[i]]));
    return longest;
}

std::vector<FaceLot> lots_of(const Shell& shell, std::uint32_t count) {
    std::vector<FaceLot> lots(count);
    for (std::uint32_t face = 0; face < shell.rings.size(); ++face) lots[shell.patch[face]].push_back(face);
    return lots;
}

// The largest first, equal ones by where they are, so that the order of a file makes no difference.
std::vector<std::uint32_t> by_size(const std::vector<LotPlane>& planes, double tolerance) {
    std::vector<Point3> areas, middles;
    double largest = 0;
    for (const LotPlane& plane : planes) {
        areas.push_back({length_of(plane.doubled), 0, 0});
        middles.push_back(plane.middle);
        largest = std::max(largest, areas.back().x);
    }
    const auto large = ranks_of(areas, kSameShare * largest), where = ranks_of(middles, kSamePlace * tolerance);
    std::vector<std::uint32_t> order(planes.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return large[a] != large[b] ? large[a] > large[b] : where[a] < where[b];
    });
    return order;
}

// Joins each lot, the largest first, with neighbours that lie in its plane, and theirs.
std::uint32_t join_planes(Shell& shell, std::uint32_t lot_count, double off_plane) {
    constexpr std::uint32_t kNone = ~0u;
    const std::vector<FaceLot> lots = lots_of(shell, lot_count);
    std::vector<LotPlane> planes;
    for (const FaceLot& lot : lots) planes.push_back(plane_of(shell, lot));
    std::vector<std::uint32_t> joined(lot_count, kNone);
    std::uint32_t count = 0;
    for (const std::uint32_t first : by_size(planes, shell.surface.tolerance)) {
        if (joined[first] != kNone) continue;
        const Point3 normal = (1 / length_of(planes[first].doubled)) * planes[first].doubled;
        const auto fits = [&](std::uint32_t face) {
            const double area = length_of(shell.doubled[face]);
            const double lean = std::max(kOnePlane, kUnsure * shell.surface.tolerance * longest_side(shell, face) / area);
            return dot(normal, shell.doubled[face]) > 0 && length_of(cross(normal, shell.doubled[face])) <= lean * area &&
                   std::all_of(shell.rings[face].begin(), shell.rings[face].end(), [&](Corner corner) {
                       return std::abs(dot(normal, shell.surface.corners[corner] - planes[first].middle)) <= off_plane;
                   });
        };
        joined[first] = count;
        FaceLot waiting = lots[first];
        while (!waiting.empty()) {
            const CornerRing& ring = shell.rings[waiting.back()];
            waiting.pop_back();
            for (std::size_t i = 0; i < ring.size(); ++i) {
                const auto* others = shell.beyond(ring[i], ring[(i + 1) % ring.size()]);
                if (others == nullptr) continue;
                for (const std::uint32_t other : *others) {
                    const std::uint32_t number = shell.patch[other];
                    if (joined[number] != kNone || !std::all_of(lots[number].begin(), lots[number].end(), fits)) continue;
                    joined[number] = count;
                    waiting.insert(waiting.end(), lots[number].begin(), lots[number].end());
                }
            }
        }
        ++count;
    }
    for (std::uint32_t& patch : shell.patch) patch = joined[patch];
    return count;
}

}  // namespace

Shell shell_of(const WeldedSurface& surface, const std::vector<std::uint32_t>& faces) {
    Shell shell{.surface = surface};
    for (const std::uint32_t face : faces) {
        shell.rings.push_back(surface.faces[face]);
        shell.doubled.push_back(doubled_area(surface.corners, surface.faces[face]));
    }
    for (std::uint32_t face = 0; face < shell.rings.size(); ++face) {
        const CornerRing& ring = shell.rings[face];
        for (std::size_t i = 0; i < ring.size(); ++i) {
            shell.halves.push_back({ring[i], ring[(i + 1) % ring.size()], face});
            shell.by_side[Shell::key(ring[i], ring[(i + 1) % ring.size()])].push_back(face);
        }
    }
    return shell;
}

std::uint32_t grow_patches(Shell& shell) {
    shell.patch.resize(shell.rings.size());
    std::iota(shell.patch.begin(), shell.patch.end(), 0u);
    // First what is plane, then what is nearly: a part of a face that leans a little is not taken for one of its neighbour,
    // however the file divides it.
    const std::uint32_t plane =
        join_planes(shell, static_cast<std::uint32_t>(shell.rings.size()), kInPlane * shell.surface.tolerance);
    return join_planes(shell, plane, kOffPlane * shell.surface.tolerance);
}

}  // namespace tactics
