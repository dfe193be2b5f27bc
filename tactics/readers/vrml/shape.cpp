// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/vrml/shape.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <unordered_map>

namespace tactics {

namespace {

using Places = std::vector<std::uint32_t>;

Point3 on_circle(std::size_t i, double radius, double y) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(kRoundSides);
    // Counter-clockwise for who looks from above, against y: from x towards -z.
    return {radius * std::cos(angle), y, -radius * std::sin(angle)};
}

// A ring of vertices from `first` on, looking upwards or downwards.
void add_disc(WorldShape& shape, std::uint32_t first, bool upwards) {
    Places ring;
    for (std::uint32_t i = 0; i < kRoundSides; ++i) ring.push_back(first + i);
    if (!upwards) std::reverse(ring.begin(), ring.end());
    shape.add_face(ring);
}

// Corners on one line have none but for rounding.
bool has_area(const WorldShape& shape, std::span<const std::uint32_t> corners) {
    Point3 twice;
    double squares = 0;
    const Point3& first = shape.vertices[corners[0]];
    for (std::size_t i = 2; i < corners.size(); ++i) {
        const Point3 a = shape.vertices[corners[i - 1]] - first, b = shape.vertices[corners[i]] - first;
        twice = twice + cross(a, b);
        squares += dot(a, a) + dot(b, b);
    }
    constexpr double kRounding = 1e-14;
    return length_of(twice) > kRounding * squares;
}

}  // namespace

void WorldShape::add_face(std::span<const std::uint32_t> places) {
    const std::size_t first = corners.size();
    for (const std::uint32_t at : places)
        if (corners.size() == first || corners.back() != at) corners.push_back(at);
    while (corners.size() > first + 1 && corners.back() == corners[first]) corners.pop_back();
    const std::size_t count = corners.size() - first;
    if (count < 3 || !has_area(*this, std::span(corners).subspan(first))) {
        corners.resize(first);
        ++bad_faces;
        return;
    }
    faces.push_back({index32(first), index32(count)});
}

void WorldShape::turn_inside_out() {
    for (const ModelFace& face : faces) {
        const auto first = corners.begin() + face.first;
        std::reverse(first, first + face.count);
    }
}

WorldShape make_box(const Point3& size) {
    WorldShape shape;
    const Point3 half = 0.5 * size;
    for (const double y : {-half.y, half.y})
        for (const double z : {half.z, -half.z})
            for (const double x : {-half.x, half.x}) shape.vertices.push_back({x, y, z});
    // 0 to 3 below, 4 to 7 above: front left, front right, back left, back right
    for (const auto& side :
         {Places{0, 1, 5, 4}, Places{1, 3, 7, 5}, Places{3, 2, 6, 7}, Places{2, 0, 4, 6}, Places{4, 5, 7, 6}, Places{2, 3, 1, 0}})
        shape.add_face(side);
    if (!(size.x > 0 && size.y > 0 && size.z > 0)) {
        // A sheet: of its two faces, which are in one place, one.
        shape.faces.resize(std::min<std::size_t>(shape.faces.size(), 1));
        shape.corners.resize(shape.faces.empty() ? 0 : shape.faces[0].count);
        shape.bad_faces = 0;
        shape.one_sided = false;
        return shape;
    }
    shape.primitive = Primitive::box;
    shape.frame = {{}, {half.x, 0, 0}, {0, 0, -half.z}, {0, half.y, 0}};
    return shape;
}

WorldShape make_sphere(double radius) {
    WorldShape shape;
    constexpr std::size_t kRings = kRoundSides / 2;  // from pole to pole
    for (std::size_t ring = 1; ring < kRings; ++ring) {
        const double up = std::numbers::pi * (static_cast<double>(ring) / kRings - 0.5);
        for (std::size_t i = 0; i < kRoundSides; ++i)
            shape.vertices.push_back(on_circle(i, radius * std::cos(up), radius * std::sin(up)));
    }
    const std::uint32_t south = index32(shape.vertices.size()), north = south + 1;
    shape.vertices.push_back({0, -radius, 0});
    shape.vertices.push_back({0, radius, 0});
    for (std::uint32_t i = 0; i < kRoundSides; ++i) {
        const std::uint32_t next = (i + 1) % kRoundSides;
        shape.add_face({south, next, i});
        for (std::uint32_t ring = 0; ring + 2 < kRings; ++ring) {
            const std::uint32_t low = index32(ring * kRoundSides), high = index32((ring + 1) * kRoundSides);
            shape.add_face({low + i, low + next, high + next, high + i});
        }
        const std::uint32_t last = index32((kRings - 2) * kRoundSides);
        shape.add_face({last + i, last + next, north});
    }
    shape.primitive = Primitive::sphere;
    shape.frame = {{}, {radius, 0, 0}, {0, 0, -radius}, {0, radius, 0}};
    return shape;
}

