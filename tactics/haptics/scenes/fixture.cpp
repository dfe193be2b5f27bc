// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/scenes/fixture.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tactics {

namespace {

constexpr std::array<NamedFixture, 4> kFixtures = {{
    {"r2", "exponential halves", {}},
    {"r1", "logistic halves, the more likely reading of the paper", {FixtureForm::r1, 1.5, 10, 4, 1.2, 1.6, 6}},
    {"linear", "straight halves around a core", {FixtureForm::linear, 1.5, 10, 0, 0.5, 0, 2.5}},
    {"rod", "a thin solid cylinder, which is hard to follow", {FixtureForm::rod, 1, 1, 0, 0, 0, 0}},
}};

double logistic(double u) noexcept { return 1 / (1 + std::exp(-u)); }

// R1: C [S(k1(d-l1)) - S(-k1 l1)] / [1 - S(-k1 l1)] * [S(k2(l2-d)) - S(k2(l2-r))] / [S(k2 l2) - S(k2(l2-r))].
double r1(const FixtureSettings& f, double d) noexcept {
    const double least = logistic(-f.k1 * f.l1), end = logistic(f.k2 * (f.l2 - f.radius));
    const double near = (logistic(f.k1 * (d - f.l1)) - least) / (1 - least);
    return f.strength * near * (logistic(f.k2 * (f.l2 - d)) - end) / (logistic(f.k2 * f.l2) - end);
}

double r2_whole(const FixtureSettings& f, double d) noexcept {
    return f.strength * -std::expm1(-std::pow(d / f.l1, f.k1)) * std::exp(-std::pow(d / f.l2, f.k2));
}

// R2: C (1 - exp(-(d/l1)^k1)) exp(-(d/l2)^k2), less its value at the radius times (d/r)^2.
double r2(const FixtureSettings& f, double d) noexcept {
    const double share = d / f.radius;
    return r2_whole(f, d) - r2_whole(f, f.radius) * share * share;
}

double linear(const FixtureSettings& f, double d) noexcept {
    if (d <= f.l1) return 0;
    return f.strength * (d < f.l2 ? (d - f.l1) / (f.l2 - f.l1) : (f.radius - d) / (f.radius - f.l2));
}

}  // namespace

std::span<const NamedFixture> fixtures() { return kFixtures; }

double pull(const FixtureSettings& fixture, double distance) noexcept {
    if (!(distance > 0 && distance < fixture.radius)) return 0;
    switch (fixture.form) {
        case FixtureForm::r1: return r1(fixture, distance);
        case FixtureForm::r2: return r2(fixture, distance);
        case FixtureForm::linear: return linear(fixture, distance);
        case FixtureForm::rod: return -fixture.strength * (1 - distance / fixture.radius);
    }
    return 0;
}

FixtureSlopes slopes_of(const FixtureSettings& fixture) {
    constexpr int kSteps = 2000;
    const double step = fixture.radius / kSteps;
    FixtureSlopes slopes;
    // A rod's jump in its middle is no slope: no finger stays there.
    for (int i = fixture.form == FixtureForm::rod ? 2 : 1; i <= kSteps; ++i) {
        const double slope = (pull(fixture, i * step) - pull(fixture, (i - 1) * step)) / step;
        slopes.rise = std::max(slopes.rise, slope);
        slopes.fall = std::max(slopes.fall, -slope);
    }
    return slopes;
}

}  // namespace tactics
