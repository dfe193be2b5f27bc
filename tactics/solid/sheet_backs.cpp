// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/sheet_backs.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>
#include <utility>

#include "tactics/geometry/lots.h"

namespace tactics {

namespace {

constexpr double kSameExtent = 1e-3;     // of two planes with one border
constexpr std::size_t kMostAtEdge = 16;  // faces; where more meet, no plane goes on

// Faces of one plane that hang together.
struct SheetPiece {
    Point3 area;
    std::vector<std::uint32_t> faces;
    std::vector<FaceSide> border;
};

std::vector<SheetPiece> pieces_of(const WeldedSurface& surface, const std::vector<Point3>& areas,
                                  const std::vector<FaceSide>& sides, const std::vector<SolidOfFace>& solid) {
    Lots lots(surface.faces.size());
    const auto each_pair = [](std::span<const FaceSide> edge, auto take) {
        if (edge.size() > kMostAtEdge) return;
        for (const FaceSide& one : edge)
            for (const FaceSide& other : edge)
                if (one.from == other.to) take(one, other);
    };
    each_edge(sides, [&](std::span<const FaceSide> edge) {
        each_pair(edge, [&](const FaceSide& one, const FaceSide& other) {
            if (solid[one.face].own == solid[other.face].own && go_one_way(areas[one.face], areas[other.face]))
                lots.join(one.face, other.face);
        });
    });
    std::vector<SheetPiece> pieces;
    std::vector<std::size_t> piece(surface.faces.size());
    std::unordered_map<std::uint32_t, std::size_t> place;
    for (std::uint32_t face = 0; face < surface.faces.size(); ++face) {
        const auto [found, fresh] = place.emplace(lots.find(face), pieces.size());
        if (fresh) pieces.emplace_back();
        piece[face] = found->second;
        pieces[piece[face]].area = pieces[piece[face]].area + areas[face];
        pieces[piece[face]].faces.push_back(face);
    }
    each_edge(sides, [&](std::span<const FaceSide> edge) {
        std::vector<std::size_t> inside;
        each_pair(edge, [&](const FaceSide& one, const FaceSide& other) {
            if (piece[one.face] == piece[other.face]) inside.push_back(piece[one.face]);
        });
        for (const FaceSide& one : edge)
            if (std::find(inside.begin(), inside.end(), piece[one.face]) == inside.end())
                pieces[piece[one.face]].border.push_back(one);
    });
    return pieces;
}

// Where its border turns or branches, in order.
std::vector<std::uint32_t> corners_of(const SheetPiece& piece, const WeldedSurface& surface) {
    std::map<std::uint32_t, std::vector<Point3>> ways;  // of the sides that begin and end there
    for (const FaceSide& side : piece.border) {
        const Point3 way = surface.corners[side.to] - surface.corners[side.from];
        ways[side.from].push_back(way);
        ways[side.to].push_back(way);
    }
    std::vector<std::uint32_t> corners;
    for (const auto& [corner, there] : ways)
        if (there.size() != 2 || !go_one_way(there[0], there[1])) corners.push_back(corner);
    return corners;
}

enum class Stays : std::uint8_t { one, other, both };

class Backs {
public:
    Backs(const WeldedSurface& surface, const std::vector<Point3>& areas, const std::vector<SolidOfFace>& solid)
        : surface_(surface), areas_(areas), solid_(solid), gone_(areas.size(), 0) {}

    void find_pieces(const std::vector<FaceSide>& sides) {
        const std::vector<SheetPiece> pieces = pieces_of(surface_, areas_, sides, solid_);
        std::map<std::vector<std::uint32_t>, std::size_t> seen;
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            const SheetPiece& one = pieces[i];
            const auto [place, fresh] = seen.emplace(corners_of(one, surface_), i);
            if (fresh || place->first.size() < 3) continue;
            const SheetPiece& other = pieces[place->second];
            if (std::abs(length_of(one.area) - length_of(other.area)) > kSameExtent * length_of(one.area)) continue;
            if (!are_backs(one.area, other.area)) continue;
            const Stays stays = of_two(one.faces.front(), other.faces.front());
            if (stays == Stays::both) continue;
            for (const std::uint32_t face : (stays == Stays::other ? one : other).faces) gone_[face] = 1;
            if (stays == Stays::one) place->second = i;
        }
    }

    // Of planes of which only a part is there twice.
    void find_faces() {
        std::map<CornerRing, std::uint32_t> seen;
        for (std::uint32_t face = 0; face < surface_.faces.size(); ++face) {
            if (surface_.faces[face].empty()) gone_[face] = 1;
            if (gone_[face] != 0) continue;
            CornerRing sorted = surface_.faces[face];
            std::sort(sorted.begin(), sorted.end());
            const auto [place, fresh] = seen.emplace(std::move(sorted), face);
            if (fresh) continue;
            const Stays stays = of_two(face, place->second);
            if (stays == Stays::both) continue;
            gone_[stays == Stays::other ? face : place->second] = 1;
            if (stays == Stays::one) place->second = face;
        }
    }

    const std::vector<char>& gone() const { return gone_; }

private:
    Stays of_two(std::uint32_t one, std::uint32_t other) const {
        const std::uint32_t its = solid_[one].joined, of_other = solid_[other].joined;
        if (its != of_other && its != kNoSolid && of_other != kNoSolid) return Stays::both;
        if (its != of_other) return of_other == kNoSolid ? Stays::one : Stays::other;
        return looks_at_reader(areas_[other]) ? Stays::other : Stays::one;
    }

    const WeldedSurface& surface_;
    const std::vector<Point3>& areas_;
    const std::vector<SolidOfFace>& solid_;
    std::vector<char> gone_;
};

}  // namespace

bool looks_at_reader(const Point3& area) {
    const Point3 way = unit(area);
    for (const double one : {way.z, -way.y, way.x})
        if (std::abs(one) > 1e-3) return one > 0;
    return true;
}

bool are_backs(const Point3& one, const Point3& other) { return go_one_way(one, -1 * other); }

std::size_t drop_backs(WeldedSurface& surface, std::vector<SolidOfFace>& solid) {
    const std::vector<FaceSide> sides = sides_of(surface.faces);
    const std::vector<Point3> areas = doubled_areas(surface);
    bool any = false;
    each_edge(sides, [&](std::span<const FaceSide> edge) {
        any = any || edge.size() > 2 || (edge.size() == 2 && are_backs(areas[edge[0].face], areas[edge[1].face]));
    });
    if (!any) return 0;
    Backs backs(surface, areas, solid);
    backs.find_pieces(sides);
    backs.find_faces();
    const std::size_t before = surface.faces.size();
    std::size_t kept = 0;
    for (std::size_t face = 0; face < before; ++face) {
        if (backs.gone()[face] != 0) continue;
        std::swap(surface.faces[kept], surface.faces[face]);
        solid[kept++] = solid[face];
    }
    surface.faces.resize(kept);
    solid.resize(kept);
    return before - kept;
}

}  // namespace tactics
