// SPDX-License-Identifier: Apache-2.0
#include "tactics/information/stream.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "tactics/error.h"
#include "tactics/information/code_length.h"

namespace tactics {

namespace {

constexpr double kShare = 0.1, kAllowance = 0.1;  // of the deadband: the force, and N mm, as tactics encode has them

std::vector<Point3> forces_of(const Recording& recording) {
    std::vector<Point3> forces;
    forces.reserve(recording.forces.size());
    for (const Steps3& force : recording.forces)
        forces.push_back({static_cast<double>(force.x) * recording.force_step,
                          static_cast<double>(force.y) * recording.force_step,
                          static_cast<double>(force.z) * recording.force_step});
    return forces;
}

double most_along(const std::vector<Point3>& forces) {
    double most = 0;
    for (const Point3& force : forces) most = std::max({most, std::abs(force.x), std::abs(force.y), std::abs(force.z)});
    return most;
}

// Odd, so that the middle one is no force.
int levels_of(double most, double step) {
    return static_cast<int>(std::clamp(2 * std::round(most / step) + 1, 3.0, kMostLevels - 1.0));
}

Point3 cut(const Point3& force, double most) { return length_of(force) <= most ? force : most * unit(force); }

}  // namespace

MeasuredStream measured(const Recording& recording, std::string_view name) {
    const std::vector<Point3> forces = forces_of(recording);
    if (forces.size() < 2)
        throw Error(Fault::failed, name, phrase("it has fewer than two ticks, so there is nothing to measure"));
    MeasuredStream stream;
    stream.ticks = forces.size();
    stream.seconds = static_cast<double>(recording.times.back() - recording.times.front()) / 1e6;
    stream.most = most_along(forces);
    if (!(stream.most > 0)) throw Error(Fault::failed, name, phrase("nothing was felt in it: no tick has a force"));
    stream.levels = levels_of(stream.most, recording.force_step);
    for (int component = 0; component < 3; ++component) {
        Measures& along = stream.along[static_cast<std::size_t>(component)];
        along = measure(component_of(forces, component, stream.most, stream.levels, name), {});
        stream.low += along.low;
        stream.high += along.high;
        stream.bits += along.bits;
    }
    stream.felt = encode_recording(recording, {kShare, kLeastForce, kAllowance, ForceGuess::hold}).told;
    return stream;
}

CarriedForces carried_by(const Recording& recording, const MeasuredStream& stream, const MediumChannel& channel) {
    if (!(channel.most_force > 0)) throw std::logic_error("a medium that does not push back has no forces");
    std::vector<Point3> forces = forces_of(recording);
    CarriedForces carried;
    for (Point3& force : forces) {
        const Point3 given = cut(force, channel.most_force);
        carried.cut += given == force ? 0 : 1;
        force = given;
    }
    const double most = std::min(stream.most, channel.most_force);
    carried.levels = std::min(stream.levels, levels_of(most, kLeastForce));
    for (int component = 0; component < 3; ++component)
        carried.bits += code_length(component_of(forces, component, most, carried.levels, channel.name)).best.bits;
    carried.bits = std::min(carried.bits, stream.bits);
    carried.loss = stream.bits > 0 ? (stream.bits - carried.bits) / stream.bits : 0;
    return carried;
}

}  // namespace tactics
