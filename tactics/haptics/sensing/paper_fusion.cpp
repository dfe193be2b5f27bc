// SPDX-License-Identifier: Apache-2.0
// The method of "1 DOF Tabletop Haptic Mouse for Shape Recognition of 3D Virtual Objects", V.A: what the sensors moved during the
// preceding 0.15 s is added to the place of the overlay. From one sample to the next the sensors carry on, by their time stamps;
// the paper does not say whether its samples were held meanwhile.
#include "tactics/haptics/sensing/odometry.h"
#include "tactics/haptics/sensing/velocity.h"

namespace tactics {

namespace {

struct Moment {
    double time = 0;
    Point way;  ///< mm, of the finger since the beginning
};

class PaperFusion final : public Fusion {
public:
    PaperFusion(const MouseGeometry& geometry, double delay)
        : odometry_(geometry), delay_(delay >= 0 && delay < 1e3 ? delay : 0.15) {}

    void step(const OpticalStep& step) noexcept override {
        double passed = 0;
        bool restarted = false;
        if (!odometry_.takes(step, passed, restarted)) return;
        if (restarted) past_.clear();
        const FingerStep finger = odometry_.advance(step.first, step.second);
        const Point moved{finger.middle.x + finger.arm.x, finger.middle.y + finger.arm.y};
        way_ = {way_.x + moved.x, way_.y + moved.y};
        past_.add({step.time, way_});
        course_.step(moved, passed);
    }

    void overlay(const OverlaySample& sample) noexcept override {
        if (!order_.takes(sample)) return;
        const Point then = way_at(sample.time - delay_);
        anchor_ = {sample.at.x - then.x, sample.at.y - then.y};
    }

    Pose pose() const noexcept override {
        return {{anchor_.x + way_.x, anchor_.y + way_.y}, odometry_.heading(), course_.velocity(), course_.doubt()};
    }
    unsigned resets() const noexcept override { return 0; }

private:
    Point way_at(double time) const noexcept {
        if (past_.empty()) return way_;
        const auto place = past_.find(time);
        const Point a = place.before->way, b = place.after->way;
        return {a.x + place.share * (b.x - a.x), a.y + place.share * (b.y - a.y)};
    }

    Odometry odometry_;
    SampleOrder order_;
    History<Moment> past_;
    double delay_;
    Point way_, anchor_;
    AdaptiveVelocity course_;
};

}  // namespace

std::unique_ptr<Fusion> paper_fusion(const MouseGeometry& geometry, double delay) {
    return std::make_unique<PaperFusion>(geometry, delay);
}

}  // namespace tactics
