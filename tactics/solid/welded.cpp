// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/welded.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <span>
#include <unordered_map>

#include "tactics/geometry/lots.h"
#include "tactics/geometry/triangulate.h"
#include "tactics/solid/ranks.h"
#include "tactics/solid/sheet_backs.h"

namespace tactics {

namespace {

using Corner = std::uint32_t;

// Cells of a grid in space, by their numbers put together; two cells may share
// one, which costs a look more.
class Cells {
public:
    explicit Cells(double size) : size_(size) {}
    void put(const Point3& at, Corner corner) { held_[key(number(at.x), number(at.y), number(at.z))].push_back(corner); }
    template <typename Take>
    void near(const Point3& at, Take take) const {
        const std::int64_t x = number(at.x), y = number(at.y), z = number(at.z);
        for (std::int64_t i = x - 1; i <= x + 1; ++i)
            for (std::int64_t j = y - 1; j <= y + 1; ++j)
                for (std::int64_t k = z - 1; k <= z + 1; ++k)
                    if (const auto cell = held_.find(key(i, j, k)); cell != held_.end())
                        for (const Corner corner : cell->second) take(corner);
    }

private:
    std::int64_t number(double at) const { return static_cast<std::int64_t>(std::floor(std::clamp(at / size_, -1e15, 1e15))); }
    static std::uint64_t key(std::int64_t x, std::int64_t y, std::int64_t z) {
        const auto mix = [](std::uint64_t a) { return (a ^ (a >> 31)) * 0x9E3779B97F4A7C15ull; };
        return mix(mix(mix(static_cast<std::uint64_t>(x)) + static_cast<std::uint64_t>(y)) + static_cast<std::uint64_t>(z));
    }
    double size_;
    std::unordered_map<std::uint64_t, std::vector<Corner>> held_;
};

// Neighbours of the same corner, and a side that is gone to and fro, enclose
// nothing.
void tidy(CornerRing& ring) {
    for (bool changed = true; changed && ring.size() > 2;) {
        changed = false;
        CornerRing kept;
        for (const Corner corner : ring) {
            if (!kept.empty() && kept.back() == corner) {
                changed = true;
            } else if (kept.size() > 1 && kept[kept.size() - 2] == corner) {
                kept.pop_back();
                changed = true;
            } else {
                kept.push_back(corner);
            }
        }
        while (kept.size() > 1 && kept.front() == kept.back()) kept.pop_back();
        ring = std::move(kept);
    }
    if (ring.size() < 3) ring.clear();
}

// Ends of sides at which no two faces are joined.
std::vector<Corner> open_ends(const WeldedSurface& surface) {
    const std::vector<Point3> areas = doubled_areas(surface);
    std::vector<Corner> ends;
    each_edge(sides_of(surface.faces), [&](std::span<const FaceSide> edge) {
        if (edge.size() != 2 || are_backs(areas[edge[0].face], areas[edge[1].face]))
            ends.insert(ends.end(), {edge.front().from, edge.front().to});
    });
    return ends;
}

// Of solids that are joined with another.
std::vector<Corner> joined_corners(const WeldedSurface& surface, const std::vector<SolidOfFace>& solid) {
    std::vector<char> has_more(solid.size(), 0);  // a solid has the number of one of its faces
    for (const SolidOfFace& one : solid)
        if (one.own != one.joined) has_more[one.joined] = 1;
    std::vector<Corner> corners;
    for (std::size_t face = 0; face < solid.size(); ++face)
        if (solid[face].joined != kNoSolid && has_more[solid[face].joined] != 0)
            corners.insert(corners.end(), surface.faces[face].begin(), surface.faces[face].end());
    return corners;
}

// Of the box round them, along the axes.
double longest_side(const std::vector<Point3>& corners) {
    double longest = 0;
    for (double Point3::*along : {&Point3::x, &Point3::y, &Point3::z}) {
        const auto [least, most] = std::minmax_element(corners.begin(), corners.end(),
                                                       [&](const Point3& a, const Point3& b) { return a.*along < b.*along; });
        longest = std::max(longest, *most.*along - *least.*along);
    }
    return longest;
}

// Those corners become corners of all sides that they lie on. A side may have two faces already: they may be of two solids that
// touch, and others are cut there.
void split_sides(WeldedSurface& surface, std::vector<Corner> ends) {
    if (ends.empty()) return;
    std::vector<FaceSide> edges;
    double total = 0;
    each_edge(sides_of(surface.faces), [&](std::span<const FaceSide> edge) {
        edges.push_back(edge.front());
        total += length_of(surface.corners[edge.front().to] - surface.corners[edge.front().from]);
    });
    if (!(total > 0)) return;
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    // About as long as a side, or as wide as the room of a corner, if sides are much longer than that, as in a fan.
    const double room = longest_side(surface.corners) / std::cbrt(static_cast<double>(ends.size()));
    const double cell = std::max(std::min(total / static_cast<double>(edges.size()), room), 4 * surface.tolerance);
    Cells cells(cell);
    for (const Corner corner : ends) cells.put(surface.corners[corner], corner);
    std::unordered_map<std::uint64_t, std::vector<std::pair<double, Corner>>> between;
    for (const FaceSide& side : edges) {
        const Corner low = std::min(side.from, side.to), high = std::max(side.from, side.to);
        const Point3 begin = surface.corners[low], along = surface.corners[high] - begin;
        const double length = length_of(along);
        std::vector<std::pair<double, Corner>> found;
        for (double at = 0; at <= length; at += cell)
            cells.near(begin + (at / length) * along, [&](Corner corner) {
                if (corner == low || corner == high) return;
                const Point3 off = surface.corners[corner] - begin;
                const double share = dot(off, along) / (length * length);
                if (share > 0 && share < 1 && length_of(off - share * along) <= surface.tolerance)
                    found.push_back({share, corner});
            });
        std::sort(found.begin(), found.end());
        found.erase(std::unique(found.begin(), found.end()), found.end());
        if (!found.empty()) between.emplace(key_of_side(low, high), std::move(found));
    }
    for (CornerRing& ring : surface.faces) {
        CornerRing split;
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Corner from = ring[i], to = ring[(i + 1) % ring.size()];
            split.push_back(from);
            const auto found = between.find(key_of_side(from, to));
            if (found == between.end()) continue;
            if (from < to)
                for (auto one = found->second.begin(); one != found->second.end(); ++one) split.push_back(one->second);
            else
                for (auto one = found->second.rbegin(); one != found->second.rend(); ++one) split.push_back(one->second);
        }
        ring = std::move(split);
        tidy(ring);
    }
}

// Faces with the same corners that look the same way.
std::size_t drop_copies(WeldedSurface& surface) {
    std::set<CornerRing> seen;
    const std::size_t before = surface.faces.size();
    std::erase_if(surface.faces, [&](const CornerRing& ring) {
        if (ring.empty()) return true;
        CornerRing sorted = ring;
        std::sort(sorted.begin(), sorted.end());
        sorted.push_back(looks_at_reader(doubled_area(surface.corners, ring)) ? 1 : 0);
        return !seen.insert(std::move(sorted)).second;
    });
    return before - surface.faces.size();
}

}  // namespace

