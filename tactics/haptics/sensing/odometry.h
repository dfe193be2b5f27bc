// SPDX-License-Identifier: Apache-2.0
// What two optical sensors say of the movement of the finger, and a memory of it that an overlay's late word is held against.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "tactics/haptics/sensing/fusion.h"

namespace tactics {

/// What the fingertip moved in a step, in axes that do not turn with the mouse but with which it began.
struct FingerStep {
    Point middle;       ///< mm, as the middle between the sensors moved
    Point arm;          ///< mm, as it moved besides because the mouse turned
    double turned = 0;  ///< rad
};

/// Dead reckoning. A step is taken for a turn about one point at even speed, which makes turns about any point exact.
class Odometry {
public:
    explicit Odometry(const MouseGeometry& geometry);
    /// False: the step cannot be, and is passed over. `passed`: s, since the step before. `restarted`: the clock has gone back
    /// for good.
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

/// The newest moments, in the order of their times, in a ring: a second of them at 8 kHz. A Moment has a `time`.
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

    /// The last moment not after `time` and the one that follows it, and how far from one to the other that is; the ends hold on.
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

/// A velocity after a step, mm/s: over some ms, because counts come in lumps. Late by that; AdaptiveVelocity is not.
inline Point smoothed(Point velocity, Point moved, double passed) noexcept {
    constexpr double kSmoothing = 0.003;  // s
    const double least = passed > 1e-6 ? passed : 1e-6, share = least / (least + kSmoothing);
    return {velocity.x + share * (moved.x / least - velocity.x), velocity.y + share * (moved.y / least - velocity.y)};
}

/// Not NaN, not infinite, and no farther than a table could be.
inline bool is_place(Point p) { return std::abs(p.x) < 1e6 && std::abs(p.y) < 1e6; }

/// Passes over samples that cannot be: no place, or not later than the one before, unless the clock itself has gone back.
class SampleOrder {
public:
    bool takes(const OverlaySample& sample) noexcept;

private:
    double time_ = 0;
    int out_of_order_ = -1;
};

}  // namespace tactics
