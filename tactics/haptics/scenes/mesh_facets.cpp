// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/scenes/mesh_facets.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <stdexcept>

namespace tactics {

namespace {

std::uint64_t mixed(std::uint64_t a, std::uint64_t b) {
    a = (a ^ b) * 0x9E3779B97F4A7C15u;
    return a ^ a >> 29;
}

// Of things that are told by number: which one is the first of its like.
template <typename Hash, typename Same>
class FirstOfLike {
public:
    FirstOfLike(std::size_t most, Hash hash, Same same)
        : hash_(hash), same_(same), slots_(std::bit_ceil(2 * most + 2), kFree), mask_(slots_.size() - 1) {}
    std::uint32_t find(std::uint32_t number) {
        std::size_t at = hash_(number) & mask_;
        while (slots_[at] != kFree && !same_(slots_[at], number)) at = (at + 1) & mask_;
        if (slots_[at] == kFree) slots_[at] = number;
        return slots_[at];
    }

private:
    static constexpr std::uint32_t kFree = UINT32_MAX;
    Hash hash_;
    Same same_;
    std::vector<std::uint32_t> slots_;
    std::size_t mask_;
};

void check(const Mesh& mesh) {
    if (mesh.vertices.size() > kMostMeshVertices || mesh.triangles.size() > kMostMeshTriangles)
        throw std::logic_error("mesh: more than it may have");
    for (const Point3& vertex : mesh.vertices)
        if (!is_finite(vertex)) throw std::logic_error("mesh: a vertex that is not finite");
    for (const auto& triangle : mesh.triangles)
        for (const std::uint32_t vertex : triangle)
            if (vertex >= mesh.vertices.size()) throw std::logic_error("mesh: a vertex that is not there");
}

// For each vertex the first in the same place.
std::vector<std::uint32_t> first_in_place(const std::vector<Point3>& vertices) {
    const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value + 0.0); };  // -0 is 0
    const auto hash = [&](std::uint32_t i) {
        return mixed(mixed(mixed(0, bits(vertices[i].x)), bits(vertices[i].y)), bits(vertices[i].z));
    };
    FirstOfLike seen(vertices.size(), hash, [&](std::uint32_t a, std::uint32_t b) { return vertices[a] == vertices[b]; });
    std::vector<std::uint32_t> first(vertices.size());
    for (std::uint32_t i = 0; i < first.size(); ++i) first[i] = seen.find(i);
    return first;
}

bool is_narrow(const Point3& a, const Point3& b, const Point3& c) {
    const double longest = std::max({length_of(b - a), length_of(c - b), length_of(a - c)});
    return !(length_of(cross(b - a, c - a)) >= kLeastFacet * longest) || longest <= 0;
}

// An edge's facets stand beside one another when sorted: from the lower corner to the higher, and whether it is gone that way.
void count_edges(MeshFacets& made) {
    struct Edge {
        std::uint64_t corners;
        bool backwards;
    };
    std::vector<Edge> edges;
    edges.reserve(3 * made.facets.size());
    for (const auto& facet : made.facets)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint64_t a = facet[k], b = facet[(k + 1) % 3];
            edges.push_back({std::min(a, b) << 32 | std::max(a, b), a > b});
        }
    std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) { return a.corners < b.corners; });
    bool turned = false;
    for (std::size_t i = 0; i < edges.size();) {
        std::size_t end = i + 1;
        while (end < edges.size() && edges[end].corners == edges[i].corners) ++end;
        made.open_edges += end - i == 1 ? 1 : 0;
        made.crowded_edges += end - i > 2 ? 1 : 0;
        turned = turned || (end - i == 2 && edges[i].backwards == edges[i + 1].backwards);
        i = end;
    }
    made.closed = !made.facets.empty() && made.open_edges == 0 && made.crowded_edges == 0 && !turned;
}

}  // namespace

