// SPDX-License-Identifier: Apache-2.0
// Learns the properties of an overlay and of optical sensors: an extended Kalman filter of the finger's place at the time of the
// overlay's measurement, the heading, and the scale of the sensors and the delay of the overlay at each speed.
#pragma once

#include <array>
#include <cstddef>

#include "tactics/haptics/sensing/learned.h"
#include "tactics/haptics/sensing/odometry.h"

namespace tactics {

/// Weights for values given at some speeds, with linear interpolation between them; beyond the last speed, the last value.
template <std::size_t N>
struct SpeedWeights {
    std::size_t lower = 0;  ///< index of the lower of the two speeds
    double upper_share = 0;
};

template <std::size_t N>
SpeedWeights<N> weights_at(const std::array<double, N>& speeds, double speed) noexcept {
    std::size_t i = 0;
    while (i + 2 < N && speed >= speeds[i + 1]) ++i;
    const double share = (speed - speeds[i]) / (speeds[i + 1] - speeds[i]);
    return {i, share < 0 ? 0 : share > 1 ? 1 : share};
}

/// mm/s, as the sensors count it: pointer acceleration of x1.8 turns 250 into 450.
inline constexpr std::array<double, 8> kScaleSpeeds = {0, 60, 120, 180, 260, 400, 600, 900};
/// mm/s, of the finger.
inline constexpr std::array<double, 6> kDelaySpeeds = {0, 90, 150, 220, 300, 500};

/// A moment of the odometry: sums since the beginning.
struct LearningMoment {
    double time = 0;
    std::array<Point, kScaleSpeeds.size()>
        ways;  ///< mm, as counted, of the middle between the sensors, by the speed at which they were made
    std::array<double, kScaleSpeeds.size()> turns{};  ///< rad, as counted, in the same way
    Point arm;                                        ///< mm, additional movement of the finger because the mouse turned
    double turned = 0;                                ///< rad, as the odometry assumed at arrival
    double twisted = 0;                               ///< rad, sum of all turns in both directions
    double length = 0;                                ///< mm, of the way
    double across = 0;                                ///< mm along the mouse's own y: unequal sensors turn it wrongly by this
    double speed = 0;                                 ///< mm/s, of the finger
};

class LearningFilter {
public:
    /// `judged`: the overlay's delay depends on the speed when its sample arrives (0), when the finger was there (1), or in
    /// between.
    LearningFilter(double sensors_apart, double judged);
    /// Starts with earlier parameters, at slightly lower confidence: another day, another table, another load of the computer.
    void begin_with(const LearnedPointing& before) noexcept;
    LearnedPointing learned() const noexcept;
    double judged() const noexcept { return judged_; }
    bool placed() const noexcept { return placed_; }  ///< it has seen a sample

    /// False: it was rejected.
    bool overlay(const OverlaySample& sample, const History<LearningMoment>& past) noexcept;

    Point place(const LearningMoment& now) const noexcept;
    double heading(const LearningMoment& now) const noexcept;  ///< of the axes of the odometry, rad
    double scale(double speed) const noexcept;
    double delay(double speed) const noexcept;
    unsigned resets() const noexcept { return resets_; }
    double surprise() const noexcept { return surprise_; }  ///< of recent samples: the smaller, the better the fit

private:
    static constexpr std::size_t kX = 0, kY = 1, kHeading = 2, kDrift = 3, kUnlike = 4, kScale = 5,
                                 kDelay = kScale + kScaleSpeeds.size(), kStates = kDelay + kDelaySpeeds.size();
    static_assert(kStates - kDrift == LearnedPointing::kValues);

    void begin() noexcept;
    void go_to(const LearningMoment& moment) noexcept;
    void let_go_of_place() noexcept;
    bool correct(Point told, Point speed, const SpeedWeights<kDelaySpeeds.size()>& weights, double doubt, bool must) noexcept;
    Point way_to(const LearningMoment& moment) const noexcept;
    void keep_within_bounds() noexcept;

    std::array<double, kStates> state_{};
    std::array<std::array<double, kStates>, kStates> covariance_{};
    LearningMoment anchor_;  ///< moment to which the state's place belongs
    double apart_, judged_;
    double noise_ = 0.7, jitter_ = 0.008;  ///< mm, s: as learned
    double surprise_ = 0;
    int rejected_ = 0;
    bool placed_ = false;
    unsigned resets_ = 0;
};

}  // namespace tactics
