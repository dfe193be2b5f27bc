// SPDX-License-Identifier: Apache-2.0
// What leans, or stands, and nothing holds: turned into the plane by itself.
#include <algorithm>
#include <cmath>

#include "tactics/solid/growth.h"

namespace tactics {

PlacedPanel Growth::straightened(std::uint32_t number) const {
    const Panel& panel = panels_.panels[number];
    const Point3 middle = middles_[number], normal = panel.normal;
    const double away = dot(normal, view_.toward) < 0 ? -1 : 1;
    PlacedPanel placed{
        .panel = number, .handling = Handling::straightened, .height = dot(middle, view_.toward), .placement = {}, .shape = {}};
    Point3 along = view_.right - dot(view_.right, normal) * normal;
    if (length_of(along) < 0.1) along = dot(view_.down, normal) * normal - view_.down;
    along = unit(along);
    // A footprint is seen through what stands on it.
    placed.placement = {middle, along, away * cross(along, normal), {dot(middle, view_.right), dot(middle, view_.down)},
                        {1, 0}, {0, 1}};
    if (std::abs(dot(normal, view_.toward)) >= kAligned) placed.handling = Handling::kept;
    placed.shape = shape_of(number, placed.placement);
    return placed;
}

PlacedPanel Growth::laid(std::uint32_t number) const {
    const Panel& panel = panels_.panels[number];
    PlacedPanel placed{.panel = number, .handling = Handling::lying, .folds = 1, .height = 0, .placement = {}, .shape = {}};
    // About the lowest of its sides that lie in the plane; without one about its lowest corner.
    Point3 foot = panel.rings.front().front();
    for (const Point3& corner : panel.rings.front())
        if (dot(corner, view_.toward) < dot(foot, view_.toward) - touching_) foot = corner;
    const Point3 along = unit(cross(view_.toward, panel.normal));
    Point3 across = cross(panel.normal, along);
    if (dot(across, view_.toward) < 0) across = -1 * across;
    const Point flat{dot(along, view_.right), dot(along, view_.down)};
    const Point out{dot(panel.normal, view_.right), dot(panel.normal, view_.down)};
    const double length = std::max(1e-12, std::hypot(out.x, out.y));
    // It falls onto its back, so that its front is up.
    placed.placement = {
        foot, along, across, {dot(foot, view_.right), dot(foot, view_.down)}, flat, {-out.x / length, -out.y / length}};
    placed.height = dot(foot, view_.toward);
    placed.shape = shape_of(number, placed.placement);
    return placed;
}

}  // namespace tactics
