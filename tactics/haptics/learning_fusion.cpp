#include <algorithm>

#include "tactics/haptics/learning_filter.h"

namespace tactics {

namespace {

constexpr double kSmoothing = 0.003;  // s, of the speed: counts of a sensor come in lumps
constexpr double kBetter = 0.3;       // in the mean of minus twice a log likelihood

class LearningFusion final : public Fusion {
public:
    explicit LearningFusion(const MouseGeometry& geometry) : odometry_(geometry),
          filters_{LearningFilter{odometry_.sensors_apart(), 0}, LearningFilter{odometry_.sensors_apart(), 0.5},
                   LearningFilter{odometry_.sensors_apart(), 1}} {}

    void step(const OpticalStep& step) noexcept override {
        FingerStep finger;
        bool restarted = false;
        if (!odometry_.advance(step, finger, restarted)) return;
        if (restarted) past_.clear();
        const double share = finger.passed / (finger.passed + kSmoothing), each = 1 / std::max(finger.passed, 1e-6);
        velocity_ = {velocity_.x + share * (finger.moved.x * each - velocity_.x), velocity_.y + share * (finger.moved.y * each - velocity_.y)};
        now_.time = step.time;
        now_.speed = distance({}, velocity_);
        const auto w = weights_at(kScaleSpeeds, now_.speed);
        Point &lower = now_.ways[w.lower], &upper = now_.ways[w.lower + 1];
        lower = {lower.x + (1 - w.upper_share) * finger.moved.x, lower.y + (1 - w.upper_share) * finger.moved.y};
        upper = {upper.x + w.upper_share * finger.moved.x, upper.y + w.upper_share * finger.moved.y};
        now_.length += distance({}, finger.moved);
        now_.across += finger.across;
        past_.add(now_);
    }

    void overlay(const OverlaySample& sample) noexcept override {
        if (!order_.takes(sample)) return;
        for (LearningFilter& filter : filters_) filter.overlay(sample, past_);
        for (std::size_t i = 0; i < filters_.size(); ++i)
            if (filters_[i].surprise() < filters_[best_].surprise() - kBetter) best_ = i;
    }

    Pose pose() const noexcept override {
        const double heading = best().heading(now_), scale = best().scale(now_.speed);
        return {best().place(now_), odometry_.heading() + heading, turned({scale * velocity_.x, scale * velocity_.y}, heading)};
    }

    unsigned resets() const noexcept override { return best().resets(); }

private:
    const LearningFilter& best() const noexcept { return filters_[best_]; }

    Odometry odometry_;
    SampleOrder order_;
    History<LearningMoment> past_;
    LearningMoment now_;
    Point velocity_;  ///< mm/s, as counted, in the axes of the odometry
    /// When the overlay judges the speed that its delay depends on is not known: each answer has its filter, the least surprised speaks.
    std::array<LearningFilter, 3> filters_;
    std::size_t best_ = 0;
};

}  // namespace

std::unique_ptr<Fusion> learning_fusion(const MouseGeometry& geometry) { return std::make_unique<LearningFusion>(geometry); }

}  // namespace tactics
