// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/scenes/wall.h"

#include <algorithm>
#include <cmath>

namespace tactics {

namespace {

constexpr NamedWall kWalls[] = {
    {"raw", WallMethod::raw, "the height as it is"},
    {"steps", WallMethod::steps, "steps 1 mm wide and 20 mm high, as in the paper"},
    {"rate-limit", WallMethod::rate_limit, "a height that changes by at most 400 mm/s"},
    {"governor", WallMethod::governor, "a height that moves no faster than the motor can lift the finger"},
    {"look-ahead", WallMethod::look_ahead, "the same, begun early enough before the edge to finish at it"},
    {"slope", WallMethod::slope, "a steep slope from the edge on, while the eye sees the wall"},
};

// A hand that slows down is taken to stop at least this hard: a hand that stops before a wall brakes so (assumed).
constexpr double kBraking = 2500;  // mm/s2
constexpr double kSlowing = 0.2;   // mm/s below the fastest of late that are no noise
constexpr double kOfLate = 0.15;   // s
constexpr double kShort = 0.1;     // mm beyond the edge that still count as stopping before it
constexpr double kWorth = 3;       // mm; a lower rise is over before it could be foreseen
constexpr int kLooks = 16;         // at the surface ahead, a tick
constexpr int kHalvings = 6;       // of the last of them, to find the edge
constexpr double kSteep = 4;       // mm up for a mm sideways: it is still the wall that rises
constexpr double kClimb = 0.25;    // mm from one look at it to the next
constexpr double kWidest = 3;      // mm
constexpr double kRiseStep = 5;    // mm from one of the rises tried to the next
constexpr double kGround = 5;      // mm above the lower stop, on which they are tried
constexpr double kHighWall = 40;   // mm
constexpr double kLongest = 0.2;   // s
constexpr int kNoticed = 1;        // ticks until a hand that brakes is seen to brake
constexpr double kBehind = 1.0;    // ticks from the reference to the lever, besides the delay
constexpr double kSlowest = 5;     // mm/s: below, a direction is noise

double length(Point a) { return std::sqrt(a.x * a.x + a.y * a.y); }

bool governed(WallMethod method) {
    return method == WallMethod::governor || method == WallMethod::look_ahead || method == WallMethod::slope;
}

double within(double height, double of, double most) { return std::clamp(height, of - most, of + most); }

double in_the_air(const void* height, Point) noexcept { return *static_cast<const double*>(height); }

// A lever that follows a wall's reference, while nothing moves sideways.
class Trial {
public:
    Trial(const WallSettings& settings, Wall wall, double ground)
        : settings_(settings),
          wall_(wall),
          lever_(settings.lever, settings.finger, ground - hangs(settings)),
          before_(lever_.height()) {
        wall_.reference({&ground, in_the_air}, {}, {}, 1 / settings.lever.rate_hz);  // where it begins
    }
    void tick(double target) noexcept {
        const double dt = 1 / settings_.lever.rate_hz, height = lever_.height();
        const double reference = wall_.reference({&target, in_the_air}, {}, {}, dt);
        lever_.push(wall_force(settings_, wall_, reference, height, before_, dt));
        before_ = height;
        lever_.advance(dt);
        time_ += dt;
    }
    double height() const { return lever_.true_height(); }
    double time() const { return time_; }

private:
    const WallSettings& settings_;
    Wall wall_;
    SimulatedLever lever_;
    double before_ = 0, time_ = 0;
};

}  // namespace

double hangs(const WallSettings& settings) { return Governor(settings.lever, settings.finger, settings.law.stiffness).hang(); }

std::span<const NamedWall> wall_methods() { return kWalls; }

std::optional<WallMethod> wall_method(std::string_view name) {
    for (const NamedWall& wall : kWalls)
        if (wall.name == name) return wall.method;
    return std::nullopt;
}

Wall::Wall(const WallSettings& settings, WallMethod method)
    : settings_(settings), governor_(settings.lever, settings.finger, settings.law.stiffness), governs_(governed(method)) {
    settings_.method = method;
}

Wall::Wall(const WallSettings& settings) : Wall(settings, settings.method) {
    if (settings.method != WallMethod::look_ahead) return;
    for (std::size_t i = 1; i < kRises; ++i) half_times_[i] = time_to_rise(static_cast<double>(i) * kRiseStep);
    may_err_ = time_to_change_its_mind();
}

// The response of the lever to the reference, measured on the simulated lever.
double Wall::time_to_rise(double rise) const {
    double ground = settings_.lever.lowest + kGround;
    Trial trial(settings_, Wall(settings_, WallMethod::governor), ground);
    ground += rise;
    while (trial.height() < ground - rise / 2 && trial.time() < kLongest) trial.tick(ground);
    return trial.time();
}

double Wall::time_to_change_its_mind() const {
    const double ground = settings_.lever.lowest + kGround;
    const double wall = std::min(settings_.lever.highest, ground + kHighWall);
    const double dt = 1 / settings_.lever.rate_hz;
    for (int ticks = 1; ticks * dt < kLongest; ++ticks) {
        Trial trial(settings_, Wall(settings_, WallMethod::governor), ground);
        double top = trial.height();
        for (int tick = 0; trial.time() < ticks * dt + kLongest; ++tick) {
            trial.tick(tick < ticks ? wall : ground);
            top = std::max(top, trial.height());
        }
        if (top > ground + settings_.most_bump) return (ticks - 1 - kNoticed) * dt;
    }
    return kLongest;
}

double Wall::time_to_half(double rise) const noexcept {
    const double place = std::clamp(rise / kRiseStep, 0.0, static_cast<double>(kRises - 1));
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, kRises - 1);
    const double part = place - static_cast<double>(below);
    return half_times_[below] * (1 - part) + half_times_[above] * part;
}

