// The table of walls: method x lever x finger x speed, 40 mm high. Plain text, or with --csv a file that `tactics chart` draws:
//
//     tactics_walls --csv | grep -e method -e ,light,soft,100, > walls.csv
//     tactics chart walls.csv --x cost_ns --y error_mm --label method --points -p a3 -o walls.svg
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include "tests/haptics/wall_trials.h"

namespace {

using namespace tactics;

constexpr double kSpeeds[] = {25, 50, 75, 100};

struct Row {
    std::string name;
    WallMethod method;
    double most_bump;
    bool knows_finger;
};

std::vector<Row> rows() {
    std::vector<Row> all;
    for (const NamedWall& wall : wall_methods()) all.push_back({std::string(wall.name), wall.method, 0.9, true});
    all.push_back({"look-ahead, edges first", WallMethod::look_ahead, kAnyBump, true});
    all.push_back({"look-ahead, any finger", WallMethod::look_ahead, 0.9, false});
    return all;
}

WallSettings settings_of(const Row& row, const LeverSettings& lever, const FingerSettings& finger) {
    WallSettings settings;
    settings.method = row.method;
    settings.most_bump = row.most_bump;
    settings.lever = lever;
    settings.lever.delay = 0.001;
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

}  // namespace

int main(int count, char** words) {
    const bool csv = count > 1 && std::string_view(words[1]) == "--csv";
    if (csv) {
        std::printf(
            "method,lever,finger,speed_mm_per_s,cost_ns,overshoot_mm,shift_mm,bump_mm,bump_from_half_mm,least_bump_mm,settle_ms,"
            "error_mm\n");
    } else {
        std::printf("A wall of 40 mm, 1 N/mm and 0.5 N s/m, 1 ms of delay, 1 kHz; lever against surface.\n");
        std::printf(
            "At each speed: overshoot / shift of the half height / false bump for stops from 0.1 mm, from 0.5 mm before it, mm / "
            "settled after ms\n");
    }
    for (const Row& row : rows()) {
        for (const NamedLever& lever : kLevers)
            for (const NamedFinger& finger : kFingers) {
                const WallSettings settings = settings_of(row, lever.lever, finger.finger);
                const double ns = cost(settings);
                if (!csv)
                    std::printf("%s, %s lever, %s finger, %.0f ns:", row.name.c_str(), lever.name.data(), finger.name.data(), ns);
                for (const double speed : kSpeeds) {
                    const Crossing crossing = cross(settings, finger.finger, speed);
                    const double bump = highest_false_bump(settings, finger.finger, speed, 0.1);
                    const double later = highest_false_bump(settings, finger.finger, speed, 0.5);
                    const double least = least_false_bump(settings, finger.finger, speed, 0.1, 0.5);
                    if (csv)
                        std::printf("\"%s\",%s,%s,%.0f,%.1f,%.3f,%.3f,%.3f,%.3f,%.3f,%.0f,%.3f\n", row.name.c_str(),
                                    lever.name.data(), finger.name.data(), speed, ns, crossing.overshoot, crossing.shift, bump,
                                    later, least, crossing.settled * 1000, crossing.overshoot + std::abs(crossing.shift));
                    else
                        std::printf("  %.0f: %.1f / %.2f / %.1f, %.1f / %.0f", speed, crossing.overshoot, crossing.shift, bump,
                                    later, crossing.settled * 1000);
                }
                if (!csv) std::printf("\n");
            }
    }
    if (csv) return 0;
    for (const NamedLever& lever : kLevers)
        for (const NamedFinger& finger : kFingers) {
            const WallSettings settings = settings_of({"", WallMethod::raw, 0.9, true}, lever.lever, finger.finger);
            std::printf("least bump of any method with a shift of 0.5 mm, %s lever, %s finger, stops from 0.1 mm, from 0.5 mm:",
                        lever.name.data(), finger.name.data());
            for (const double speed : kSpeeds)
                std::printf("  %.0f: %.1f, %.1f", speed, least_false_bump(settings, finger.finger, speed, 0.1, 0.5),
                            least_false_bump(settings, finger.finger, speed, 0.5, 0.5));
            std::printf("\n");
        }
    return 0;
}
