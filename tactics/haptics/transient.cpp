#include "tactics/haptics/transient.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tactics/units.h"

namespace tactics {

namespace {

constexpr double kForcesASwing = 16;
constexpr double kPiece = 0.25;  // mm over which a slope is taken: finer than a fingertip tells
constexpr double kOver = 6;      // decays after which nothing is left

}  // namespace

std::optional<std::string> why_no_transient(const TransientSettings& settings, double rate_hz) {
    if (rate_hz >= kForcesASwing * settings.frequency_hz) return std::nullopt;
    return "edges are played without a transient: " + to_text(settings.frequency_hz) + " Hz have " +
           to_text(std::floor(rate_hz / settings.frequency_hz)) + " forces a swing at " + to_text(rate_hz) + " Hz (a loop of " +
           to_text(kForcesASwing * settings.frequency_hz) + " Hz has " + to_text(kForcesASwing) + ")";
}

EdgeTransient::EdgeTransient(const TransientSettings& settings, double rate_hz)
    : settings_(settings), plays_(!why_no_transient(settings, rate_hz)) {}

double EdgeTransient::force(double height, Point at, double dt) noexcept {
    if (!plays_ || !(dt > 0) || !std::isfinite(height + at.x + at.y)) return 0;
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
    return amplitude_ * std::exp(-since_ / settings_.decay) * std::sin(2 * std::numbers::pi * settings_.frequency_hz * since_);
}

}  // namespace tactics
