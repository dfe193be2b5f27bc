// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/loop/mouse_play.h"

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

double height_of(const void* surface, Point at) noexcept { return static_cast<const ReliefSurface*>(surface)->height(at); }

}  // namespace

MousePlay::MousePlay(const ReliefSurface& surface, Fusion* fusion, const PlaySettings& settings)
    : surface_(surface),
      fusion_(fusion),
      settings_(settings),
      wall_(settings.wall),
      edges_(settings.edges, settings.wall.lever.rate_hz),
      safety_(for_rate(settings.safety, settings.wall.lever.rate_hz)),
      recorder_(settings.most_records) {}

Pose MousePlay::pose_of(const MouseSample& sample, double dt) noexcept {
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

double MousePlay::tick(const MouseSample& sample, double dt) noexcept {
    // What follows a reference wants a time that can be; safety is told the true one, and begins softly behind a long one.
    constexpr double kMost = 0.1;
    const double passed = std::isfinite(dt) && dt > 0 ? std::min(dt, kMost) : 0;
    const Pose pose = pose_of(sample, passed);
    if (!begun_) finger_before_ = sample.height;
    begun_ = true;
    if (sample.stop_key) safety_.stop();
    lost_ += sample.lost;
    const double reference = wall_.reference({&surface_, height_of}, pose.at, pose.velocity, passed, pose.doubt);
    const double surface = surface_.height(pose.at);
    const double held = wall_force(settings_.wall, wall_, reference, sample.height, finger_before_, passed);
    const double swing = edges_.force(surface, pose.at, passed);
    // A finger in the air feels no edge.
    const double wished = sample.fault ? 0 : held != 0 ? held + swing : 0;
    // Who knows where the finger is when that is over.
    at_fault_ = sample.fault ? at_fault_ + passed : 0;
    if (at_fault_ > settings_.safety.most_dt) safety_.begin_softly();
    const double force = safety_.pass(wished, dt);
    time_ += passed;
    recorder_.add({time_, pose.at, sample.height, surface, reference, force, sample.place});
    finger_before_ = sample.height;
    return force;
}

void MousePlay::begin_again(double away) noexcept {
    safety_.let_go();
    begun_ = false;
    course_.begin_again();
    if (std::isfinite(away) && away > 0) time_ += away;
}

}  // namespace tactics
