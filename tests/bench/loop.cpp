// How punctual the loop of a haptic mouse is: 1 kHz by the clock, a simulated mouse on a terrain, with and without a busy core, before other
// programs (SCHED_FIFO, which needs the permission) and as one of them.
//     loop [SECONDS]    60 for each row if none are given
#include <atomic>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <thread>

#include "tactics/haptics/mouse_devices.h"
#include "tactics/haptics/mouse_loop.h"

namespace tactics {
namespace {

HeightMap hills() {
    HeightMap map{320, 240, 0.5, {}};
    map.heights.resize(320 * 240);
    for (int j = 0; j < 240; ++j)
        for (int i = 0; i < 320; ++i) map.at(i, j) = static_cast<float>(15 + 6 * std::sin(i * 0.1) * std::cos(j * 0.08));
    return map;
}

double others_load() {
    std::ifstream file("/proc/loadavg");
    double load = 0;
    file >> load;
    return load;
}

void print_row(bool before_others, bool busy, double seconds) {
    const ReliefSurface surface(hills());
    const auto mouse = simulated_mouse(kLevers[0].lever, kFingers[1].finger, surface.map().width(), surface.map().height(), 15, 100, 1e6);
    MousePlay play(surface, nullptr, {});
    std::atomic<bool> done = false;
    std::thread other([&] {
        while (busy && !done) {
        }
    });
    MouseLoopReport report;
    bool granted = false;
    // In a thread of its own: what goes before others is not the one that burns a core.
    std::thread loop([&] {
        MonotonicClock clock(before_others);
        granted = clock.goes_before_others();
        report = run_mouse({1000, seconds}, clock, *mouse, play);
    });
    loop.join();
    done = true;
    other.join();
    const auto us = [&](double share) { return report.loop.lateness.quantile(share) * 1e6; };
    const auto ticks = static_cast<double>(report.loop.lateness.ticks());
    std::printf("%-12s %-5s %5.1f %8.0f %8.1f %8.1f %8.1f %8llu %7.3f %%\n", before_others ? (granted ? "SCHED_FIFO" : "not granted") : "SCHED_OTHER", busy ? "busy" : "-", others_load(), ticks,
                us(0.5), us(0.99), us(0.999), static_cast<unsigned long long>(report.loop.long_periods), 100 * static_cast<double>(report.loop.long_periods) / ticks);
    std::fflush(stdout);
}

}  // namespace
}  // namespace tactics

int main(int count, char** words) {
    const double seconds = count > 1 ? std::atof(words[1]) : 60;
    if (!(seconds > 0)) {
        std::fprintf(stderr, "loop: how many seconds?\n");
        return 1;
    }
    std::printf("1 kHz, %g s a row; late by, us; periods over 1.25 ms\n", seconds);
    std::printf("%-12s %-5s %5s %8s %8s %8s %8s %8s\n", "policy", "core", "load", "ticks", "p50", "p99", "p99.9", "over");
    for (const bool busy : {false, true})
        for (const bool before_others : {true, false}) tactics::print_row(before_others, busy, seconds);
    return 0;
}