// At most the height of a step within the width of a step.
double Wall::stepped(double height, double moved) noexcept {
    since_step_ += moved;
    if (since_step_ >= settings_.step_width) since_step_ = stepped_ = 0;
    const double left = std::max(0.0, settings_.step_height - stepped_);
    const double rise = std::clamp(height - target_, -left, left);
    if (stepped_ == 0 && rise != 0) since_step_ = 0;
    stepped_ += std::abs(rise);
    return target_ + rise;
}

// The lever is where the reference was when the force was set that moves it now.
void Wall::remember() noexcept {
    past_[now_ % kPast] = {governor_.height(), governor_.velocity()};
    const double ticks = std::min(settings_.lever.delay * settings_.lever.rate_hz + kBehind, static_cast<double>(kPast - 2));
    const auto whole = static_cast<std::size_t>(ticks);
    const double part = ticks - static_cast<double>(whole);
    const auto back = [&](std::size_t by) { return past_[(now_ + kPast - std::min(by, now_)) % kPast]; };
    const Past late = back(whole), later = back(whole + 1);
    reference_ = governor_.under_way() ? late.height * (1 - part) + later.height * part : governor_.height();
    velocity_ = governor_.under_way() ? late.velocity * (1 - part) + later.velocity * part : 0;
    ++now_;
}

