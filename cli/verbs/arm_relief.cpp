// SPDX-License-Identifier: Apache-2.0
#include "cli/verbs/arm_relief.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cli/verbs/map_plot.h"
#include "cli/verbs/play_arm_flags.h"
#include "cli/verbs/play_frame.h"
#include "tactics/error.h"
#include "tactics/haptics/scenes/relief_space_scene.h"

namespace tactics {

namespace {

struct Heights {
    double lowest = INFINITY, highest = -INFINITY;
};
// Of the known samples; 0 if there are none.
Heights heights_of(const HeightMap& map) {
    Heights heights;
    for (const float height : map.heights) {
        if (!std::isfinite(height)) continue;
        heights.lowest = std::min(heights.lowest, static_cast<double>(height));
        heights.highest = std::max(heights.highest, static_cast<double>(height));
    }
    return heights.lowest <= heights.highest ? heights : Heights{0, 0};
}

// Shifted to start at 0 and scaled; holes stay holes.
void lift(HeightMap& map, double lowest, double scale) {
    map.pitch *= scale;
    for (float& height : map.heights)
        if (std::isfinite(height)) height = static_cast<float>((static_cast<double>(height) - lowest) * scale);
}

// The highest sample of each square of that many samples: for a finger that is much larger than a square.
HeightMap tops_of(const HeightMap& map, int block) {
    const auto blocks = [&](int count) { return (count + block - 1) / block; };
    HeightMap tops{blocks(map.columns), blocks(map.rows), map.pitch * block, {}};
    tops.heights.assign(static_cast<std::size_t>(tops.columns) * static_cast<std::size_t>(tops.rows), NAN);
    for (int row = 0; row < map.rows; ++row)
        for (int column = 0; column < map.columns; ++column) {
            float& top = tops.at(column / block, row / block);
            if (const float height = map.at(column, row); !(top >= height) && std::isfinite(height)) top = height;
        }
    return tops;
}

// As felt by a fingertip. Samples closer than a twentieth of its radius only cost time, which grows with the fourth power of
// their number along a side.
HeightMap met_by(HeightMap map, double radius) {
    constexpr double kFiner = 20;
    if (!(radius > 0)) return map;
    const int block = static_cast<int>(std::min(radius / kFiner / map.pitch, 10'000.0));
    if (block > 1) map = tops_of(map, block);
    return dilated(map, radius);
}

// The lines of a drawing, upwards, in its mm; one curve with gaps.
PlotCurve lines_of(const Page& page) {
    PlotCurve lines{"lines", {}};
    const auto add = [&](const std::vector<Point>& points, bool closed) {
        if (!lines.points.empty()) lines.gaps.push_back(lines.points.size());
        for (const Point& at : points) lines.points.push_back({at.x, page.height - at.y});
        if (closed) lines.points.push_back({points.front().x, page.height - points.front().y});
    };
    for (const PageStroke& stroke : page.strokes) add(stroke.points, stroke.closed);
    for (const Area& area : page.areas)
        for (const auto& ring : area.rings) add(ring, true);
    return lines;
}

FittedBox fitted_relief(const Given& given, const ArmSettings& arm, const Point3& size, bool drawn) {
    if (const auto named = plane_of(given)) return fit_box(*named, arm, size, 0);
    if (drawn) return fit_box(kUpright, arm, size, 0);
    const FittedBox flat = fit_box(kFlat, arm, size, 0);
    if (flat.scale >= 1) return flat;
    const FittedBox upright = fit_box(kUpright, arm, size, 0);
    return upright.scale > flat.scale ? upright : flat;
}

}  // namespace

void take_arm_as_paper(Wishes& drawing, const Given& given, const ArmFile& file) {
    const Point most = most_of_plane(plane_of(given).value_or(kUpright), file.arm);
    check_field(most);
    drawing.paper = {"", "", std::min(most.x, most.y), std::max(most.x, most.y)};
    drawing.sheet.orientation = most.x > most.y ? Orientation::landscape : Orientation::portrait;
}

ArmScene relief_on_arm(FeltHeights felt, double radius, const Given& given, const ArmFile& file, std::vector<Phrase>& told) {
    HeightMap& map = felt.file.map;
    const Heights heights = heights_of(map);
    const Point3 size{map.width(), map.height(), heights.highest - heights.lowest};
    const FittedBox box = fitted_relief(given, file.arm, size, felt.drawn.has_value());
    const double scale = std::min(box.scale, 1.0);
    if (scale < 1) told.push_back(told_scale(size, scale));
    if (std::max(size.x, size.y) * scale < std::min(kLeastField, std::max(size.x, size.y)))
        throw Error(
            Fault::usage, "--plane",
            phrase("so high a map leaves less than 30 mm of its sides in the workspace; give it other heights with --low and "
                   "--high, or take another plane"));
    ArmScene scene{plot_of_map(map, kMostSamples),
                   frame_of_box({0, 0, heights.lowest}, {size.x, size.y, heights.highest}, scale),
                   mounting_of(box, scale * size, 0),
                   arm_law_of(given, file, 1),
                   std::max(file.arm.resolution, 0.01),
                   {},
                   true};
    // Contours of lines that are a millimetre wide are no picture of them.
    if (felt.drawn) {
        scene.plot.surfaces.clear();
        scene.plot.curves.push_back(lines_of(felt.drawn->layouts.front().shown.front()));
    }
    lift(map, heights.lowest, scale);
    scene.relief = std::make_unique<const ReliefSurface>(met_by(std::move(map), radius));
    scene.scene = std::make_unique<ReliefSpaceScene>(*scene.relief, scene.law);
    return scene;
}

}  // namespace tactics
