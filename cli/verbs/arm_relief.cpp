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

constexpr int kShown = 250;  // samples of the longer side that charts and words look at

// From 0 upwards, and so many times as large; holes stay holes.
HeightMap lifted(const HeightMap& map, double lowest, double scale) {
    HeightMap made = map;
    made.pitch *= scale;
    for (float& height : made.heights)
        if (std::isfinite(height)) height = static_cast<float>((static_cast<double>(height) - lowest) * scale);
    return made;
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

ArmScene relief_on_arm(const FeltHeights& felt, double radius, const Given& given, const ArmFile& file,
                       std::vector<std::string>& told) {
    const ReliefSurface whole(felt.file.map);
    const HeightMap& map = whole.map();
    const Point3 size{map.width(), map.height(), whole.highest() - whole.lowest()};
    const FittedBox box = fitted_relief(given, file.arm, size, felt.drawn.has_value());
    const double scale = std::min(box.scale, 1.0);
    if (scale < 1) told.push_back(told_scale(size, scale));
    if (std::max(size.x, size.y) * scale < std::min(kLeastField, std::max(size.x, size.y)))
        throw Error(Fault::usage, "--plane",
                    "so high a map leaves less than 30 mm of its sides in the workspace; give it other heights with --low and "
                    "--high, or take another plane");
    HeightMap small = lifted(map, whole.lowest(), scale);
    if (radius > 0) small = dilated(small, radius);

    ArmScene scene{plot_of_map(map, kShown),
                   {},
                   mounting_of(box, scale * size, 0),
                   arm_law_of(given, file, 1),
                   std::max(file.arm.resolution, 0.01),
                   true};
    scene.frame = frame_of_box({0, 0, whole.lowest()}, {size.x, size.y, whole.highest()}, scale);
    // Contours of lines that are a millimetre wide are no picture of them.
    if (felt.drawn) {
        scene.plot.surfaces.clear();
        scene.plot.curves.push_back(lines_of(felt.drawn->layouts.front().shown.front()));
    }
    scene.relief = std::make_unique<const ReliefSurface>(std::move(small));
    scene.scene = std::make_unique<ReliefSpaceScene>(*scene.relief, scene.law);
    return scene;
}

}  // namespace tactics
