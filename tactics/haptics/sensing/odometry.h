// SPDX-License-Identifier: Apache-2.0
// The movement of the finger by two optical sensors, and its history, to compare with an overlay's late samples.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "tactics/haptics/sensing/fusion.h"

namespace tactics {

/// Movement of the fingertip in a step, in fixed axes: those of the mouse at the beginning.
struct FingerStep {
    Point middle;       ///< mm, movement of the middle between the sensors
    Point arm;          ///< mm, additional movement because the mouse turned
    double turned = 0;  ///< rad
};

/// Dead reckoning. Each step counts as a turn about one point at constant speed, which is exact for turns about any point.
class Odometry {
public:
    explicit Odometry(const MouseGeometry& geometry);
    /// False: the step is impossible and ignored. `passed`: s since the previous step. `restarted`: the clock went back
    /// permanently.
    bool takes(const OpticalStep& step, double& passed, bool& restarted) noexcept;
    FingerStep advance(Point first, Point second) noexcept;
    double heading() const noexcept { return heading_; }
    double sensors_apart() const noexcept { return apart_; }

private:
    double apart_;
    Point finger_;
    double time_ = 0, heading_ = 0;
    int out_of_order_ = -1;  ///< -1: no step yet
};

/// The newest moments in order of time, in a ring: one second at 8 kHz. A Moment has a `time`.
template <class Moment>
class History {
public:
    History() : moments_(kMoments) {}
    void clear() noexcept { size_ = 0; }
    bool empty() const noexcept { return size_ == 0; }
    void add(const Moment& moment) noexcept {
        end_ = (end_ + 1) % kMoments;
        moments_[end_] = moment;
        if (size_ < kMoments) ++size_;
    }
    const Moment& newest() const noexcept { return moments_[end_]; }
    const Moment& oldest() const noexcept { return of(0); }

    /// The last moment not after `time`, the one after it, and the fraction between them; clamped at the ends.
    struct Place {
        const Moment* before;
        const Moment* after;
        double share;
    };
    Place find(double time) const noexcept {
        if (!(time > oldest().time)) return {&oldest(), &oldest(), 0};
        if (time >= newest().time) return {&newest(), &newest(), 0};
        std::size_t low = 0, high = size_ - 1;
        while (high - low > 1) {
            const std::size_t middle = (low + high) / 2;
            (of(middle).time <= time ? low : high) = middle;
        }
        const Moment &a = of(low), &b = of(high);
        return {&a, &b, (time - a.time) / (b.time - a.time)};
    }

private:
    static constexpr std::size_t kMoments = 8192;
    const Moment& of(std::size_t age) const noexcept { return moments_[(end_ + 1 + kMoments - size_ + age) % kMoments]; }
    std::vector<Moment> moments_;
    std::size_t end_ = kMoments - 1, size_ = 0;
};

inline Point turned(Point p, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * p.x - s * p.y, s * p.x + c * p.y};
}

/// A velocity after a step, mm/s, averaged over some ms because counts come in lumps. It lags by that time; AdaptiveVelocity does
/// not.
inline Point smoothed(Point velocity, Point moved, double passed) noexcept {
    constexpr double kSmoothing = 0.003;  // s
    const double least = passed > 1e-6 ? passed : 1e-6, share = least / (least + kSmoothing);
    return {velocity.x + share * (moved.x / least - velocity.x), velocity.y + share * (moved.y / least - velocity.y)};
}

/// Whether it is finite and no farther than the size of a table.
inline bool is_place(Point p) { return std::abs(p.x) < 1e6 && std::abs(p.y) < 1e6; }

/// Ignores impossible samples: without a place, or not later than the previous one, unless the clock itself has gone back.
class SampleOrder {
public:
    bool takes(const OverlaySample& sample) noexcept;

private:
    double time_ = 0;
    int out_of_order_ = -1;
};

}  // namespace tactics
