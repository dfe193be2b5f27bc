// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/devices/mounting.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tactics {

namespace {

class Mounted final : public HapticDevice {
public:
    Mounted(std::unique_ptr<HapticDevice> device, const Mounting& mounting) : device_(std::move(device)), mounting_(mounting) {}
    State read(HapticSample& sample, double dt) noexcept override {
        HapticSample own = sample;
        own.place = told_;
        own.height = height_;
        const State state = device_->read(own, dt);
        told_ = own.place;
        height_ = own.height;
        const Point3 at = mounting_.to_scene({own.place.x, own.place.y, own.height});
        sample = own;
        sample.place = {at.x, at.y};
        sample.height = at.z;
        return state;
    }
    bool push(const Point3& force) noexcept override { return device_->push(mounting_.turned(force)); }
    void let_go() noexcept override { device_->let_go(); }
    bool reopen(std::string& why) override { return device_->reopen(why); }
    bool is_real() const override { return device_->is_real(); }

private:
    std::unique_ptr<HapticDevice> device_;
    Mounting mounting_;
    Point told_;  // the device's last report, used while it is silent
    double height_ = 0;
};

}  // namespace

MountedField mount(const ScenePlane& plane, const Workspace& workspace, double aspect, double margin) {
    constexpr double kLeast = 1e-9;
    MountedField field;
    const double length = std::hypot(plane.a, plane.b, plane.c);
    if (!(length > kLeast) || !std::isfinite(length) || !(aspect > 0)) return field;
    Mounting& m = field.mounting;
    m.out = {plane.a / length, plane.b / length, plane.c / length};
    const Point3 across = cross({0, 1, 0}, m.out);
    m.right = length_of(across) > kLeast ? 1 / length_of(across) * across : Point3{1, 0, 0};
    m.down = -1.0 * cross(m.out, m.right);
    const Point3 middle = -plane.d / length * m.out;
    const Point3 room{workspace.width / 2 - margin, workspace.height / 2 - margin, workspace.depth / 2 - margin};
    // Each corner is half a width and half a height from the middle; along each side of the workspace the farthest counts.
    double most = INFINITY;
    const auto bound = [&](double at, double right, double down, double half) {
        const double reach = std::abs(right) * aspect / 2 + std::abs(down) / 2;
        if (std::abs(at) > half) most = 0;
        if (reach > kLeast) most = std::min(most, (half - std::abs(at)) / reach);
    };
    bound(middle.x, m.right.x, m.down.x, room.x);
    bound(middle.y, m.right.y, m.down.y, room.y);
    bound(middle.z, m.right.z, m.down.z, room.z);
    if (!(most > 0) || !std::isfinite(most)) return field;
    field.height = most;
    field.width = most * aspect;
    m.origin = middle - field.width / 2 * m.right - field.height / 2 * m.down;
    return field;
}

std::unique_ptr<HapticDevice> mounted(std::unique_ptr<HapticDevice> device, const Mounting& mounting) {
    return std::make_unique<Mounted>(std::move(device), mounting);
}

}  // namespace tactics
