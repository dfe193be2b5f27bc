// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/scenes/plot_walls.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tactics/haptics/scenes/plot_part.h"

namespace tactics {

namespace {

// The nearest of values that ascend.
double nearest_to(const std::vector<double>& values, double at) noexcept {
    const auto next = std::lower_bound(values.begin(), values.end(), at);
    if (next == values.end()) return values.back();
    if (next == values.begin() || *next - at < at - *(next - 1)) return *next;
    return *(next - 1);
}

// N out of a wall of that depth, mm, for a finger that goes into it at that speed, mm/s.
double out_of_wall(const ForceLaw& law, double depth, double speed) noexcept {
    return depth > 0 ? std::max(0.0, law.stiffness * depth + law.damping_ns_per_m / 1000 * speed) : 0;
}

std::vector<double> ticks_across(const PlotFrame& frame) {
    std::vector<double> ticks;
    for (const double tick : frame.x.ticks) ticks.push_back(frame.across(tick));
    std::sort(ticks.begin(), ticks.end());
    return ticks;
}
std::vector<double> ticks_down(const PlotFrame& frame) {
    std::vector<double> ticks;
    for (const double tick : frame.y.ticks) ticks.push_back(frame.down(tick));
    std::sort(ticks.begin(), ticks.end());
    return ticks;
}

// A surface stands in for the wall.
std::unique_ptr<Scene> make_wall(const PlotFeel& feel, std::vector<Phrase>&) {
    if (!feel.plot.surfaces.empty()) return nullptr;
    return std::make_unique<PlotWall>(feel.law);
}
std::unique_ptr<Scene> make_axes(const PlotFeel& feel, std::vector<Phrase>&) {
    return std::make_unique<PlotAxes>(feel.frame, AxisFeel{feel.law});
}
std::unique_ptr<Scene> make_grid(const PlotFeel& feel, std::vector<Phrase>&) {
    return std::make_unique<PlotGrid>(feel.frame, GridFeel{});
}

}  // namespace

extern const PlotPart wall_part, axes_part, grid_part;
const PlotPart wall_part{"wall", "the plane that the plot is drawn on", make_wall};
const PlotPart axes_part{"axes", "walls at the left and at the bottom, with a bump at each tick", make_axes};
const PlotPart grid_part{"grid", "thin layers at the ticks in which the finger moves as through honey", make_grid};

Felt PlotWall::feel(const Touch& touch, double) noexcept {
    Felt felt;
    felt.force.z = out_of_wall(law_, -touch.finger.z, -touch.velocity.z);
    return felt;
}

PlotAxes::PlotAxes(const PlotFrame& frame, const AxisFeel& feel)
    : feel_(feel), bottom_(frame.height), left_(bumps_on(ticks_down(frame))), below_(bumps_on(ticks_across(frame))) {}

PlotAxes::Bumps PlotAxes::bumps_on(std::vector<double> ticks) const {
    double width = feel_.bump_width;
    for (std::size_t i = 1; i < ticks.size(); ++i) width = std::min(width, (ticks[i] - ticks[i - 1]) * 2 / 3);
    return {std::move(ticks), feel_.bump_height, width};
}

double PlotAxes::Bumps::from_nearest(double along) const noexcept { return at.empty() ? width : along - nearest_to(at, along); }

double PlotAxes::Bumps::rise(double along) const noexcept {
    const double off = from_nearest(along);
    return std::abs(off) < width / 2 ? height * (1 + std::cos(2 * std::numbers::pi * off / width)) / 2 : 0;
}

double PlotAxes::Bumps::slope(double along) const noexcept {
    const double off = from_nearest(along);
    return std::abs(off) < width / 2 ? -height * std::numbers::pi / width * std::sin(2 * std::numbers::pi * off / width) : 0;
}

Felt PlotAxes::feel(const Touch& touch, double) noexcept {
    Felt felt;
    const Point3& at = touch.finger;
    // depth = rise(y) - x; its slope is (-1, rise'(y)), and the force goes against it.
    const double left = left_.rise(at.y) - at.x, left_slope = left > 0 ? left_.slope(at.y) : 0;
    const double push_right = out_of_wall(feel_.law, left, left_slope * touch.velocity.y - touch.velocity.x);
    felt.force.x += push_right;
    felt.force.y -= push_right * left_slope;
    const double below = at.y - bottom_ + below_.rise(at.x), below_slope = below > 0 ? below_.slope(at.x) : 0;
    const double push_up = out_of_wall(feel_.law, below, touch.velocity.y + below_slope * touch.velocity.x);
    felt.force.y -= push_up;
    felt.force.x -= push_up * below_slope;
    return felt;
}

PlotGrid::PlotGrid(const PlotFrame& frame, const GridFeel& feel)
    : feel_(feel), across_(ticks_across(frame)), down_(ticks_down(frame)) {}

double PlotGrid::share_at(const std::vector<double>& lines, double along) const noexcept {
    if (lines.empty() || !std::isfinite(along)) return 0;
    const double inside = 1 - std::abs(along - nearest_to(lines, along)) / (feel_.width / 2);
    return std::clamp(2 * inside, 0.0, 1.0);
}

Felt PlotGrid::feel(const Touch& touch, double) noexcept {
    Felt felt;
    const double damping = feel_.damping_ns_per_m / 1000;
    felt.force.x = -damping * share_at(across_, touch.finger.x) * touch.velocity.x;
    felt.force.y = -damping * share_at(down_, touch.finger.y) * touch.velocity.y;
    return felt;
}

}  // namespace tactics
