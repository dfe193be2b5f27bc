// SPDX-License-Identifier: Apache-2.0
// The table of walls: what each method does where a height map jumps by 40 mm, for levers, fingers and speeds.
//     walls            the table, for people
//     walls --csv      all of it, for programs
//     walls --means    cost against error, as tactics chart draws it:
//                      tactics chart walls.csv --label method --points --log-x -o walls.svg
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "tests/haptics/wall_trials.h"

namespace {

using namespace tactics;

constexpr double kSpeeds[] = {25, 50, 75, 100};
constexpr double kStops[] = {1, 0.5, 0.1};  // mm before the wall

struct Row {
    std::string name;
    WallMethod method;
    double nearest_stop;
    bool knows_finger;
};

std::vector<Row> rows() {
    const double usual = WallSettings{}.nearest_stop;
    std::vector<Row> all;
    for (const NamedWall& wall : wall_methods()) all.push_back({std::string(wall.name), wall.method, usual, true});
    all.push_back({"look-ahead, no bump from 0.1 mm", WallMethod::look_ahead, 0.1, true});
    all.push_back({"look-ahead, any finger", WallMethod::look_ahead, usual, false});
    return all;
}

WallSettings settings_of(const Row& row, const LeverSettings& lever, const FingerSettings& finger) {
    WallSettings settings;
    settings.method = row.method;
    settings.nearest_stop = row.nearest_stop;
    settings.lever = lever;
    settings.lever.delay = 0.001;
    settings.law.damping_ns_per_m = 0.5;
    settings.finger = row.knows_finger ? finger : kFingers[0].finger;
    return settings;
}

double stairs(const void* wide, Point at) noexcept {
    return (static_cast<int>(at.x) & *static_cast<const int*>(wide)) == 0 ? 8 : 48;
}

// ns for one reference, with a wall every 64 mm, 32 mm on top, at 100 mm/s; the least of some rounds.
double cost(const WallSettings& settings) {
    constexpr int kTicks = 200'000;
    const int wide = 32;
    double least = 1e9, sum = 0;
    for (int round = 0; round < 5; ++round) {
        Wall wall(settings);
        const auto begin = std::chrono::steady_clock::now();
        for (int tick = 0; tick < kTicks; ++tick) sum += wall.reference({&wide, stairs}, {tick * 0.1, 0}, {100, 0}, 0.001);
        least =
            std::min(least, std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - begin).count() / kTicks);
    }
    return sum > 0 ? least : 0;
}

struct Outcome {
    Crossing crossing;
    double bumps[std::size(kStops)] = {};
    double error() const { return crossing.overshoot + std::abs(crossing.shift); }
};

Outcome outcome(const WallSettings& settings, const FingerSettings& finger, double speed) {
    Outcome found{cross(settings, finger, speed), {}};
    for (std::size_t i = 0; i < std::size(kStops); ++i) found.bumps[i] = highest_false_bump(settings, finger, speed, kStops[i]);
    return found;
}

void print_csv() {
    std::printf(
        "method,lever,finger,speed_mm_per_s,cost_ns,overshoot_mm,shift_mm,bump_mm,bump_from_half_mm,bump_from_tenth_mm,settle_ms,"
        "error_mm\n");
    for (const Row& row : rows())
        for (const NamedLever& lever : kLevers)
            for (const NamedFinger& finger : kFingers) {
                const WallSettings settings = settings_of(row, lever.lever, finger.finger);
                const double ns = cost(settings);
                for (const double speed : kSpeeds) {
                    const Outcome found = outcome(settings, finger.finger, speed);
                    std::printf("\"%s\",%s,%s,%.0f,%.1f,%.3f,%.3f,%.3f,%.3f,%.3f,%.0f,%.3f\n", row.name.c_str(),
                                lever.name.data(), finger.name.data(), speed, ns, found.crossing.overshoot, found.crossing.shift,
                                found.bumps[0], found.bumps[1], found.bumps[2], found.crossing.settled * 1000, found.error());
                }
            }
}