WorldShape make_cylinder(double radius, double height, RoundParts parts) {
    WorldShape shape;
    for (const double y : {-height / 2, height / 2})
        for (std::size_t i = 0; i < kRoundSides; ++i) shape.vertices.push_back(on_circle(i, radius, y));
    for (std::uint32_t i = 0; parts.side && i < kRoundSides; ++i) {
        const std::uint32_t next = (i + 1) % kRoundSides;
        shape.add_face({i, next, index32(kRoundSides) + next, index32(kRoundSides) + i});
    }
    if (parts.top) add_disc(shape, index32(kRoundSides), true);
    if (parts.bottom) add_disc(shape, 0, false);
    shape.primitive = Primitive::cylinder;
    shape.frame = {{}, {radius, 0, 0}, {0, 0, -radius}, {0, height / 2, 0}};
    shape.one_sided = parts.side && parts.bottom && parts.top;
    return shape;
}

WorldShape make_cone(double radius, double height, RoundParts parts) {
    WorldShape shape;
    for (std::size_t i = 0; i < kRoundSides; ++i) shape.vertices.push_back(on_circle(i, radius, -height / 2));
    shape.vertices.push_back({0, height / 2, 0});
    for (std::uint32_t i = 0; parts.side && i < kRoundSides; ++i)
        shape.add_face({i, static_cast<std::uint32_t>((i + 1) % kRoundSides), index32(kRoundSides)});
    if (parts.bottom) add_disc(shape, 0, false);
    shape.primitive = Primitive::cone;
    shape.frame = {{}, {radius, 0, 0}, {0, 0, -radius}, {0, height / 2, 0}};
    shape.one_sided = parts.side && parts.bottom;
    return shape;
}

std::vector<double> faces_in(std::span<const double> indices, FaceRuns runs) {
    std::vector<double> faces;
    const auto add = [&](std::initializer_list<double> face) {
        faces.insert(faces.end(), face);
        faces.push_back(-1);
    };
    if (runs == FaceRuns::triangles)
        for (std::size_t i = 0; i + 3 <= indices.size(); i += 3) add({indices[i], indices[i + 1], indices[i + 2]});
    if (runs == FaceRuns::quads)
        for (std::size_t i = 0; i + 4 <= indices.size(); i += 4)
            add({indices[i], indices[i + 1], indices[i + 2], indices[i + 3]});
    if (runs != FaceRuns::strips && runs != FaceRuns::fans) return faces;
    std::size_t first = 0;  // of the run
    for (std::size_t i = 0; i < indices.size(); ++i) {
        if (indices[i] < 0) {
            first = i + 1;
        } else if (i >= first + 2) {
            const bool odd = runs == FaceRuns::strips && (i - first) % 2 == 1;
            const double a = runs == FaceRuns::fans ? indices[first] : indices[i - 2], b = indices[i - 1];
            if (odd)
                add({b, a, indices[i]});
            else
                add({a, b, indices[i]});
        }
    }
    return faces;
}

WorldShape make_faces(std::span<const double> points, std::span<const double> indices) {
    WorldShape shape;
    const std::size_t count = points.size() / 3;
    const auto point = [&](std::size_t i) { return Point3{points[3 * i], points[3 * i + 1], points[3 * i + 2]}; };
    // Several shapes may share one long list of points, and each needs few of them.
    const bool few = indices.size() < count / 4;
    std::unordered_map<std::size_t, std::uint32_t> kept;
    if (!few)
        for (std::size_t i = 0; i < count; ++i) shape.vertices.push_back(point(i));
    Places face;
    bool whole = true;
    const auto end_face = [&] {
        if (whole && !face.empty()) shape.add_face(face);
        if (!whole) ++shape.bad_faces;
        face.clear();
        whole = true;
    };
    for (const double index : indices) {
        if (index < 0) {
            end_face();
        } else if (!(index < static_cast<double>(count))) {
            whole = false;
        } else {
            const auto at = static_cast<std::size_t>(index);
            if (few) {
                const auto [found, fresh] = kept.try_emplace(at, index32(shape.vertices.size()));
                if (fresh) shape.vertices.push_back(point(at));
                face.push_back(found->second);
            } else {
                face.push_back(index32(at));
            }
        }
    }
    end_face();
    return shape;
}

}  // namespace tactics
