// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/grown_patches.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "tactics/solid/ranks.h"

namespace tactics {

namespace {

// Two faces are one plane to a finger: half a degree over 10 cm lifts it by
// less than 1 mm. Cylinders of up to 360 sides stay round.
const double kOnePlane = std::cos(0.5 * 3.14159265358979323846 / 180);
constexpr double kOffPlane = 20;   // tolerances of welding that a corner may be off the plane of its patch
constexpr double kInPlane = 0.25;  // of those that it may be, and is in the plane itself

Point3 middle_of_ring(const WeldedSurface& surface, const CornerRing& ring) {
    Point3 sum;
    for (const std::uint32_t corner : ring) sum = sum + surface.corners[corner];
    return (1.0 / static_cast<double>(ring.size())) * sum;
}

// What patches grow from: a face, or faces of one plane that hang together.
struct PatchPart {
    Point3 doubled;  // twice its area
    Point3 middle;
    std::vector<std::uint32_t> faces;
};

// In the order of their size, so that a patch grows from its largest, whatever the last digits.
std::vector<std::uint32_t> by_size(const std::vector<PatchPart>& facets, double tolerance) {
    constexpr double kCertainPlace = 50;  // tolerances, by which a place may differ from file to file
    std::vector<Point3> areas, middles;
    double largest = 0;
    for (const PatchPart& facet : facets) {
        areas.push_back({length_of(facet.doubled), 0, 0});
        middles.push_back(facet.middle);
        largest = std::max(largest, areas.back().x);
    }
    return by_area_and_place(areas, 1e-4 * largest, middles, kCertainPlace * tolerance);
}

// Puts into `of`, which holds the facet of each face, what has grown from the largest facets; gives how many those are. `fits`: a
// facet lies in the plane of that normal and origin.
template <typename Fits>
std::uint32_t grow(const FaceShell& shell, const std::vector<PatchPart>& facets, std::vector<std::uint32_t>& of, Fits fits) {
    constexpr std::uint32_t kUngrown = ~0u;
    std::vector<std::uint32_t> grown(facets.size(), kUngrown);
    std::uint32_t count = 0;
    for (const std::uint32_t first : by_size(facets, shell.surface.tolerance)) {
        if (grown[first] != kUngrown) continue;
        const Point3 normal = unit(facets[first].doubled);
        grown[first] = count;
        std::vector<std::uint32_t> waiting = {first};
        const auto take = [&](std::uint32_t face) {
            const CornerRing& ring = shell.rings[face];
            for (std::size_t i = 0; i < ring.size(); ++i) {
                const auto* others = shell.beyond(ring[i], ring[(i + 1) % ring.size()]);
                if (others == nullptr) continue;
                for (const std::uint32_t other : *others) {
                    const std::uint32_t next = of[other];
                    if (grown[next] != kUngrown || !fits(facets[next], normal, facets[first].middle)) continue;
                    grown[next] = count;
                    waiting.push_back(next);
                }
            }
        };
        while (!waiting.empty()) {
            const PatchPart& facet = facets[waiting.back()];
            waiting.pop_back();
            for (const std::uint32_t face : facet.faces) take(face);
        }
        ++count;
    }
    for (std::uint32_t& one : of) one = grown[one];
    return count;
}

bool lies_in(const FaceShell& shell, const PatchPart& facet, const Point3& normal, const Point3& origin, double within) {
    return std::all_of(facet.faces.begin(), facet.faces.end(), [&](std::uint32_t face) {
        return std::all_of(shell.rings[face].begin(), shell.rings[face].end(), [&](std::uint32_t corner) {
            return std::abs(dot(normal, shell.surface.corners[corner] - origin)) <= within;
        });
    });
}

bool looks_along(const PatchPart& facet, const Point3& normal) {
    return dot(normal, facet.doubled) >= kOnePlane * length_of(facet.doubled);
}

std::vector<PatchPart> facets_of(const FaceShell& shell) {
    std::vector<PatchPart> facets;
    for (std::uint32_t face = 0; face < shell.rings.size(); ++face)
        facets.push_back({shell.doubled[face], middle_of_ring(shell.surface, shell.rings[face]), {face}});
    return facets;
}

std::vector<PatchPart> joined(const std::vector<PatchPart>& facets, const std::vector<std::uint32_t>& of, std::uint32_t count) {
    std::vector<PatchPart> made(count);
    std::vector<double> areas(count, 0);
    for (std::uint32_t i = 0; i < facets.size(); ++i) {
        PatchPart& one = made[of[i]];
        const double area = length_of(facets[i].doubled);
        one.doubled = one.doubled + facets[i].doubled;
        one.middle = one.middle + area * facets[i].middle;
        one.faces.push_back(i);
        areas[of[i]] += area;
    }
    for (std::uint32_t i = 0; i < count; ++i) made[i].middle = (1 / areas[i]) * made[i].middle;
    return made;
}

}  // namespace

std::uint32_t grow_patches(FaceShell& shell) {
    const double tolerance = shell.surface.tolerance;
    const std::vector<PatchPart> faces = facets_of(shell);
    shell.patch.resize(faces.size());
    std::iota(shell.patch.begin(), shell.patch.end(), 0u);
    // First what lies in one plane but for the last digits, however it is cut into faces: not a half of what leans a little. Of
    // narrow faces such digits turn the normal far, so that it is not asked.
    const std::uint32_t planes =
        grow(shell, faces, shell.patch, [&](const PatchPart& face, const Point3& normal, const Point3& at) {
            return dot(normal, face.doubled) > 0 && lies_in(shell, face, normal, at, kInPlane * tolerance);
        });
    return grow(shell, joined(faces, shell.patch, planes), shell.patch,
                [&](const PatchPart& facet, const Point3& normal, const Point3& at) {
                    return looks_along(facet, normal) && lies_in(shell, facet, normal, at, kOffPlane * tolerance);
                });
}

}  // namespace tactics