MeshFacets facets_of(const Mesh& mesh) {
    check(mesh);
    const std::vector<std::uint32_t> first = first_in_place(mesh.vertices);
    MeshFacets made;
    std::vector<std::array<std::uint32_t, 3>> sorted;
    made.facets.reserve(mesh.triangles.size());
    sorted.reserve(mesh.triangles.size());
    const auto hash = [&](std::uint32_t i) { return mixed(mixed(mixed(0, sorted[i][0]), sorted[i][1]), sorted[i][2]); };
    FirstOfLike seen(mesh.triangles.size(), hash, [&](std::uint32_t a, std::uint32_t b) { return sorted[a] == sorted[b]; });
    for (const auto& triangle : mesh.triangles) {
        const std::array<std::uint32_t, 3> facet{first[triangle[0]], first[triangle[1]], first[triangle[2]]};
        if (is_narrow(mesh.vertices[facet[0]], mesh.vertices[facet[1]], mesh.vertices[facet[2]])) {
            ++made.without_area;
            continue;
        }
        sorted.push_back(facet);
        std::sort(sorted.back().begin(), sorted.back().end());
        const auto number = static_cast<std::uint32_t>(sorted.size() - 1);
        if (seen.find(number) != number) {
            sorted.pop_back();
            ++made.twice;
        } else {
            made.facets.push_back(facet);
        }
    }
    // Only the corners that are used, in the order of their first use.
    constexpr std::uint32_t kUnused = UINT32_MAX;
    std::vector<std::uint32_t> place(mesh.vertices.size(), kUnused);
    for (auto& facet : made.facets)
        for (std::uint32_t& corner : facet) {
            if (place[corner] == kUnused) {
                place[corner] = static_cast<std::uint32_t>(made.corners.size());
                made.corners.push_back(mesh.vertices[corner]);
            }
            corner = place[corner];
        }
    count_edges(made);
    return made;
}

std::vector<Phrase> notes_on(const MeshFacets& facets) {
    std::vector<Phrase> notes;
    if (facets.without_area > 0)
        notes.push_back(
            phrases(facets.without_area, "left out: {0} triangle without an area", "left out: {0} triangles without an area"));
    if (facets.twice > 0)
        notes.push_back(
            phrases(facets.twice, "left out: {0} triangle that is there twice", "left out: {0} triangles that are there twice"));
    if (facets.crowded_edges > 0)
        notes.push_back(phrases(facets.crowded_edges, "three triangles or more meet at {0} edge: it is felt from all sides",
                                "three triangles or more meet at {0} edges: it is felt from all sides"));
    if (facets.open_edges > 0)
        notes.push_back(phrases(
            facets.open_edges,
            "it is no closed solid ({0} open edge): a finger can get behind its surface, which is felt from both sides",
            "it is no closed solid ({0} open edges): a finger can get behind its surface, which is felt from both sides"));
    return notes;
}

std::vector<Point3> corner_normals(const MeshFacets& facets) {
    std::vector<Point3> normals(facets.corners.size());
    for (const auto& facet : facets.facets) {
        const Point3 &a = facets.corners[facet[0]], &b = facets.corners[facet[1]], &c = facets.corners[facet[2]];
        const Point3 over = cross(b - a, c - a);
        const Point3 unit = (1 / length_of(over)) * over;
        for (std::size_t k = 0; k < 3; ++k) {
            const Point3& here = facets.corners[facet[k]];
            const Point3 one = facets.corners[facet[(k + 1) % 3]] - here, other = facets.corners[facet[(k + 2) % 3]] - here;
            normals[facet[k]] = normals[facet[k]] + std::atan2(length_of(cross(one, other)), dot(one, other)) * unit;
        }
    }
    for (Point3& normal : normals) {
        const double length = length_of(normal);
        normal = length > 1e-9 ? (1 / length) * normal : Point3{};
    }
    return normals;
}

}  // namespace tactics
