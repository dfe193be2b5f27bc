// SPDX-License-Identifier: Apache-2.0
#include "tactics/coding/deadband.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "tactics/point3.h"

namespace tactics {

namespace {

constexpr std::int64_t kSlopeParts = 256;

Point3 real(const Steps3& steps) {
    return {static_cast<double>(steps.x), static_cast<double>(steps.y), static_cast<double>(steps.z)};
}

Steps3 nearest(const Point3& point) { return {std::llround(point.x), std::llround(point.y), std::llround(point.z)}; }

double work_of(const Steps3& guess, const Steps3& force, const Steps3& from, const Steps3& to) {
    return dot(real(guess) - real(force), real(to) - real(from));
}

// What the forces of a part, and the ways between its places, allow a guess.
class Allowed {
public:
    Allowed(std::span<const Steps3> forces, std::span<const Steps3> places, const Deadband& deadband)
        : forces_(forces), places_(places), deadband_(deadband) {}

    std::size_t ticks() const { return forces_.size(); }
    const Steps3& force(std::size_t tick) const { return forces_[tick]; }
    bool takes(const Steps3& guess, std::size_t tick, double added) const {
        const Steps3& force = forces_[tick];
        if (guess == force) return true;
        const double threshold = std::max(deadband_.share * length_of(real(force)), deadband_.floor);
        return length_of(real(guess) - real(force)) <= threshold && after(guess, tick, added) <= deadband_.allowance;
    }
    // The most work that has been added from any tick until behind this one.
    double after(const Steps3& guess, std::size_t tick, double added) const {
        const Steps3 &from = places_[tick], &to = places_[std::min(tick + 1, places_.size() - 1)];
        return std::max(added, 0.0) + work_of(guess, forces_[tick], from, to);
    }
    // How many ticks from this one on the receiver may go by what it is told now, at most so many; 0: not even this one.
    std::size_t lasting(const ForceTold& told, std::size_t tick, double added, std::size_t most) const {
        GuessedForce guessed;
        guessed.tell(told);
        std::size_t lasts = 0;
        for (; lasts < most && takes(guessed.now(), tick + lasts, added); ++lasts, guessed.tick())
            added = after(guessed.now(), tick + lasts, added);
        return lasts;
    }

private:
    std::span<const Steps3> forces_, places_;
    const Deadband& deadband_;
};

// The middle of the box that holds them.
ForceTold middle_of(std::span<const Steps3> forces) {
    Steps3 low = forces.front(), high = low;
    for (const Steps3& force : forces) {
        low = {std::min(low.x, force.x), std::min(low.y, force.y), std::min(low.z, force.z)};
        high = {std::max(high.x, force.x), std::max(high.y, force.y), std::max(high.z, force.z)};
    }
    return {{(low.x + high.x) / 2, (low.y + high.y) / 2, (low.z + high.z) / 2}, {}};
}

// The line through them, by least squares.
ForceTold line_of(std::span<const Steps3> forces) {
    const auto count = static_cast<double>(forces.size());
    const double middle = (count - 1) / 2, squares = count * (count * count - 1) / 12;
    Point3 mean, tilt;
    for (std::size_t i = 0; i < forces.size(); ++i) {
        const Point3 force = real(forces[i]);
        mean = mean + 1 / count * force;
        tilt = tilt + (static_cast<double>(i) - middle) * force;
    }
    const Point3 slope = squares > 0 ? 1 / squares * tilt : Point3{};
    return {nearest(mean - middle * slope), nearest(static_cast<double>(kSlopeParts) * slope)};
}

// What the receiver can go by for longest: of what fits the next forces, twice as many until it fails, then half as many more,
// and so on. Without a force it is told that there is none.
ForceTold told_of(const Allowed& allowed, std::span<const Steps3> ahead, std::size_t tick, double added, ForceGuess guess) {
    ForceTold best{allowed.force(tick), {}};
    if (best.force == Steps3{}) return best;
    std::size_t lasts = allowed.lasting(best, tick, added, ahead.size());
    const auto fits = [&](std::size_t count) {
        bool all = false;
        const auto consider = [&](const ForceTold& told) {
            const std::size_t now = allowed.lasting(told, tick, added, ahead.size());
            all = all || now >= count;
            if (now <= lasts) return;
            best = told;
            lasts = now;
        };
        consider(middle_of(ahead.first(count)));
        if (guess == ForceGuess::linear) consider(line_of(ahead.first(count)));
        return all;
    };
    std::size_t good = 1, bad = 2;
    while (bad <= ahead.size() && fits(bad)) good = std::exchange(bad, 2 * bad);
    for (bad = std::min(bad, ahead.size() + 1); bad - good > 1;) {
        const std::size_t middle = good + (bad - good) / 2;
        (fits(middle) ? good : bad) = middle;
    }
    return best;
}

}  // namespace

Steps3 GuessedForce::now() const noexcept {
    const auto moved = [this](std::int64_t force, std::int64_t slope) { return force + slope * since_ / kSlopeParts; };
    return {moved(told_.force.x, told_.slope.x), moved(told_.force.y, told_.slope.y), moved(told_.force.z, told_.slope.z)};
}

std::vector<ToldAt> forces_told(std::span<const Steps3> forces, std::span<const Steps3> places, const Deadband& deadband,
                                double& added) {
    const Allowed allowed(forces, places, deadband);
    std::vector<ToldAt> all;
    GuessedForce guessed;
    for (std::size_t tick = 0; tick < forces.size(); ++tick, guessed.tick()) {
        if (tick == 0 || !allowed.takes(guessed.now(), tick, added)) {
            const ForceTold told = told_of(allowed, forces.subspan(tick), tick, added, deadband.guess);
            guessed.tell(told);
            all.push_back({tick, told});
        }
        added = allowed.after(guessed.now(), tick, added);
    }
    return all;
}

}  // namespace tactics
