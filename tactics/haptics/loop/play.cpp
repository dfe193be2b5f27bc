// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/loop/play.h"

#include <algorithm>
#include <cmath>

namespace tactics {

namespace {

constexpr double kLateTicks = 2.5;

// A slow loop's own ticks are not late.
SafetyLimits for_rate(SafetyLimits limits, double rate) {
    limits.most_dt = std::max(limits.most_dt, kLateTicks / rate);
    return limits;
}

}  // namespace

Playing::Playing(Scene& scene, Fusion* fusion, const PlaySettings& settings)
    : scene_(scene),
      fusion_(fusion),
      settings_(settings),
      safety_(for_rate(settings.safety, settings.rate_hz)),
      recorder_(settings.most_records) {}

Pose Playing::pose_of(const HapticSample& sample, double dt) noexcept {
    if (!sample.knows_place && fusion_ != nullptr) {
        fusion_->step(sample.moved);
        if (sample.has_overlay) fusion_->overlay(sample.overlay);
        overlaid_ = overlaid_ || sample.has_overlay;
        Pose pose = fusion_->pose();
        if (!overlaid_) pose.at = {settings_.begin.x + pose.at.x, settings_.begin.y + pose.at.y};
        return pose;
    }
    if (begun_ && dt > 0) course_.step({sample.place.x - known_.at.x, sample.place.y - known_.at.y}, dt);
    known_.velocity = course_.velocity();
    known_.doubt = course_.doubt();
    known_.at = sample.place;
    return known_;
}

Point3 Playing::tick(const HapticSample& sample, double dt) noexcept {
    // A scene that follows a reference needs a plausible time step; safety gets the true one, and begins softly after a long one.
    constexpr double kMost = 0.1;
    const double passed = std::isfinite(dt) && dt > 0 ? std::min(dt, kMost) : 0;
    const Pose pose = pose_of(sample, passed);
    if (begun_ && passed > 0) rise_.step({sample.height - height_, 0}, passed);
    height_ = sample.height;
    begun_ = true;
    if (sample.stop_key) safety_.stop();
    lost_ += sample.lost;
    const Felt felt = scene_.feel(
        {{pose.at.x, pose.at.y, sample.height}, {pose.velocity.x, pose.velocity.y, rise_.velocity().x}, pose.doubt, sample.keys},
        passed);
    const Point3 wished = sample.fault ? Point3{} : felt.force;
    // Who knows where the finger is when that is over.
    at_fault_ = sample.fault ? at_fault_ + passed : 0;
    if (at_fault_ > settings_.safety.most_dt) safety_.begin_softly();
    const Point3 force = safety_.pass(wished, dt);
    time_ += passed;
    recorder_.add({time_, pose.at, sample.height, felt.surface, felt.reference, force, sample.place});
    return force;
}

void Playing::begin_again(double away) noexcept {
    safety_.let_go();
    begun_ = false;
    scene_.begin_again();
    course_.begin_again();
    rise_.begin_again();
    if (std::isfinite(away) && away > 0) time_ += away;
}

}  // namespace tactics
