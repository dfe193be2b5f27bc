// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "tactics/haptics/sensing/learning_filter.h"
#include "tactics/haptics/sensing/velocity.h"

namespace tactics {

namespace {

constexpr double kBetter = 0.3;  // in the mean of minus twice a log likelihood

class LearningFusion final : public Fusion {
public:
    LearningFusion(const MouseGeometry& geometry, const std::optional<LearnedPointing>& before)
        : odometry_(geometry),
          filters_{LearningFilter{odometry_.sensors_apart(), 0}, LearningFilter{odometry_.sensors_apart(), 0.5},
                   LearningFilter{odometry_.sensors_apart(), 1}} {
        for (std::size_t i = 0; before && i < filters_.size(); ++i)
            if (filters_[i].judged() == before->judged) filters_[best_ = i].begin_with(*before);
    }

    void step(const OpticalStep& step) noexcept override {
        double passed = 0;
        bool restarted = false;
        if (!odometry_.takes(step, passed, restarted)) return;
        if (restarted) {
            past_.clear();
            course_.begin_again();
        }
        first_ = smoothed(first_, step.first, passed);
        second_ = smoothed(second_, step.second, passed);
        // Each sensor is corrected by its own speed: while the mouse turns they differ, and the turn is their difference.
        const double first = best().scale(distance({}, first_)), second = best().scale(distance({}, second_));
        const FingerStep finger =
            odometry_.advance({first * step.first.x, first * step.first.y}, {second * step.second.x, second * step.second.y});
        const Point middle{(first_.x + second_.x) / 2, (first_.y + second_.y) / 2};
        const double speed = distance({}, middle), scale = best().scale(speed);
        const auto w = weights_at(kScaleSpeeds, speed);
        // As counted, so that what is learned later holds for it too.
        for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
            const double share = (i == 0 ? 1 - w.upper_share : w.upper_share) / scale;
            Point& way = now_.ways[w.lower + i];
            way = {way.x + share * finger.middle.x, way.y + share * finger.middle.y};
            now_.turns[w.lower + i] += share * finger.turned;
        }
        now_.time = step.time;
        now_.arm = {now_.arm.x + finger.arm.x, now_.arm.y + finger.arm.y};
        now_.turned += finger.turned;
        now_.twisted += std::abs(finger.turned);
        const Point moved{finger.middle.x + finger.arm.x, finger.middle.y + finger.arm.y};
        now_.length += distance({}, moved);
        now_.across += (step.first.y + step.second.y) / 2;
        velocity_ = smoothed(velocity_, moved, passed);
        course_.step(moved, passed);
        now_.speed = distance({}, velocity_);
        past_.add(now_);
    }

    void overlay(const OverlaySample& sample) noexcept override {
        if (!order_.takes(sample)) return;
        for (LearningFilter& filter : filters_) filter.overlay(sample, past_);
        for (std::size_t i = 0; i < filters_.size(); ++i)
            if (filters_[i].surprise() < filters_[best_].surprise() - kBetter) best_ = i;
    }

    Pose pose() const noexcept override {
        const double heading = best().heading(now_);
        return {best().place(now_), odometry_.heading() + heading, turned(course_.velocity(), heading), course_.doubt()};
    }

    unsigned resets() const noexcept override { return best().resets(); }
    std::optional<LearnedPointing> learned() const noexcept override {
        return best().placed() ? std::optional(best().learned()) : std::nullopt;
    }

private:
    const LearningFilter& best() const noexcept { return filters_[best_]; }

    Odometry odometry_;
    SampleOrder order_;
    History<LearningMoment> past_;
    LearningMoment now_;
    Point first_, second_;  ///< mm/s, of the sensors as they count
    Point velocity_;        ///< mm/s, of the finger, in the axes of the odometry: what delay and scale depend on
    AdaptiveVelocity course_;
    /// When the overlay judges the speed that its delay depends on is not known: each answer has its filter, the least surprised
    /// speaks.
    std::array<LearningFilter, 3> filters_;
    std::size_t best_ = 0;
};

}  // namespace

std::unique_ptr<Fusion> learning_fusion(const MouseGeometry& geometry, const std::optional<LearnedPointing>& before) {
    return std::make_unique<LearningFusion>(geometry, before);
}

}  // namespace tactics
