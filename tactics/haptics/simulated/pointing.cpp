// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/simulated/pointing.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "tactics/measure/random.h"

namespace tactics {

namespace {

constexpr double kSpeedingUp = 0.2;  // s
constexpr double kRest = 0.5;        // s, after a stroke
constexpr double kSwayPeriod = 3.7;  // s
constexpr double kOverlayPeriod = 1.0 / 60;
constexpr double kWide = 600, kHigh = 400;  // mm, the table
constexpr double kSlow = 100, kFast = 250;  // mm/s: between these speed begins to matter, and is whole

// Position along its line and speed at time `t` after its beginning.
struct Along {
    double way, speed;
};

double steady_time(const PointingStroke& s) {
    const double rest = distance(s.from, s.to) - s.speed * kSpeedingUp / 2 - s.speed * s.speed / (2 * s.deceleration);
    return std::max(0.0, rest / s.speed);
}

double whole_time(const PointingStroke& s) { return kSpeedingUp + steady_time(s) + s.speed / s.deceleration; }

Along along(const PointingStroke& s, double t) {
    if (t <= 0) return {0, 0};
    if (t < kSpeedingUp) {
        // The first half of a minimum-jerk velocity would not end steady: this one is the minimum-jerk change of a velocity.
        const double u = t / kSpeedingUp, u3 = u * u * u;
        return {s.speed * kSpeedingUp * u3 * u * (2.5 - 3 * u + u * u), s.speed * u3 * (10 - 15 * u + 6 * u * u)};
    }
    const double left = whole_time(s) - t;
    if (left <= 0) return {distance(s.from, s.to), 0};
    if (left < s.speed / s.deceleration)
        return {distance(s.from, s.to) - s.deceleration * left * left / 2, s.deceleration * left};
    return {s.speed * (kSpeedingUp / 2 + t - kSpeedingUp), s.speed};
}

Point direction(const PointingStroke& s) {
    const double whole = distance(s.from, s.to);
    return whole > 0 ? Point{(s.to.x - s.from.x) / whole, (s.to.y - s.from.y) / whole} : Point{};
}

double dot(Point a, Point b) { return a.x * b.x + a.y * b.y; }

Point turned(Point p, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * p.x - s * p.y, s * p.x + c * p.y};
}

// A place on the table so far away, in a direction by chance.
Point away(Point from, double length, RandomNumbers& chance) {
    for (;;) {
        const Point way = turned({length, 0}, 2 * std::numbers::pi * chance.uniform());
        const Point to{from.x + way.x, from.y + way.y};
        if (to.x >= 0 && to.x <= kWide && to.y >= 0 && to.y <= kHigh) return to;
    }
}

double fastness(double speed) { return std::max(0.0, (speed - kSlow) / (kFast - kSlow)); }

double norm(Point p) { return std::sqrt(dot(p, p)); }

// The time at which the finger was at the place of a sample that arrives at `time`.
double seen_at(const Pointing& pointing, const PointingCauses& causes, double time, double jitter) {
    double delay = causes.delay;
    // The speed is that of a time that depends on the delay; where this does not settle, the overlay hesitates as well.
    for (int round = 0; round < 20; ++round)
        delay = causes.delay - causes.quicker * std::min(1.0, fastness(norm(pointing.at(time - causes.judged * delay).velocity)));
    return time - delay - jitter;
}

double rounded(double moved, double counts_per_mm, double& rest) {
    if (counts_per_mm <= 0) return moved;
    const double wanted = moved * counts_per_mm + rest, counts = std::nearbyint(wanted);
    rest = wanted - counts;
    return counts / counts_per_mm;
}

// The smoothing of touch screens: a low pass that weakens as the finger gets faster (G. Casiez, N. Roussel, D. Vogel, CHI
// 2012).
struct OneEuro {
    double time_constant;  // s, at rest
    bool begun = false;
    Point at{}, speed{}, before{};