// One row for each method: what it costs, and how wrong it is, the mean of levers, fingers and speeds.
void print_means() {
    std::printf("method,cost (ns),overshoot and shift (mm)\n");
    for (const NamedWall& wall : wall_methods()) {
        const Row row{std::string(wall.name), wall.method, WallSettings{}.nearest_stop, true};
        double error = 0, ns = 1e9;
        int count = 0;
        for (const NamedLever& lever : kLevers)
            for (const NamedFinger& finger : kFingers) {
                const WallSettings settings = settings_of(row, lever.lever, finger.finger);
                ns = std::min(ns, cost(settings));
                for (const double speed : kSpeeds) {
                    const Crossing crossing = cross(settings, finger.finger, speed);
                    error += crossing.overshoot + std::abs(crossing.shift);
                    ++count;
                }
            }
        std::printf("\"%s\",%.1f,%.3f\n", row.name.c_str(), ns, error / count);
    }
}

// The worst of the fingers at each speed.
void print_table() {
    std::printf(
        "A wall of 40 mm, 1 N/mm and 0.5 N s/m, 1 ms of delay, 1 kHz; lever against surface, mm, the worst of three fingers.\n");
    std::printf(
        "Overshoot and shift of the half height at 25 / 50 / 75 / 100 mm/s; the highest false bump of stops from 1, 0.5, 0.1 mm "
        "before the wall on; ns.\n\n");
    std::printf("%-32s %-6s %-25s %-25s %-16s %s\n", "method", "lever", "overshoot", "shift", "bump", "ns");
    for (const Row& row : rows())
        for (const NamedLever& lever : kLevers) {
            double over[std::size(kSpeeds)] = {}, shift[std::size(kSpeeds)] = {}, bump[std::size(kStops)] = {}, ns = 1e9;
            for (const NamedFinger& finger : kFingers) {
                const WallSettings settings = settings_of(row, lever.lever, finger.finger);
                ns = std::min(ns, cost(settings));
                for (std::size_t i = 0; i < std::size(kSpeeds); ++i) {
                    const Outcome found = outcome(settings, finger.finger, kSpeeds[i]);
                    over[i] = std::max(over[i], found.crossing.overshoot);
                    shift[i] = std::max(shift[i], std::abs(found.crossing.shift));
                    for (std::size_t k = 0; k < std::size(kStops); ++k) bump[k] = std::max(bump[k], found.bumps[k]);
                }
            }
            std::printf("%-32s %-6s %4.1f / %4.1f / %4.1f / %4.1f %5.2f/ %4.2f / %4.2f / %4.2f %4.1f, %4.1f, %4.1f %4.0f\n",
                        row.name.c_str(), lever.name.data(), over[0], over[1], over[2], over[3], shift[0], shift[1], shift[2],
                        shift[3], bump[0], bump[1], bump[2], ns);
        }
    std::printf("\nThe least bump of any method with a shift of 0.5 mm, whatever it costs, at the same stops and speeds:\n");
    for (const NamedLever& lever : kLevers) {
        std::printf("%-6s", lever.name.data());
        for (const double stop : kStops) {
            std::printf("  from %.1f mm:", stop);
            for (const double speed : kSpeeds) {
                double least = 0;
                for (const NamedFinger& finger : kFingers)
                    least = std::max(least, least_false_bump(settings_of(rows()[0], lever.lever, finger.finger), finger.finger,
                                                             speed, stop, 0.5));
                std::printf(" %.1f", least);
            }
        }
        std::printf("\n");
    }
}

}  // namespace

int main(int count, char** words) {
    const std::string_view word = count > 1 ? words[1] : "";
    if (word == "--csv") {
        print_csv();
    } else if (word == "--means") {
        print_means();
    } else if (word.empty()) {
        print_table();
    } else {
        std::fprintf(stderr, "walls: nothing, --csv or --means\n");
        return 1;
    }
    return 0;
}
