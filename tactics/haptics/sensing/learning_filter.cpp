// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/sensing/learning_filter.h"

#include <algorithm>

namespace tactics {

namespace {

// Initial uncertainties (standard deviations).
constexpr double kDelay0 = 0.15;          // s (the paper, V.A)
constexpr double kDelayDoubt = 0.04;      // s, of all speeds together
constexpr double kDelayStepDoubt = 0.03;  // s, from one of kDelaySpeeds to the next
constexpr double kScaleDoubt = 0.05;      // the paper's 4 %, IV.A
constexpr double kScaleStepDoubt = 0.12;  // from one of kScaleSpeeds to the next: pointer acceleration
constexpr double kHeadingDoubt = 0.35;    // rad: how a mouse is held
constexpr double kDriftDoubt = 5e-5;      // rad/mm
constexpr double kUnlikeDoubt = 0.01;     // of the scales of two sensors of one make

constexpr double kSince = 0.1;  // of these doubts comes anew from one use to the next

// Rates of change: variances per mm of movement, or per s.
constexpr double kPlaceChange = 1e-4;    // mm2/mm
constexpr double kHeadingChange = 1e-8;  // rad2/mm
constexpr double kTurnChange = 1e-3;     // rad2/rad: while the scales are not known, no turn is
constexpr double kScaleChange = 1e-9;    // per mm: another surface
constexpr double kDelayChange = 2.5e-7;  // s2/s

constexpr double kGate = 20;               // squared deviations of two axes: once in 20000
constexpr int kMostRejected = 4;           // samples in a row, then it is the filter that is wrong
constexpr double kUnplaced = 1e8;          // mm2
constexpr double kStale = 0.1;             // s without a step: the sensors say nothing
constexpr double kJudging = 0.01;          // s: of a speed within so short a time it is not known which the overlay meant
constexpr double kForgetting = 1.0 / 120;  // per sample, of its noise and jitter
constexpr double kLeastNoise = 0.15;       // mm: also of what the states do not describe
constexpr double kLeastJitter = 1e-3;      // s
constexpr double kSurpriseForgetting = 1.0 / 240;

template <class Moment>
Moment moment_at(const History<Moment>& past, double time) noexcept {
    const auto place = past.find(time);
    Moment moment = *place.before;
    if (place.share <= 0) return moment;
    const Moment& after = *place.after;
    const auto mix = [&](double a, double b) { return a + place.share * (b - a); };
    moment.time = time;
    const auto mix_points = [&](Point a, Point b) { return Point{mix(a.x, b.x), mix(a.y, b.y)}; };
    for (std::size_t i = 0; i < moment.ways.size(); ++i) {
        moment.ways[i] = mix_points(moment.ways[i], after.ways[i]);
        moment.turns[i] = mix(moment.turns[i], after.turns[i]);
    }
    moment.arm = mix_points(moment.arm, after.arm);
    moment.turned = mix(moment.turned, after.turned);
    moment.twisted = mix(moment.twisted, after.twisted);
    moment.length = mix(moment.length, after.length);
    moment.across = mix(moment.across, after.across);
    moment.speed = mix(moment.speed, after.speed);
    return moment;
}

double speed_at(const History<LearningMoment>& past, double time) noexcept {
    const auto place = past.find(time);
    return place.before->speed + place.share * (place.after->speed - place.before->speed);
}

double square(double x) { return x * x; }

}  // namespace

LearningFilter::LearningFilter(double sensors_apart, double judged) : apart_(sensors_apart), judged_(judged) { begin(); }

void LearningFilter::begin() noexcept {
    state_ = {};
    covariance_ = {};
    for (std::size_t i = kScale; i < kDelay; ++i) state_[i] = 1;
    for (std::size_t i = kDelay; i < kStates; ++i) state_[i] = kDelay0;
    covariance_[kX][kX] = covariance_[kY][kY] = kUnplaced;
    covariance_[kHeading][kHeading] = square(kHeadingDoubt);
    covariance_[kDrift][kDrift] = square(kDriftDoubt);
    covariance_[kUnlike][kUnlike] = square(kUnlikeDoubt);
    const auto walk = [this](std::size_t from, std::size_t to, double first, double step) {
        for (std::size_t i = from; i < to; ++i)
            for (std::size_t j = from; j < to; ++j)
                covariance_[i][j] += square(first) + square(step) * static_cast<double>(std::min(i, j) - from);
    };
    walk(kScale, kDelay, kScaleDoubt, kScaleStepDoubt);
    walk(kDelay, kStates, kDelayDoubt, kDelayStepDoubt);
    noise_ = 0.7;
    jitter_ = 0.008;
    rejected_ = 0;
    placed_ = false;
}

void LearningFilter::begin_with(const LearnedPointing& before) noexcept {
    begin();
    for (std::size_t i = kDrift; i < kStates; ++i) {
        state_[i] = before.values[i - kDrift];
        for (std::size_t j = kDrift; j < kStates; ++j) covariance_[i][j] = before.covariance[i - kDrift][j - kDrift];
    }
    covariance_[kDrift][kDrift] += square(kSince * kDriftDoubt);
    covariance_[kUnlike][kUnlike] += square(kSince * kUnlikeDoubt);
    const auto less_sure = [this](std::size_t from, std::size_t to, double together, double each) {
        for (std::size_t i = from; i < to; ++i)
            for (std::size_t j = from; j < to; ++j) covariance_[i][j] += square(together) + (i == j ? square(each) : 0);
    };
    less_sure(kScale, kDelay, kSince * kScaleDoubt, kSince * kScaleDoubt);
    less_sure(kDelay, kStates, kSince * kDelayDoubt, kSince * kDelayDoubt);
    noise_ = before.noise;
    jitter_ = before.jitter;
    keep_within_bounds();
}

LearnedPointing LearningFilter::learned() const noexcept {
    LearnedPointing learned{judged_, noise_, jitter_, {}, {}};
    for (std::size_t i = kDrift; i < kStates; ++i) {
        learned.values[i - kDrift] = state_[i];
        for (std::size_t j = kDrift; j < kStates; ++j) learned.covariance[i - kDrift][j - kDrift] = covariance_[i][j];
    }
    return learned;
}

double LearningFilter::scale(double speed) const noexcept {
    const auto w = weights_at(kScaleSpeeds, speed);
    return (1 - w.upper_share) * state_[kScale + w.lower] + w.upper_share * state_[kScale + w.lower + 1];
}

double LearningFilter::delay(double speed) const noexcept {
    const auto w = weights_at(kDelaySpeeds, speed);
    return (1 - w.upper_share) * state_[kDelay + w.lower] + w.upper_share * state_[kDelay + w.lower + 1];
}

double LearningFilter::heading(const LearningMoment& now) const noexcept {
    double heading = state_[kHeading] + state_[kDrift] * (now.length - anchor_.length) +
                     state_[kUnlike] * (now.across - anchor_.across) / apart_;
    for (std::size_t k = 0; k < kScaleSpeeds.size(); ++k) heading += state_[kScale + k] * (now.turns[k] - anchor_.turns[k]);
    return heading - (now.turned - anchor_.turned);
}

// From the anchor, in the axes of the odometry.
Point LearningFilter::way_to(const LearningMoment& moment) const noexcept {
    Point way{moment.arm.x - anchor_.arm.x, moment.arm.y - anchor_.arm.y};
    for (std::size_t k = 0; k < kScaleSpeeds.size(); ++k) {
        way.x += state_[kScale + k] * (moment.ways[k].x - anchor_.ways[k].x);
        way.y += state_[kScale + k] * (moment.ways[k].y - anchor_.ways[k].y);
    }
    return way;
}

Point LearningFilter::place(const LearningMoment& now) const noexcept {
    const Point way = turned(way_to(now), (state_[kHeading] + heading(now)) / 2);
    return {state_[kX] + way.x, state_[kY] + way.y};
}

// The anchor becomes another moment, earlier or later.
void LearningFilter::go_to(const LearningMoment& moment) noexcept {
    const double angle = (state_[kHeading] + heading(moment)) / 2;
    const Point way = turned(way_to(moment), angle);
    const double length = moment.length - anchor_.length, across = (moment.across - anchor_.across) / apart_;
    const double twisted = moment.twisted - anchor_.twisted;
    // Rows of the transition that are not those of the identity: x, y and the heading.
    std::array<std::array<double, kStates>, 3> rows{};
    for (std::size_t i = 0; i < 3; ++i) rows[i][i] = 1;
    rows[kX][kHeading] = -way.y;
    rows[kY][kHeading] = way.x;
    for (std::size_t k = 0; k < kScaleSpeeds.size(); ++k) {
        const Point part = turned({moment.ways[k].x - anchor_.ways[k].x, moment.ways[k].y - anchor_.ways[k].y}, angle);
        rows[kX][kScale + k] = part.x;
        rows[kY][kScale + k] = part.y;
        rows[kHeading][kScale + k] = moment.turns[k] - anchor_.turns[k];
    }
    rows[kHeading][kDrift] = length;
    rows[kHeading][kUnlike] = across;
    auto& p = covariance_;
    std::array<std::array<double, kStates>, 3> left{};  // rows of F P
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < kStates; ++k)
            if (rows[i][k] != 0)
                for (std::size_t j = 0; j < kStates; ++j) left[i][j] += rows[i][k] * p[k][j];
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 3; j < kStates; ++j) p[i][j] = p[j][i] = left[i][j];
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j <= i; ++j) {
            double sum = 0;
            for (std::size_t k = 0; k < kStates; ++k) sum += left[i][k] * rows[j][k];
            p[i][j] = p[j][i] = sum;
        }
    const double walked = std::abs(length), passed = std::clamp(moment.time - anchor_.time, 0.0, 1.0);
    p[kX][kX] += kPlaceChange * walked;
    p[kY][kY] += kPlaceChange * walked;
    p[kHeading][kHeading] += kHeadingChange * walked + kTurnChange * std::abs(twisted);
    for (std::size_t i = kScale; i < kDelay; ++i) p[i][i] += kScaleChange * walked;
    for (std::size_t i = kDelay; i < kStates; ++i) p[i][i] += kDelayChange * passed;
    state_[kX] += way.x;
    state_[kY] += way.y;
    state_[kHeading] = heading(moment);
    anchor_ = moment;
}