    Point next(Point raw) {
        if (!begun) at = before = raw;
        begun = true;
        // The paper's 1 Hz for the speed.
        const double share = kOverlayPeriod / (kOverlayPeriod + 1 / (2 * std::numbers::pi));
        speed = {speed.x + share * ((raw.x - before.x) / kOverlayPeriod - speed.x),
                 speed.y + share * ((raw.y - before.y) / kOverlayPeriod - speed.y)};
        before = raw;
        const double late = time_constant / (1 + norm(speed) / kSlow), take = kOverlayPeriod / (kOverlayPeriod + late);
        at = {at.x + take * (raw.x - at.x), at.y + take * (raw.y - at.y)};
        return at;
    }
};

// The movement of a body from one pose to the next, in its own axes, as if it went on a circle at even speed.
struct Screw {
    Point moved;
    double turn;
};

Screw between(const Pose& a, const Pose& b) {
    const double turn = b.heading - a.heading, half = turn / 2;
    const double stretch = std::abs(half) < 1e-9 ? 1 : half / std::sin(half);
    const Point straight = turned({b.at.x - a.at.x, b.at.y - a.at.y}, -(a.heading + half));
    return {{straight.x * stretch, straight.y * stretch}, turn};
}

}  // namespace

Pointing::Pointing(std::vector<PointingStroke> strokes, double heading, double sway)
    : strokes_(std::move(strokes)), heading_(heading), sway_(sway) {}

double Pointing::stop(std::size_t stroke) const { return strokes_[stroke].begin + whole_time(strokes_[stroke]); }

double Pointing::end() const { return strokes_.empty() ? 0 : stop(strokes_.size() - 1) + kRest; }

Pose Pointing::at(double time) const {
    Pose pose;
    pose.heading = heading_ + sway_ * std::sin(2 * std::numbers::pi * time / kSwayPeriod);
    if (strokes_.empty()) return pose;
    const auto after =
        std::upper_bound(strokes_.begin(), strokes_.end(), time, [](double t, const PointingStroke& s) { return t < s.begin; });
    const PointingStroke& stroke = after == strokes_.begin() ? strokes_.front() : *(after - 1);
    const Along now = along(stroke, time - stroke.begin);
    const Point way = direction(stroke);
    pose.at = {stroke.from.x + way.x * now.way, stroke.from.y + way.y * now.way};
    pose.velocity = {way.x * now.speed, way.y * now.speed};
    return pose;
}

Pointing straight_strokes(int count, double speed, double deceleration, std::uint64_t seed, double heading, double sway) {
    RandomNumbers chance(seed);
    std::vector<PointingStroke> strokes;
    Point at{kWide / 2, kHigh / 2};
    double time = kRest;
    for (int i = 0; i < count; ++i) {
        strokes.push_back({time, at, away(at, std::max(150.0, 0.8 * speed), chance), speed, deceleration});
        at = strokes.back().to;
        time += whole_time(strokes.back()) + kRest;
    }
    return {std::move(strokes), heading, sway};
}

Pointing to_and_fro(Point from, Point to, double speed, double seconds) {
    constexpr double kDeceleration = 2500;  // mm/s2
    while (speed * kSpeedingUp / 2 + speed * speed / (2 * kDeceleration) > distance(from, to)) speed *= 0.9;
    std::vector<PointingStroke> strokes;
    for (double time = kRest; time < seconds;) {
        strokes.push_back({time, from, to, speed, kDeceleration});
        time += whole_time(strokes.back()) + kRest;
        std::swap(from, to);
    }
    return {std::move(strokes), 0, 0};
}

Pointing random_strokes(int count, std::uint64_t seed, double heading, double sway) {
    RandomNumbers chance(seed);
    const auto within = [&](double least, double most) { return least + (most - least) * chance.uniform(); };
    std::vector<PointingStroke> strokes;
    Point at{kWide / 2, kHigh / 2};
    double time = kRest;
    for (int i = 0; i < count; ++i) {
        const double length = within(40, 300), deceleration = within(2500, 10000);
        double speed = within(40, 400);
        // Short ones do not get as fast as long ones.
        while (speed * kSpeedingUp / 2 + speed * speed / (2 * deceleration) > length) speed *= 0.9;
        strokes.push_back({time, at, away(at, length, chance), speed, deceleration});
        at = strokes.back().to;
        time += whole_time(strokes.back()) + within(0.1, 0.5);
    }
    return {std::move(strokes), heading, sway};
}

