// SPDX-License-Identifier: Apache-2.0
#include "tactics/coding/device_filter.h"

#include <algorithm>
#include <cmath>

#include "tactics/point3.h"

namespace tactics {

namespace {

Point3 real(const Steps3& steps, double step) {
    return {static_cast<double>(steps.x) * step, static_cast<double>(steps.y) * step, static_cast<double>(steps.z) * step};
}

Steps3 in_steps(const Point3& point, double step) {
    return {std::llround(point.x / step), std::llround(point.y / step), std::llround(point.z / step)};
}

}  // namespace

Recording for_device(const Recording& recording, const DeviceSteps& device) {
    Recording soft = recording;
    soft.place_step = device.place;
    soft.force_step = device.force;
    for (Steps3& place : soft.places) place = in_steps(real(place, recording.place_step), device.place);
    for (Steps3& force : soft.forces)
        force = in_steps(within(real(force, recording.force_step), device.most_force), device.force);
    return soft;
}

LevelMap for_device(LevelMap map, const DeviceSteps& device) {
    const double range = map.rise * map.top;
    const int top = std::max(1, static_cast<int>(std::min<double>(map.top, std::ceil(range / device.place))));
    for (Level& level : map.levels) level = static_cast<Level>((2LL * level * top + map.top) / (2LL * map.top));
    map.top = top;
    map.rise = range / top;
    return map;
}

}  // namespace tactics