void LearningFilter::let_go_of_place() noexcept {
    for (const std::size_t i : {kX, kY})
        for (std::size_t j = 0; j < kStates; ++j) covariance_[i][j] = covariance_[j][i] = 0;
    covariance_[kX][kX] = covariance_[kY][kY] = kUnplaced;
}

bool LearningFilter::overlay(const OverlaySample& sample, const History<LearningMoment>& past) noexcept {
    const bool blind = past.empty() || sample.time - past.newest().time > kStale;
    double speed = 0, doubt = 0;
    LearningMoment seen = anchor_;
    Point velocity;
    if (!past.empty()) {
        double late = kDelay0;
        for (int round = 0; round < (judged_ > 0 ? 8 : 1); ++round) {
            speed = speed_at(past, sample.time - judged_ * late);
            late = delay(speed);
        }
        doubt = std::abs(late - delay(speed_at(past, sample.time - judged_ * late - kJudging)));
        const double time = sample.time - late;
        const auto w = weights_at(kDelaySpeeds, speed);
        const auto p = [&](std::size_t i, std::size_t j) { return covariance_[kDelay + w.lower + i][kDelay + w.lower + j]; };
        const double lower = 1 - w.upper_share, upper = w.upper_share;
        const double unsure = std::max(0.0, lower * lower * p(0, 0) + 2 * lower * upper * p(0, 1) + upper * upper * p(1, 1));
        // The dependence of the place on time, over all possible times: at first the delay is uncertain.
        const double spread = std::clamp(std::sqrt(unsure + square(jitter_) + square(doubt)), 0.002, 0.1);
        seen = moment_at(past, time);
        const Point before = place(moment_at(past, time - spread)), after = place(moment_at(past, time + spread));
        velocity = {(after.x - before.x) / (2 * spread), (after.y - before.y) / (2 * spread)};
    }
    go_to(seen);
    if (blind || !placed_) let_go_of_place();
    if (!correct(sample.at, velocity, weights_at(kDelaySpeeds, speed), doubt, false)) {
        if (++rejected_ < kMostRejected) return false;
        // It is not the overlay that is wrong: the mouse was lifted, or what was learned is no longer so.
        ++resets_;
        let_go_of_place();
        covariance_[kHeading][kHeading] += square(kHeadingDoubt);
        for (std::size_t i = kScale; i < kDelay; ++i) covariance_[i][i] += square(0.2 * kScaleDoubt);
        for (std::size_t i = kDelay; i < kStates; ++i) covariance_[i][i] += square(0.2 * kDelayDoubt);
        correct(sample.at, velocity, weights_at(kDelaySpeeds, speed), doubt, true);
    }
    rejected_ = 0;
    placed_ = true;
    keep_within_bounds();
    return true;
}

