// SPDX-License-Identifier: Apache-2.0
#include "cli/verbs/arm_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "cli/verbs/map_plot.h"
#include "cli/verbs/play_arm_flags.h"
#include "cli/verbs/play_frame.h"
#include "cli/verbs/play_map.h"
#include "tactics/error.h"
#include "tactics/haptics/scenes/mesh_scene.h"
#include "tactics/relief/depth.h"
#include "tactics/units.h"

namespace tactics {

namespace {

struct Sides {
    Point3 low{INFINITY, INFINITY, INFINITY}, high{-INFINITY, -INFINITY, -INFINITY};
};
Sides sides_of(const Mesh& mesh) {
    Sides sides;
    for (const auto& triangle : mesh.triangles)
        for (const std::uint32_t corner : triangle) {
            const Point3& at = mesh.vertices[corner];
            sides.low = {std::min(sides.low.x, at.x), std::min(sides.low.y, at.y), std::min(sides.low.z, at.z)};
            sides.high = {std::max(sides.high.x, at.x), std::max(sides.high.y, at.y), std::max(sides.high.z, at.z)};
        }
    return sides;
}

// In the axes of a scene, y downwards, which turns each triangle over: its corners go round the other way.
Mesh placed(const Mesh& mesh, const Sides& sides, double scale) {
    Mesh made = mesh;
    for (Point3& at : made.vertices)
        at = {(at.x - sides.low.x) * scale, (sides.high.y - at.y) * scale, (at.z - sides.low.z) * scale};
    for (auto& triangle : made.triangles) std::swap(triangle[1], triangle[2]);
    return made;
}

// Seen from above; without a surface where it has no width or no depth.
Plot plot_of_model(const Mesh& mesh, const Point3& size, const std::string& name) {
    const double longer = std::max(size.x, size.y);
    if (!(std::min(size.x, size.y) > 0)) return plot_of_map({}, kMostSamples);
    const Triangles triangles = [&](const std::function<void(const Triangle&)>& take) {
        for (const auto& corners : mesh.triangles) {
            Triangle one;
            for (std::size_t i = 0; i < 3; ++i) {
                const Point3& at = mesh.vertices[corners[i]];
                one.corners[i] = {at.x, at.y, at.z};
            }
            take(one);
        }
    };
    return plot_of_map(depth_of(triangles, box_of(triangles), 1, longer / kMostSamples, name), kMostSamples);
}

// At each of some places across, the highest and the lowest of it: up there and back down here.
PlotCurve outline_across(const Mesh& mesh, const Sides& sides) {
    const double width = sides.high.x - sides.low.x, rounding = 1e-9 * width;
    PlotCurve outline{"outline", {}};
    if (!(width > 0)) {
        outline.points = {{0, 0}, {0, sides.high.z - sides.low.z}};
        return outline;
    }
    const double step = width / (kMostSamples - 1);
    std::vector<double> high(kMostSamples, -INFINITY), low(kMostSamples, INFINITY);
    const auto take = [&](Point3 from, Point3 to) {
        if (from.x > to.x) std::swap(from, to);
        const auto first = static_cast<std::size_t>(std::max(0.0, std::ceil((from.x - sides.low.x - rounding) / step)));
        for (std::size_t i = first; i < high.size(); ++i) {
            const double x = sides.low.x + static_cast<double>(i) * step;
            if (x > to.x + rounding) break;
            const double share = to.x > from.x ? std::clamp((x - from.x) / (to.x - from.x), 0.0, 1.0) : 0;
            for (const double z : {from.z + share * (to.z - from.z), to.x > from.x ? from.z + share * (to.z - from.z) : to.z}) {
                high[i] = std::max(high[i], z - sides.low.z);
                low[i] = std::min(low[i], z - sides.low.z);
            }
        }
    };
    for (const auto& corner : mesh.triangles)
        for (std::size_t k = 0; k < 3; ++k) take(mesh.vertices[corner[k]], mesh.vertices[corner[(k + 1) % 3]]);
    const auto add = [&](std::size_t i, double z) {
        if (std::isfinite(z)) outline.points.push_back({static_cast<double>(i) * step, z});
    };
    for (std::size_t i = 0; i < high.size(); ++i) add(i, high[i]);
    for (std::size_t i = low.size(); i-- > 0;) add(i, low[i]);
    if (!outline.points.empty()) outline.points.push_back(PlotPoint(outline.points.front()));
    return outline;
}

}  // namespace

ArmScene model_on_arm(const Mesh& mesh, const std::string& name, const Given& given, const ArmFile& file,
                      std::vector<Phrase>& told) {
    const Sides sides = sides_of(mesh);
    const Point3 size = sides.high - sides.low;
    const FittedBox box = fit_box(plane_of(given).value_or(kFlat), file.arm, size, 0.5);
    double scale = std::isfinite(box.scale) ? box.scale : 1;
    constexpr double kLeast = 10;  // mm
    if (std::isfinite(box.scale) && !(scale * std::max({size.x, size.y, size.z}) >= kLeast))
        throw Error(Fault::usage, "--plane",
                    phrase("the plane leaves less than 10 mm of the workspace for the model; take another"));
    if (const auto width = length_of(given, "--width")) {
        if (!(size.x > 0)) throw Error(Fault::usage, "--width", phrase("the model has none; leave it out"));
        scale = std::min(scale, *width / size.x);
    }
    told.push_back(told_scale(size, scale));
    const Point3 made = scale * size;
    ArmScene scene{plot_of_model(mesh, size, name),
                   frame_of_box({0, 0, 0}, size, scale),
                   mounting_of(box, made, 0.5),
                   arm_law_of(given, file, 1),
                   std::max(file.arm.resolution, 0.01),
                   {},
                   true};
    if (!(std::min(size.x, size.y) > 0)) scene.sheet = {{"outline", {{0, 0}, {size.x, size.y}}}, outline_across(mesh, sides)};
    std::vector<Phrase> left_out;
    scene.scene =
        scene_of(placed(mesh, sides, scale),
                 {.law = scene.law, .radius = radius_of(given).value_or(0), .resolution = scene.resolution}, name, left_out);
    told.insert(told.end(), left_out.begin(), left_out.end());
    return scene;
}

}  // namespace tactics
