// SPDX-License-Identifier: Apache-2.0
// Where the finger is said to be, by the paper's method and by the one that learns, with one cause of error after the other.
//     fusion            the table, for people
//     fusion --csv      the same, for programs
//     fusion --speeds   all causes together at 50 to 400 mm/s, as tactics chart draws it:
//                       tactics chart speeds.csv --x "speed (mm/s)" --y "RMS (mm)" --group method -o speeds.pdf
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string_view>
#include <vector>

#include "tactics/haptics/simulated/pointing.h"

namespace tactics {
namespace {

constexpr int kStrokes = 20, kRandomStrokes = 60, kSeeds = 9;
constexpr std::size_t kLearning = 4;  // strokes that do not count
constexpr MouseGeometry kMouse{60, {0, -80}};
constexpr double kRandom = 0;  // instead of a speed

struct Cause {
    const char* name;
    PointingCauses causes;
    double sway = 0;
};

std::vector<Cause> causes() {
    const auto with = [](PointingCauses causes, auto change) {
        change(causes);
        return causes;
    };
    const PointingCauses none,
        mixed = with(none, [](auto&c) { c.scale = 1.04, c.delay = 0.13, c.jitter = 0.008, c.noise = 0.7; }), all = all_causes(),
        counted = with(all, [](auto&c) { c.counts_per_mm = 31.5, c.second_scale = 1.005; });
    return {
        {"none (ideal)", none},
        {"optical scale +4 %", with(none, [](auto& c) { c.scale = 1.04; })},
        {"true delay 0.13 s", with(none, [](auto& c) { c.delay = 0.13; })},
        {"true delay 0.07 s", with(none, [](auto& c) { c.delay = 0.07; })},
        {"overlay jitter 15 ms", with(none, [](auto& c) { c.jitter = 0.015; })},
        {"pointer acceleration x1.5", with(none, [](auto& c) { c.acceleration = 1.5; })},
        {"pointer acceleration x1.8", with(none, [](auto& c) { c.acceleration = 1.8; })},
        {"overlay 80 ms quicker at speed", with(none, [](auto& c) { c.quicker = 0.08; })},
        {"the same, by the speed seen", with(none, [](auto& c) { c.quicker = 0.08, c.judged = 1; })},
        {"heading drift 0.05 rad/m", with(none, [](auto& c) { c.heading_drift = 5e-5; })},
        {"0.07 s + one euro filter 0.08 s", with(none, [](auto& c) { c.delay = 0.07, c.smoothing = 0.08; })},
        {"mixed: 4 %, 0.13 s, 8 ms, 0.7 mm", mixed},
        {"all: mixed, x1.4, 0.02 rad/m", all},
        {"all, 800 dpi, sensors unlike 0.5 %", counted},
        {"all, turning in the hand 0.2 rad", all, 0.2},
        {"all, overlay quicker at speed", with(all, [](auto& c) { c.quicker = 0.08; })},
        {"all, quicker by the speed seen", with(all, [](auto& c) { c.quicker = 0.08, c.judged = 1; })},
    };
}

struct Outcome {
    double overshoot, rms, worst_rms, most_of_it;
    unsigned resets;
};

double median(std::vector<double> values) {
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
    return values[values.size() / 2];
}

Outcome outcome(const Cause& cause, bool learning, double speed, double deceleration) {
    std::vector<double> overshoots, rms, most;
    unsigned resets = 0;
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        const Pointing pointing = speed == kRandom ? random_strokes(kRandomStrokes, 500 + seed, 0, cause.sway)
                                                   : straight_strokes(kStrokes, speed, deceleration, 500 + seed, 0, cause.sway);
        const auto fusion = learning ? learning_fusion(kMouse) : paper_fusion(kMouse);
        const PointingError error =
            pointing_error(*fusion, pointing, sense(pointing, kMouse, cause.causes, 900 + seed), kLearning);
        overshoots.push_back(error.overshoot);
        rms.push_back(error.rms);
        most.push_back(error.most_of_it);
        resets += error.resets;
    }
    return {median(overshoots), median(rms), *std::max_element(rms.begin(), rms.end()), median(most), resets};
}

struct First {
    double squares = 0, count = 0, farthest = 0, before = 0;
};

First first_strokes(const Cause& cause, bool warm, double speed, std::uint64_t seed) {
    std::optional<LearnedPointing> known;
    if (warm) {
        const auto yesterday = learning_fusion(kMouse);
        const Pointing pointing = random_strokes(kRandomStrokes, 300 + seed, 0, cause.sway);
        tell(*yesterday, sense(pointing, kMouse, cause.causes, 700 + seed), [](double) {});
        known = yesterday->learned();
    }
    const auto fusion = learning_fusion(kMouse, known);
    const Pointing pointing = to_and_fro({0, 40}, {160, 40}, speed, 6);
    First first;
    double began = -1;
    tell(*fusion, sense(pointing, kMouse, cause.causes, 900 + seed), [&](double time) {
        const Pose truth = pointing.at(time);
        if (distance({}, truth.velocity) < 1) return;
        if (began < 0) began = time;
        const double off = distance(truth.at, fusion->pose().at);
        if (time - began < 0.5) first.before = std::max(first.before, off);
        if (time - began < 0.5 || time - began > 4) return;
        first.squares += off * off;
        ++first.count;
        first.farthest = std::max(first.farthest, off);
    });
    return first;
}

void print_table() {
    std::printf(
        "overshoot at the stop / RMS in motion, mm, medians of %d seeds, %d strokes each, the first %zu not counted; in brackets "
        "overshoot at 10 m/s2.\n",
        kSeeds, kStrokes, kLearning);
    std::printf("random: %d strokes of 40-400 mm/s, RMS / 95 %% (worst RMS of a seed); resets of all seeds and columns\n\n",
                kRandomStrokes);
    std::printf("%-36s %-9s %13s %21s %22s %7s\n", "cause", "method", "100 mm/s", "250 mm/s", "random", "resets");
    for (const Cause& cause : causes())
        for (const bool learning : {false, true}) {
            const Outcome slow = outcome(cause, learning, 100, 2500), fast = outcome(cause, learning, 250, 2500),
                          sudden = outcome(cause, learning, 250, 10000), random = outcome(cause, learning, kRandom, 0);
            std::printf("%-36s %-9s %5.2f / %5.2f %5.2f / %5.2f (%5.2f) %5.2f / %5.2f (%5.2f) %7u\n", cause.name,
                        learning ? "learning" : "paper", slow.overshoot, slow.rms, fast.overshoot, fast.rms, sudden.overshoot,
                        random.rms, random.most_of_it, random.worst_rms,
                        slow.resets + fast.resets + sudden.resets + random.resets);
        }
}

void print_csv() {
    std::printf("cause,method,speed (mm/s),overshoot (mm),RMS (mm),worst RMS (mm),resets\n");
    for (const Cause& cause : causes())
        for (const bool learning : {false, true})
            for (const double speed : {100.0, 250.0, kRandom}) {
                const Outcome found = outcome(cause, learning, speed, 2500);
                std::printf("\"%s\",%s,", cause.name, learning ? "learning" : "paper");
                speed == kRandom ? std::printf("random") : std::printf("%g", speed);
                std::printf(",%.3f,%.3f,%.3f,%u\n", found.overshoot, found.rms, found.worst_rms, found.resets);
            }
}

void print_speeds() {
    std::printf("method,speed (mm/s),overshoot (mm),RMS (mm)\n");
    const auto list = causes();
    const auto all =
        std::find_if(list.begin(), list.end(), [](const Cause& c) { return std::string_view(c.name).starts_with("all:"); });
    for (const bool learning : {false, true})
        for (int speed = 50; speed <= 400; speed += 50) {
            const Outcome found = outcome(*all, learning, speed, 2500);
            std::printf("%s,%d,%.3f,%.3f\n", learning ? "learning" : "paper", speed, found.overshoot, found.rms);
        }
}

// The hand goes to and fro from the first moment; mm from half a second behind its first motion to four, and the farthest: where
// nothing is known, and where another hour with the same mouse was learned from.
void print_first_strokes() {
    std::printf("\nRMS (farthest), mm, from 0.5 to 4 s after the first motion, %d seeds; before that the farthest\n", kSeeds);
    std::printf("%-36s %-22s %20s %20s %20s\n", "cause", "method", "100 mm/s", "250 mm/s", "400 mm/s");
    for (const Cause& cause : causes()) {
        if (std::string_view(cause.name).find(',') == std::string_view::npos) continue;
        for (const bool warm : {false, true}) {
            std::printf("%-36s %-22s", cause.name, warm ? "learning, once learned" : "learning, anew");
            for (const double speed : {100.0, 250.0, 400.0}) {
                double squares = 0, count = 0, farthest = 0, before = 0;
                for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
                    const First first = first_strokes(cause, warm, speed, seed);
                    squares += first.squares;
                    count += first.count;
                    farthest = std::max(farthest, first.farthest);
                    before = std::max(before, first.before);
                }
                std::printf("  %5.2f (%5.2f) %5.1f", std::sqrt(squares / count), farthest, before);
            }
            std::printf("\n");
        }
    }
}