bool LearningFilter::correct(Point told, Point speed, const SpeedWeights<kDelaySpeeds.size()>& weights, double doubt,
                             bool must) noexcept {
    auto& p = covariance_;
    const std::size_t lower = kDelay + weights.lower, upper = lower + 1;
    const double low = 1 - weights.upper_share, up = weights.upper_share;
    const double slope[2] = {-speed.x, -speed.y};
    std::array<std::array<double, 2>, kStates> gain;  // P H', then the gain
    for (std::size_t i = 0; i < kStates; ++i)
        for (std::size_t a = 0; a < 2; ++a) gain[i][a] = p[i][a] + slope[a] * (low * p[i][lower] + up * p[i][upper]);
    const auto seen = [&](std::size_t a, std::size_t b) {
        return gain[a][b] + slope[a] * (low * gain[lower][b] + up * gain[upper][b]);
    };
    const double known[2][2] = {{seen(0, 0), seen(0, 1)}, {seen(1, 0), seen(1, 1)}};
    const double late = square(jitter_) + square(doubt);
    const double sxx = known[0][0] + square(noise_) + late * slope[0] * slope[0];
    const double syy = known[1][1] + square(noise_) + late * slope[1] * slope[1];
    const double sxy = (known[0][1] + known[1][0]) / 2 + late * slope[0] * slope[1];
    const double determinant = sxx * syy - sxy * sxy;
    const double off[2] = {told.x - state_[kX], told.y - state_[kY]};
    if (!(determinant > 0)) return must;
    const double deviation = (syy * off[0] * off[0] - 2 * sxy * off[0] * off[1] + sxx * off[1] * off[1]) / determinant;
    const double fast = std::sqrt(square(speed.x) + square(speed.y));
    if (placed_ && fast > 20 && determinant < kUnplaced)
        surprise_ += kSurpriseForgetting * (std::min(deviation, 2 * kGate) + std::log(determinant) - surprise_);
    // The residual that the states do not explain is noise of the place and, along the movement, jitter. A rejected sample counts
    // as one at the limit; otherwise both estimates would fall with the number of rejections.
    if (determinant < kUnplaced) {
        const double counted = std::min(1.0, kGate / std::max(deviation, 1e-9));
        if (fast < 5) {
            const double left = counted * (square(off[0]) + square(off[1])) / 2 - (known[0][0] + known[1][1]) / 2;
            noise_ =
                std::clamp(std::sqrt(std::max(0.0, square(noise_) + kForgetting * (left - square(noise_)))), kLeastNoise, 5.0);
        } else if (fast > 50) {
            const double ux = slope[0] / fast, uy = slope[1] / fast;
            const double left = counted * square(off[0] * ux + off[1] * uy) - ux * ux * known[0][0] - uy * uy * known[1][1] -
                                ux * uy * (known[0][1] + known[1][0]) - square(noise_);
            jitter_ = std::clamp(
                std::sqrt(std::max(0.0, square(jitter_) + kForgetting * (left / square(fast) - square(doubt) - square(jitter_)))),
                kLeastJitter, 0.03);
        }
    }
    if (!must && !(deviation < kGate)) return false;
    const auto parts = gain;
    for (std::size_t i = 0; i < kStates; ++i) {
        gain[i][0] = (parts[i][0] * syy - parts[i][1] * sxy) / determinant;
        gain[i][1] = (parts[i][1] * sxx - parts[i][0] * sxy) / determinant;
    }
    for (std::size_t i = 0; i < kStates; ++i) state_[i] += gain[i][0] * off[0] + gain[i][1] * off[1];
    for (std::size_t i = 0; i < kStates; ++i)
        for (std::size_t j = 0; j <= i; ++j)
            p[i][j] = p[j][i] = (p[i][j] + p[j][i]) / 2 - (gain[i][0] * parts[j][0] + gain[i][1] * parts[j][1]);
    return true;
}

void LearningFilter::keep_within_bounds() noexcept {
    for (std::size_t i = kScale; i < kDelay; ++i) state_[i] = std::clamp(state_[i], 0.1, 3.0);
    for (std::size_t i = kDelay; i < kStates; ++i) state_[i] = std::clamp(state_[i], 0.0, 0.5);
    bool whole = true;
    for (std::size_t i = 0; i < kStates; ++i)
        whole = whole && std::isfinite(state_[i]) && covariance_[i][i] >= 0 && std::isfinite(covariance_[i][i]);
    if (whole) return;
    begin();
    ++resets_;
}

}  // namespace tactics