std::vector<std::array<std::uint32_t, 3>> cut_if_bent(std::vector<Point3> ring, double tolerance) {
    constexpr double kCertainPlace = 50;  // tolerances, by which a place may differ from file to file
    constexpr double kInOnePlane = 0.05;  // of those; what is left as it is needs no patch to put it together again
    const std::size_t count = ring.size();
    const Point3 normal = unit(doubled_area(count, [&](std::size_t i) { return ring[i]; }));
    Point3 middle;
    for (const Point3& at : ring) middle = middle + (1.0 / static_cast<double>(count)) * at;
    if (count < 4 || std::all_of(ring.begin(), ring.end(),
                                 [&](const Point3& at) { return std::abs(dot(normal, at - middle)) <= kInOnePlane * tolerance; }))
        return {};
    auto first = first_corner(ring, kCertainPlace * tolerance);
    if (count == 4) {
        const auto across = [&](std::size_t i) { return length_of(ring[i + 2] - ring[i]); };
        const double one = across(0), other = across(1);
        if (std::abs(one - other) > 1e-3 * one) first = ring.begin() + (one < other ? 0 : 1);
    }
    const auto turned = static_cast<std::uint32_t>(first - ring.begin());
    std::rotate(ring.begin(), first, ring.end());
    auto triangles = triangulate(ring);
    for (auto& triangle : triangles)
        for (std::uint32_t& corner : triangle) corner = static_cast<std::uint32_t>((corner + turned) % count);
    return triangles;
}