// The nearest rise ahead that must begin now, so that half of it is felt `late` mm after its edge.
std::optional<Wall::Ahead> Wall::look(HeightSampler surface, Point at, Point velocity, double here) const noexcept {
    const double speed = length(velocity);
    if (speed < kSlowest) return std::nullopt;
    // Nearer than this a hand that is still at full speed cannot stop before the wall, or is noticed to stop in time.
    const double sure = speed * speed / (2 * kBraking) + settings_.nearest_stop + speed * may_err_;
    const double reach = std::min(sure, speed * half_times_.back() - settings_.late);
    if (reach <= 0) return std::nullopt;
    const auto place = [&](double distance) {
        return Point{at.x + velocity.x / speed * distance, at.y + velocity.y / speed * distance};
    };
    for (int i = 1; i <= kLooks; ++i) {
        double far = reach * i / kLooks;
        double height = surface(place(far));
        if (!(height - here >= kWorth)) continue;
        // In a map a wall has its foot and its top some samples apart.
        double end = far;
        for (const double widest = far + kWidest; end < widest; end += kClimb) {
            const double next = surface(place(end + kClimb));
            if (!(next - height >= kSteep * kClimb)) break;
            height = next;
        }
        double near = reach * (i - 1) / kLooks;
        far = end;
        for (int n = 0; n < kHalvings; ++n) {
            const double middle = (near + far) / 2;
            (surface(place(middle)) - here >= (height - here) / 2 ? far : near) = middle;
        }
        if (far > speed * time_to_half(height - here) - settings_.late) return std::nullopt;
        return Ahead{place(far), height, end - far};
    }
    return std::nullopt;
}

// A hand that turns may not come to it any more.
bool Wall::still_comes(HeightSampler surface, double here, Point at, Point velocity, double left) const noexcept {
    const double share = left / length(velocity);
    return surface({at.x + share * velocity.x, at.y + share * velocity.y}) - here >= (ahead_->height - here) / 2;
}

double Wall::foreseen(HeightSampler surface, double here, Point at, Point velocity, double dt, double doubt) noexcept {
    const double speed = length(velocity);
    fastest_ = std::max(speed, fastest_ - fastest_ * std::min(1.0, dt / kOfLate));
    slowing_ = speed < fastest_ - std::max(kSlowing, doubt);
    if (!ahead_) ahead_ = look(surface, at, velocity, here);
    if (!ahead_) return here;
    const double distance = speed > 0 ? ((ahead_->edge.x - at.x) * velocity.x + (ahead_->edge.y - at.y) * velocity.y) / speed : 0;
    const bool stops_short = slowing_ && speed * speed / (2 * kBraking) < distance + kShort;
    const double left = distance + ahead_->to_top;
    const bool passed = left <= 0;
    if (passed || stops_short || speed < kSlowest || !still_comes(surface, here, at, velocity, left)) {
        ahead_.reset();
        return here;
    }
    return std::max(here, ahead_->height);
}

double Wall::reference(HeightSampler surface, Point at, Point velocity, double dt, double doubt) noexcept {
    if (!(dt > 0) || !std::isfinite(length(at))) return reference_;
    if (!std::isfinite(length(velocity))) velocity = {};
    double here = surface(at);
    if (!begun_) {
        if (!std::isfinite(here)) return here;  // no force comes of it
        begun_ = true;
        before_ = at;
        target_ = reference_ = here;
        governor_.begin(here);
    }
    if (!std::isfinite(here)) here = target_;  // a hole in the map is bridged
    const double moved = length({at.x - before_.x, at.y - before_.y});
    before_ = at;
    switch (settings_.method) {
        case WallMethod::raw:
        case WallMethod::governor: target_ = here; break;
        case WallMethod::steps: target_ = stepped(here, moved); break;
        case WallMethod::rate_limit: target_ = within(here, target_, settings_.rate * dt); break;
        case WallMethod::slope: target_ = within(here, target_, settings_.slope * moved); break;
        case WallMethod::look_ahead: target_ = foreseen(surface, here, at, velocity, dt, doubt); break;
    }
    reference_ = target_;
    if (governs_) {
        governor_.follow(target_, dt);
        remember();
    }
    return reference_;
}

double wall_force(const WallSettings& settings, const Wall& wall, double reference, double finger, double finger_before,
                  double dt) noexcept {
    if (!wall.couples()) return std::min(force(settings.law, reference, finger, finger_before, dt), settings.lever.most_force);
    const double held = coupling_force(settings.law, reference, finger, finger_before, dt);
    const double sum = held + wall.lead() + settings.law.damping_ns_per_m / 1000 * wall.velocity();
    return std::isfinite(sum) ? std::clamp(sum, -settings.lever.most_force, settings.lever.most_force) : 0;
}

}  // namespace tactics
