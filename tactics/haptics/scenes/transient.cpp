// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/scenes/transient.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tactics {

namespace {

// A force that holds for a tick swings at the rate less the frequency, too; with ten forces a swing a ninth as much, and at a
// rate of 1 kHz at 900 Hz, which a fingertip does not feel (from memory: its quickest receptors reach to about 800 Hz).
constexpr double kForcesASwing = 10;
constexpr double kLeastHz = 100;
constexpr double kPiece = 0.25;  // mm over which a slope is taken: finer than a fingertip tells
constexpr double kOver = 6;      // decays after which nothing is left

}  // namespace

double transient_frequency(const TransientSettings& settings, double rate_hz) noexcept {
    const double frequency = std::min(settings.frequency_hz, rate_hz / kForcesASwing);
    return frequency >= kLeastHz ? frequency : 0;
}

double EdgeTransient::force(double height, Point at, double dt) noexcept {
    if (frequency_ == 0 || !(dt > 0) || !std::isfinite(height + at.x + at.y)) return 0;
    if (!begun_) {
        begun_ = true;
        before_ = at;
        height_before_ = height;
    }
    moved_ = distance(at, before_);
    elapsed_ += dt;
    since_ += dt;
    if (moved_ >= kPiece) {
        const double slope = (height - height_before_) / moved_;
        // A wall bends twice; what plays already is not begun again.
        if (knows_slope_ && std::abs(slope - slope_) > settings_.bend && (amplitude_ == 0 || since_ > settings_.decay)) {
            amplitude_ = std::min(settings_.force_per_speed * moved_ / elapsed_, settings_.most_force);
            since_ = 0;
        }
        slope_ = slope;
        knows_slope_ = true;
        before_ = at;
        height_before_ = height;
        elapsed_ = 0;
    }
    if (amplitude_ == 0) return 0;
    if (since_ > kOver * settings_.decay) return amplitude_ = 0;
    return amplitude_ * std::exp(-since_ / settings_.decay) * std::sin(2 * std::numbers::pi * frequency_ * since_);
}

}  // namespace tactics