PointingCauses all_causes() {
    PointingCauses causes;
    causes.scale = 1.04;
    causes.delay = 0.13;
    causes.jitter = 0.008;
    causes.noise = 0.7;
    causes.acceleration = 1.4;
    causes.heading_drift = 2e-5;
    return causes;
}

Sensed sense(const Pointing& pointing, const MouseGeometry& geometry, const PointingCauses& causes, std::uint64_t seed,
             double rate) {
    RandomNumbers chance(seed);
    Sensed sensed;
    const auto steps = static_cast<std::size_t>(pointing.end() * rate);
    sensed.steps.reserve(steps);
    // The finger leads the mouse: the sensors are where it says they are.
    const Point finger = geometry.finger;
    Pose before = pointing.at(0);
    double rest[4] = {};
    for (std::size_t i = 1; i <= steps; ++i) {
        const double time = static_cast<double>(i) / rate;
        const Pose now = pointing.at(time);
        const Screw screw = between(before, now);
        before = now;
        const Point middle{screw.moved.x + screw.turn * finger.y, screw.moved.y - screw.turn * finger.x};
        const double turn = screw.turn + causes.heading_drift * norm(screw.moved);
        OpticalStep step{time, middle, middle};
        step.first.y -= turn * geometry.sensors_apart / 2;
        step.second.y += turn * geometry.sensors_apart / 2;
        Point* const both[] = {&step.first, &step.second};
        for (int s = 0; s < 2; ++s) {
            Point& sensor = *both[s];
            const double gain = causes.scale * (s == 1 ? causes.second_scale : 1) *
                                (1 + (causes.acceleration - 1) * fastness(norm(sensor) * rate));
            sensor.x = rounded(sensor.x * gain, causes.counts_per_mm, rest[2 * s]);
            sensor.y = rounded(sensor.y * gain, causes.counts_per_mm, rest[2 * s + 1]);
        }
        sensed.steps.push_back(step);
    }
    OneEuro smoother{causes.smoothing};
    for (double time = kOverlayPeriod; time < pointing.end(); time += kOverlayPeriod) {
        const double jitter = causes.jitter * chance.normals()[0];
        const auto noise = chance.normals();
        const Point at = pointing.at(seen_at(pointing, causes, time, jitter)).at;
        const Point told{at.x + causes.noise * noise[0], at.y + causes.noise * noise[1]};
        sensed.samples.push_back({time, causes.smoothing > 0 ? smoother.next(told) : told});
    }
    return sensed;
}

PointingError pointing_error(Fusion& fusion, const Pointing& pointing, const Sensed& sensed, std::size_t learning) {
    const auto& strokes = pointing.strokes();
    std::vector<double> errors, overshoots(strokes.size(), 0.0);
    std::size_t current = 0;
    double squares = 0;
    tell(fusion, sensed, [&](double time) {
        while (current + 1 < strokes.size() && strokes[current + 1].begin <= time) ++current;
        if (strokes.empty() || current < learning) return;
        const Pose truth = pointing.at(time);
        const Point at = fusion.pose().at;
        if (norm(truth.velocity) > 1) {
            errors.push_back(distance(at, truth.at));
            squares += errors.back() * errors.back();
        }
        if (time > pointing.stop(current) - 0.2) {
            const Point beyond{at.x - strokes[current].to.x, at.y - strokes[current].to.y};
            overshoots[current] = std::max(overshoots[current], dot(beyond, direction(strokes[current])));
        }
    });
    PointingError error;
    error.resets = fusion.resets();
    if (errors.empty()) return error;
    overshoots.erase(overshoots.begin(), overshoots.begin() + static_cast<std::ptrdiff_t>(learning));
    std::sort(overshoots.begin(), overshoots.end());
    std::sort(errors.begin(), errors.end());
    error.overshoot = overshoots[overshoots.size() / 2];
    error.worst_overshoot = overshoots.back();
    error.rms = std::sqrt(squares / static_cast<double>(errors.size()));
    error.most_of_it = errors[errors.size() * 95 / 100];
    return error;
}

}  // namespace tactics