WeldedSurface weld(const Model& model, const std::vector<std::uint32_t>& faces, double tolerance, std::size_t& dropped) {
    WeldedSurface surface;
    surface.tolerance = tolerance;
    std::vector<CornerRing> rings;
    std::unordered_map<Corner, Corner> own;
    for (const std::uint32_t face : faces) {
        CornerRing& ring = rings.emplace_back();
        for (std::uint32_t i = 0; i < model.faces[face].count; ++i) {
            const Corner vertex = model.corners[model.faces[face].first + i];
            const auto [place, fresh] = own.emplace(vertex, static_cast<Corner>(surface.corners.size()));
            if (fresh) surface.corners.push_back(model.vertices[vertex]);
            ring.push_back(place->second);
        }
    }
    Lots lots(surface.corners.size());
    Cells cells(2 * tolerance);
    for (Corner corner = 0; corner < surface.corners.size(); ++corner) {
        bool fresh = true;
        cells.near(surface.corners[corner], [&](Corner other) {
            if (length_of(surface.corners[corner] - surface.corners[other]) > tolerance) return;
            lots.join(corner, other);
            fresh = false;
        });
        // One vertex represents all that are joined to it, so a cell holds few, however many coincide.
        if (fresh) cells.put(surface.corners[corner], corner);
    }
    for (CornerRing& ring : rings) {
        for (Corner& corner : ring) corner = lots.find(corner);
        tidy(ring);
        if (ring.empty()) continue;
        const Point3 doubled = doubled_area(surface.corners, ring);
        double longest = 0;
        for (std::size_t i = 0; i < ring.size(); ++i)
            longest = std::max(longest, length_of(surface.corners[ring[i]] - surface.corners[ring[(i + 1) % ring.size()]]));
        if (!(length_of(doubled) > 2 * tolerance * longest)) {
            ring.clear();
        } else if (ring.size() > 3) {
            std::vector<Point3> corners;
            for (const Corner corner : ring) corners.push_back(surface.corners[corner]);
            const auto triangles = cut_if_bent(std::move(corners), tolerance);
            for (const auto& cut : triangles) surface.faces.push_back({ring[cut[0]], ring[cut[1]], ring[cut[2]]});
            if (!triangles.empty()) continue;
        }
        surface.faces.push_back(std::move(ring));
    }
    dropped += drop_copies(surface);
    split_sides(surface, open_ends(surface));
    dropped += drop_copies(surface);
    std::vector<SolidOfFace> solid = touching_solids(surface);
    split_sides(surface, joined_corners(surface, solid));
    dropped += drop_backs(surface, solid);
    set_apart(surface, solid);
    return surface;
}

std::vector<std::vector<std::uint32_t>> shells_of(const WeldedSurface& surface) {
    Lots lots(surface.faces.size());
    const std::vector<FaceSide> sides = sides_of(surface.faces);
    each_edge(sides, [&](std::span<const FaceSide> edge) {
        for (const FaceSide& side : edge) lots.join(edge.front().face, side.face);
    });
    std::vector<std::vector<std::uint32_t>> shells;
    std::unordered_map<std::uint32_t, std::size_t> place;
    for (std::uint32_t face = 0; face < surface.faces.size(); ++face) {
        const auto [shell, fresh] = place.emplace(lots.find(face), shells.size());
        if (fresh) shells.emplace_back();
        shells[shell->second].push_back(face);
    }
    return shells;
}

void face_outwards(WeldedSurface& surface, const std::vector<std::uint32_t>& shell) {
    std::vector<CornerRing> rings;
    for (const std::uint32_t face : shell) rings.push_back(surface.faces[face]);
    const std::vector<FaceSide> sides = sides_of(rings);
    std::vector<std::vector<std::pair<std::uint32_t, bool>>> neighbours(rings.size());  // and whether they agree
    bool closed = true;
    each_edge(sides, [&](std::span<const FaceSide> edge) {
        closed = closed && edge.size() == 2;
        if (edge.size() != 2) return;
        const FaceSide &one = edge.front(), &other = edge.back();
        const bool agree = one.from != other.from;
        neighbours[one.face].push_back({other.face, agree});
        neighbours[other.face].push_back({one.face, agree});
    });
    std::vector<int> turned(rings.size(), -1);
    for (std::uint32_t first = 0; first < rings.size(); ++first) {
        if (turned[first] >= 0) continue;
        std::vector<std::uint32_t> group = {first};
        turned[first] = 0;
        double kept = 0, volume = 0;  // area that stays as it is, less what is
                                      // turned; six times the volume
        for (std::size_t i = 0; i < group.size(); ++i) {
            const std::uint32_t face = group[i];
            const double sign = turned[face] != 0 ? -1 : 1;
            const Point3 doubled = doubled_area(surface.corners, rings[face]);
            kept += sign * length_of(doubled);
            volume += sign * dot(doubled, surface.corners[rings[face][0]] - surface.corners[rings[first][0]]);
            for (const auto& [other, agree] : neighbours[face]) {
                if (turned[other] >= 0) continue;
                turned[other] = agree ? turned[face] : 1 - turned[face];
                group.push_back(other);
            }
        }
        if (closed ? volume < 0 : kept < 0)
            for (const std::uint32_t face : group) turned[face] = 1 - turned[face];
    }
    for (std::size_t i = 0; i < shell.size(); ++i)
        if (turned[i] == 1) std::reverse(surface.faces[shell[i]].begin(), surface.faces[shell[i]].end());
}

}  // namespace tactics
