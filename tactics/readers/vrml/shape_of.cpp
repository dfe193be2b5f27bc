// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/vrml/shape_of.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>

namespace tactics {

namespace {

using namespace std::string_view_literals;

using Make = std::optional<WorldShape> (*)(ResolvedWorld& world, const WorldPlace& at, ModelMaker& maker);

std::optional<WorldShape> box(ResolvedWorld& world, const WorldPlace& at, ModelMaker& maker) {
    const Point3 size = world.point(at, "size", {2, 2, 2});
    if (!maker.has_sides("Box", at.node->line, size)) return std::nullopt;
    WorldShape shape = make_box(size);
    shape.one_sided = shape.one_sided && world.flag(at, "solid", true);
    return shape;
}

std::optional<WorldShape> sphere(ResolvedWorld& world, const WorldPlace& at, ModelMaker& maker) {
    const double radius = world.number(at, "radius", 1);
    if (!maker.has_size("Sphere", at.node->line, {radius})) return std::nullopt;
    WorldShape shape = make_sphere(radius);
    shape.one_sided = world.flag(at, "solid", true);
    return shape;
}

RoundParts parts_of(const ResolvedWorld& world, const WorldPlace& at) {
    return {world.flag(at, "side", true), world.flag(at, "bottom", true), world.flag(at, "top", true)};
}

std::optional<WorldShape> cylinder(ResolvedWorld& world, const WorldPlace& at, ModelMaker& maker) {
    const double radius = world.number(at, "radius", 1), height = world.number(at, "height", 2);
    if (!maker.has_size("Cylinder", at.node->line, {radius, height})) return std::nullopt;
    WorldShape shape = make_cylinder(radius, height, parts_of(world, at));
    shape.one_sided = shape.one_sided && world.flag(at, "solid", true);
    return shape;
}

std::optional<WorldShape> cone(ResolvedWorld& world, const WorldPlace& at, ModelMaker& maker) {
    const double radius = world.number(at, "bottomRadius", 1), height = world.number(at, "height", 2);
    if (!maker.has_size("Cone", at.node->line, {radius, height})) return std::nullopt;
    WorldShape shape = make_cone(radius, height, parts_of(world, at));
    shape.one_sided = shape.one_sided && world.flag(at, "solid", true);
    return shape;
}

// Properties of all shapes made of single faces: which side is outside, and whether there is one.
void set_sides(const ResolvedWorld& world, const WorldPlace& at, WorldShape& shape) {
    if (!world.flag(at, "ccw", true)) shape.turn_inside_out();
    shape.one_sided = shape.one_sided && world.flag(at, "solid", true);
}

std::span<const double> points_of(ResolvedWorld& world, const WorldPlace& at, ModelMaker& maker) {
    const auto coordinates = world.node(at, "coord");
    if (!coordinates) return {};
    if (coordinates->node->type != "Coordinate" && coordinates->node->type != "CoordinateDouble") {
        maker.leave_out("points as " + coordinates->node->type, coordinates->node->line);
        return {};
    }
    return world.numbers(*coordinates, "point");
}

std::optional<WorldShape> indexed(ResolvedWorld& world, const WorldPlace& at, ModelMaker& maker, std::string_view field,
                                  FaceRuns runs) {
    const std::span<const double> points = points_of(world, at, maker), indices = world.numbers(at, field);
    maker.spend(10 * indices.size() + points.size(), at.node->line);
    WorldShape shape = runs == FaceRuns::polygons ? make_faces(points, indices) : make_faces(points, faces_in(indices, runs));
    set_sides(world, at, shape);
    return shape;
}

template <FaceRuns runs>
std::optional<WorldShape> indexed_as(ResolvedWorld& world, const WorldPlace& at, ModelMaker& maker) {
    return indexed(world, at, maker, runs == FaceRuns::polygons ? "coordIndex" : "index", runs);
}

// Points one after another, in runs of which `counts` tells how long each is.
std::optional<WorldShape> in_order(ResolvedWorld& world, const WorldPlace& at, ModelMaker& maker, FaceRuns runs,
                                   std::string_view counts) {
    const std::span<const double> points = points_of(world, at, maker);
    maker.spend(10 * points.size(), at.node->line);
    std::vector<double> indices;
    const auto take = [&](double count) {
        for (; count >= 1 && indices.size() < 2 * points.size(); --count) indices.push_back(0);
    };
    if (counts.empty())
        take(static_cast<double>(points.size() / 3));
    else
        for (const double count : world.numbers(at, counts)) {
            take(count);
            indices.push_back(-1);
        }
    double next = 0;
    for (double& index : indices)
        if (index >= 0) index = next++;
    WorldShape shape = make_faces(points, faces_in(indices, runs));
    set_sides(world, at, shape);
    return shape;
}

std::optional<WorldShape> triangle_set(ResolvedWorld& world, const WorldPlace& at, ModelMaker& maker) {
    return in_order(world, at, maker, FaceRuns::triangles, "");
}
std::optional<WorldShape> quad_set(ResolvedWorld& world, const WorldPlace& at, ModelMaker& maker) {
    return in_order(world, at, maker, FaceRuns::quads, "");
}
std::optional<WorldShape> strip_set(ResolvedWorld& world, const WorldPlace& at, ModelMaker& maker) {
    return in_order(world, at, maker, FaceRuns::strips, "stripCount");
}
std::optional<WorldShape> fan_set(ResolvedWorld& world, const WorldPlace& at, ModelMaker& maker) {
    return in_order(world, at, maker, FaceRuns::fans, "fanCount");
}

std::size_t count_in(const ResolvedWorld& world, const WorldPlace& at, std::string_view field) {
    const double count = world.number(at, field, 0);
    return count >= 2 && count <= static_cast<double>(kMostWorldNumbers) ? static_cast<std::size_t>(count) : 0;
}

std::optional<WorldShape> elevation(ResolvedWorld& world, const WorldPlace& at, ModelMaker& maker) {
    ElevationFields fields;
    fields.across = count_in(world, at, "xDimension");
    fields.along = count_in(world, at, "zDimension");
    fields.across_step = world.number(at, "xSpacing", 1);
    fields.along_step = world.number(at, "zSpacing", 1);
    fields.heights = world.numbers(at, "height");
    if (fields.across * fields.along != fields.heights.size())
        maker.fail(at.node->line,
                   phrase("ElevationGrid has {0} heights for {1} x {2} places; save the model again",
                          std::to_string(fields.heights.size()), std::to_string(fields.across), std::to_string(fields.along)));
    maker.spend(10 * fields.heights.size(), at.node->line);
    WorldShape shape = make_elevation(fields);
    set_sides(world, at, shape);
    return shape;
}

std::optional<WorldShape> extrusion(ResolvedWorld& world, const WorldPlace& at, ModelMaker& maker) {
    static constexpr std::array kSquare{1.0, 1.0, 1.0, -1.0, -1.0, -1.0, -1.0, 1.0, 1.0, 1.0};
    static constexpr std::array kUpwards{0.0, 0.0, 0.0, 0.0, 1.0, 0.0};
    ExtrusionFields fields;
    const auto given = [&](std::string_view field, std::span<const double> otherwise) {
        return world.find(at, field).value == nullptr ? otherwise : world.numbers(at, field);
    };
    fields.section = given("crossSection", kSquare);
    fields.spine = given("spine", kUpwards);
    fields.scales = world.numbers(at, "scale");
    std::vector<double> turns(world.numbers(at, "orientation").begin(), world.numbers(at, "orientation").end());
    for (std::size_t i = 3; i < turns.size(); i += 4) turns[i] *= world.world().radian;
    fields.orientations = turns;
    fields.begin_cap = world.flag(at, "beginCap", true);
    fields.end_cap = world.flag(at, "endCap", true);
    const std::size_t quads = fields.section.size() / 2 * (fields.spine.size() / 3);
    if (quads > kMostModelCorners / 4)
        maker.fail(at.node->line,
                   phrase("Extrusion has over {0} faces; save a coarser model", std::to_string(kMostModelCorners / 4)));
    maker.spend(10 * quads, at.node->line);
    WorldShape shape = make_extrusion(fields);
    set_sides(world, at, shape);
    return shape;
}

// X3D's flat ones stand upright, with their front towards who looks.
WorldShape of_rings(std::span<const double> flat, std::span<const double> places) {
    std::vector<double> points;
    for (std::size_t i = 0; i + 2 <= flat.size(); i += 2) points.insert(points.end(), {flat[i], flat[i + 1], 0});
    return make_faces(points, places);
}

std::optional<WorldShape> rectangle(ResolvedWorld& world, const WorldPlace& at, ModelMaker& maker) {
    const std::span<const double> size = world.numbers(at, "size");
    const double x = size.size() < 2 ? 1 : size[0] / 2, y = size.size() < 2 ? 1 : size[1] / 2;
    if (!maker.has_size("Rectangle2D", at.node->line, {x, y})) return std::nullopt;
    WorldShape shape = of_rings(std::array{-x, -y, x, -y, x, y, -x, y}, std::array{0.0, 1.0, 2.0, 3.0});
    shape.one_sided = world.flag(at, "solid", false);
    return shape;
}

std::optional<WorldShape> disk(ResolvedWorld& world, const WorldPlace& at, ModelMaker& maker) {
    const double inner = world.number(at, "innerRadius", 0), outer = world.number(at, "outerRadius", 1);
    if (!maker.has_size("Disk2D", at.node->line, {outer, outer - inner})) return std::nullopt;
    std::vector<double> points, places;
    for (const double radius : {outer, inner})
        for (std::size_t i = 0; i < kRoundSides; ++i) {
            const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(kRoundSides);
            points.insert(points.end(), {radius * std::cos(angle), radius * std::sin(angle)});
        }
    for (std::size_t i = 0; i < kRoundSides; ++i) {
        const double here = static_cast<double>(i), next = static_cast<double>((i + 1) % kRoundSides);
        if (inner > 0)
            places.insert(places.end(), {here, next, next + kRoundSides, here + kRoundSides, -1});
        else
            places.push_back(here);
    }
    WorldShape shape = of_rings(points, places);
    shape.one_sided = world.flag(at, "solid", false);
    return shape;
}

std::optional<WorldShape> flat_triangles(ResolvedWorld& world, const WorldPlace& at, ModelMaker& maker) {
    const std::span<const double> flat = world.numbers(at, "vertices");
    maker.spend(10 * flat.size(), at.node->line);
    std::vector<double> places(flat.size() / 2);
    std::iota(places.begin(), places.end(), 0.0);
    WorldShape shape = of_rings(flat, faces_in(places, FaceRuns::triangles));
    shape.one_sided = world.flag(at, "solid", false);
    return shape;
}

struct Geometry {
    std::string_view type;
    Make make;
};
constexpr Geometry kGeometry[] = {
    {"Box", box},
    {"Sphere", sphere},
    {"Cylinder", cylinder},
    {"Cone", cone},
    {"IndexedFaceSet", indexed_as<FaceRuns::polygons>},
    {"IndexedTriangleSet", indexed_as<FaceRuns::triangles>},
    {"IndexedTriangleStripSet", indexed_as<FaceRuns::strips>},
    {"IndexedTriangleFanSet", indexed_as<FaceRuns::fans>},
    {"IndexedQuadSet", indexed_as<FaceRuns::quads>},
    {"TriangleSet", triangle_set},
    {"QuadSet", quad_set},
    {"TriangleStripSet", strip_set},
    {"TriangleFanSet", fan_set},
    {"ElevationGrid", elevation},
    {"Extrusion", extrusion},
    {"Rectangle2D", rectangle},
    {"Disk2D", disk},
    {"TriangleSet2D", flat_triangles},
};

}  // namespace

std::optional<WorldShape> shape_of(ResolvedWorld& world, const WorldPlace& at, ModelMaker& maker) {
    const std::string& type = at.node->type;
    const auto known =
        std::find_if(std::begin(kGeometry), std::end(kGeometry), [&](const Geometry& one) { return one.type == type; });
    if (known != std::end(kGeometry)) return known->make(world, at, maker);
    constexpr std::array kLines{"IndexedLineSet"sv, "LineSet"sv,    "PointSet"sv,   "Arc2D"sv,
                                "Circle2D"sv,       "Polyline2D"sv, "Polypoint2D"sv};
    const bool lines = std::find(kLines.begin(), kLines.end(), type) != kLines.end();
    maker.leave_out(type + (lines            ? ", which has no faces"
                            : type == "Text" ? ""
                                             : ", a geometry that is not known here"),
                    at.node->line);
    return std::nullopt;
}

}  // namespace tactics
