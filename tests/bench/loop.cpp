// SPDX-License-Identifier: Apache-2.0
// How punctual the loop of a haptic mouse is: 1 kHz by the clock, a simulated mouse on a terrain, with and without a busy core,
// before other programs (SCHED_FIFO, which needs the permission) and as one of them.
//     loop [SECONDS]    60 for each of five rows if none are given
#include <atomic>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <thread>

#include "tactics/haptics/devices/mouse_devices.h"
#include "tactics/haptics/loop/play_loop.h"
#include "tactics/haptics/scenes/relief_scene.h"
#include "tests/haptics/reliefs.h"

namespace tactics {
namespace {

struct Row {
    bool before_others, busy, plays;
    Lateness lateness{};
    std::uint64_t long_periods = 0;
    bool granted = false;
};

void run_for(Row& row, const ReliefSurface& surface, double seconds) {
    const auto mouse =
        simulated_mouse(kLevers[0].lever, kFingers[1].finger, surface.map().width(), surface.map().height(), 15, 100, 1e6);
    ReliefScene scene(surface, {});
    Playing play(scene, nullptr, {});
    std::atomic<bool> done = false;
    std::thread other([&] {
        while (row.busy && !done) {
        }
    });
    LoopReport report;
    // In a thread of its own: what goes before others is not the one that burns a core.
    std::thread loop([&] {
        MonotonicClock clock(row.before_others);
        row.granted = clock.goes_before_others();
        double time = 0;
        report = row.plays ? run_play({1000, seconds}, clock, *mouse, play).loop
                           : run_loop(clock, 1000, [&](double dt) { return (time += dt) < seconds; });
    });
    loop.join();
    done = true;
    other.join();
    row.lateness.add(report.lateness);
    row.long_periods += report.long_periods;
}

void print(const Row& row) {
    const auto us = [&](double share) { return row.lateness.quantile(share) * 1e6; };
    const auto ticks = static_cast<double>(row.lateness.ticks());
    std::printf("%-12s %-5s %-9s %8.0f %8.1f %8.1f %8.1f %8llu %7.3f %%\n",
                row.before_others ? (row.granted ? "SCHED_FIFO" : "not granted") : "SCHED_OTHER", row.busy ? "busy" : "-",
                row.plays ? "mouse" : "nothing", ticks, us(0.5), us(0.99), us(0.999),
                static_cast<unsigned long long>(row.long_periods), 100 * static_cast<double>(row.long_periods) / ticks);
}

}  // namespace
}  // namespace tactics

int main(int count, char** words) {
    using namespace tactics;
    const double seconds = count > 1 ? std::atof(words[1]) : 60;
    if (!(seconds > 0)) {
        std::fprintf(stderr, "loop: how many seconds?\n");
        return 1;
    }
    // In turns of some seconds: a virtual machine is not always let run, and that is to be the same for all.
    constexpr double kTurn = 5;
    const int turns = static_cast<int>(std::ceil(seconds / kTurn));
    Row rows[] = {{true, false, true}, {false, false, true}, {true, true, true}, {false, true, true}, {true, false, false}};
    const ReliefSurface surface(
        map_of(320, 240, 0.5, [](double x, double y) { return 15 + 6 * std::sin(x / 5) * std::cos(y / 6); }));
    for (int turn = 0; turn < turns; ++turn)
        for (Row& row : rows) run_for(row, surface, seconds / turns);
    std::printf(
        "1 kHz, %g s a row, in turns; late by, us; periods over 1.25 ms. \"nothing\": the clock alone, which is what this "
        "machine can\n",
        seconds);
    std::printf("%-12s %-5s %-9s %8s %8s %8s %8s %8s\n", "policy", "core", "ticks do", "ticks", "p50", "p99", "p99.9", "over");
    for (const Row& row : rows) print(row);
    return 0;
}