// The median and the 99.9th of 1000 of what calls take, for a step with its pose and for a sample.
void print_cost() {
    using Clock = std::chrono::steady_clock;
    const Pointing pointing = random_strokes(60, 1);
    PointingCauses causes;
    causes.counts_per_mm = 31.5;
    const Sensed sensed = sense(pointing, kMouse, causes, 1);
    std::printf("\nns, p50 and p99.9 (the clock's own included)\n");
    for (const bool learning : {false, true}) {
        const auto fusion = learning ? learning_fusion(kMouse) : paper_fusion(kMouse);
        std::vector<double> steps, samples;
        auto sample = sensed.samples.begin();
        double seen = 0;
        const auto took = [](Clock::time_point begin) {
            return std::chrono::duration<double, std::nano>(Clock::now() - begin).count();
        };
        for (const OpticalStep& step : sensed.steps) {
            if (sample != sensed.samples.end() && sample->time <= step.time) {
                const auto begin = Clock::now();
                fusion->overlay(*sample++);
                samples.push_back(took(begin));
            }
            const auto begin = Clock::now();
            fusion->step(step);
            seen += fusion->pose().at.x;
            steps.push_back(took(begin));
        }
        std::sort(steps.begin(), steps.end());
        std::sort(samples.begin(), samples.end());
        const auto of = [](const std::vector<double>& values, double share) {
            return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
        };
        std::printf("%-9s step and pose %6.0f %6.0f, sample %6.0f %6.0f%s\n", learning ? "learning" : "paper", of(steps, 0.5),
                    of(steps, 0.999), of(samples, 0.5), of(samples, 0.999), seen == 0 ? " (nothing seen)" : "");
    }
}

}  // namespace
}  // namespace tactics

int main(int count, char** words) {
    const std::string_view word = count > 1 ? words[1] : "";
    if (word == "--csv") {
        tactics::print_csv();
    } else if (word == "--speeds") {
        tactics::print_speeds();
    } else if (word.empty()) {
        tactics::print_table();
        tactics::print_first_strokes();
        tactics::print_cost();
    } else {
        std::fprintf(stderr, "fusion: nothing, --csv or --speeds\n");
        return 1;
    }
    return 0;
}
