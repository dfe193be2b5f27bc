// SPDX-License-Identifier: Apache-2.0
// What an update of the surface under the finger costs, and how near it is to the ground: the height under the finger at once
// (direct) and the proxy (constraint-based), over maps of 1e3 to 1e7 triangles, with a point and with a fingertip. Terrain and
// stroke of 100 mm/s at 1 kHz, from 3 mm above to 3 mm below the surface, 160 x 120 mm.
//     tactics_bench --benchmark_filter=relief
// With TACTICS_RELIEF_TABLE=FILE in the environment also a table of speed against accuracy, for tactics chart.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "tactics/haptics/scenes/proxy.h"
#include "tests/bench/strokes.h"

namespace tactics {
namespace {

constexpr int kTicks = 200'000;

const ReliefSurface& surface(int triangles, int radius) {
    static std::map<std::pair<int, int>, ReliefSurface> made;
    const auto key = std::pair(triangles, radius);
    if (const auto known = made.find(key); known != made.end()) return known->second;
    return made.emplace(key, ReliefSurface(dilated(stroke_ground(pitch_of(triangles)), radius))).first->second;
}

double penetration(const ReliefSurface& felt, const Point3& finger) {
    return std::max(felt.height({finger.x, finger.y}) - finger.z, 0.0);
}

void relief_direct(benchmark::State& state) {
    const ReliefSurface& felt = surface(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
    const auto way = stroke(felt, kTicks);
    std::size_t i = 0;
    for (auto _ : state) benchmark::DoNotOptimize(penetration(felt, way[i++ % way.size()]));
    const Nanoseconds each = percentiles(way, [&](const Point3& finger) { benchmark::DoNotOptimize(penetration(felt, finger)); });
    state.counters["p50_ns"] = each.p50;
    state.counters["p99.9_ns"] = each.p999;
}
BENCHMARK(relief_direct)
    ->ArgsProduct({{1'000, 10'000, 100'000, 1'000'000, 10'000'000}, {0, 2}})
    ->ArgNames({"triangles", "radius"})
    ->Iterations(kTicks);

void relief_proxy(benchmark::State& state) {
    const ReliefSurface& felt = surface(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
    const auto way = stroke(felt, kTicks);
    Proxy proxy(felt);
    std::size_t i = 0;
    for (auto _ : state) benchmark::DoNotOptimize(proxy.follow(way[i++ % way.size()]));
    proxy.lift();
    int unsettled = 0;
    const Nanoseconds each = percentiles(way, [&](const Point3& finger) {
        benchmark::DoNotOptimize(proxy.follow(finger));
        unsettled += proxy.settled() ? 0 : 1;
    });
    state.counters["p50_ns"] = each.p50;
    state.counters["p99.9_ns"] = each.p999;
    state.counters["unsettled"] = unsettled;
}
BENCHMARK(relief_proxy)
    ->ArgsProduct({{1'000, 10'000, 100'000, 1'000'000, 10'000'000}, {0, 2}})
    ->ArgNames({"triangles", "radius"})
    ->Iterations(kTicks);

// Anywhere, under and over the map: the dearest that can come.
void relief_proxy_leaps(benchmark::State& state) {
    const ReliefSurface& felt = surface(static_cast<int>(state.range(0)), 0);
    RandomNumbers random(4);
    std::vector<Point3> way;
    for (int i = 0; i < kTicks; ++i)
        way.push_back({kStrokeWidth * random.uniform(), kStrokeHeight * random.uniform(), 30 * random.uniform() - 10});
    Proxy proxy(felt);
    int under = 0, unsettled = 0;
    const auto update = [&](const Point3& finger) {
        const Point3 now = proxy.follow(finger);
        under += now.z >= proxy.height({now.x, now.y}) ? 0 : 1;
        unsettled += proxy.settled() ? 0 : 1;
    };
    std::size_t i = 0;
    for (auto _ : state) update(way[i++ % way.size()]);
    const Nanoseconds each = percentiles(way, update);
    state.counters["p50_ns"] = each.p50;
    state.counters["p99.9_ns"] = each.p999;
    state.counters["under"] = under;
    state.counters["unsettled"] = unsettled;
}
BENCHMARK(relief_proxy_leaps)->Arg(10'000)->Arg(1'000'000)->ArgName("triangles")->Iterations(kTicks);

// The long run beside the one of proxy_test.cpp: ticks under the surface, and ticks in air without the finger.
void relief_proxy_hard_maps(benchmark::State& state) {
    std::int64_t ticks = 0, under = 0, lost = 0;
    for (auto _ : state)
        for (const HardRelief& relief : hard_reliefs()) {
            const ReliefSurface felt(relief.map);
            Proxy proxy(felt);
            RandomNumbers random(static_cast<std::uint64_t>(state.range(0)));
            Point3 finger{0, 0, felt.highest() + 1}, goal = finger;
            for (int i = 0; i < state.range(0); ++i, ++ticks) {
                const double left = std::hypot(goal.x - finger.x, goal.y - finger.y, goal.z - finger.z);
                if (left < kStrokeStep || i % 5'000 > 4'500) {
                    goal = {relief.map.width() * (1.4 * random.uniform() - 0.2),
                            relief.map.height() * (1.4 * random.uniform() - 0.2), 0};
                    goal.z = felt.height({goal.x, goal.y}) + 8 * random.uniform() - 5;
                    if (i % 5'000 > 4'500) finger = goal;
                } else {
                    const double part = kStrokeStep / left;
                    finger = {finger.x + (goal.x - finger.x) * part, finger.y + (goal.y - finger.y) * part,
                              finger.z + (goal.z - finger.z) * part};
                }
                const Point3 now = proxy.follow(finger);
                under += now.z >= proxy.height({now.x, now.y}) ? 0 : 1;
                lost +=
                    finger.z >= felt.highest() && proxy.settled() && (now.x != finger.x || now.y != finger.y || now.z != finger.z)
                        ? 1
                        : 0;
            }
        }
    state.counters["ticks"] = static_cast<double>(ticks);
    state.counters["under"] = static_cast<double>(under);
    state.counters["lost"] = static_cast<double>(lost);
}
BENCHMARK(relief_proxy_hard_maps)->Arg(2'000'000)->Iterations(1)->Unit(benchmark::kMillisecond);

void relief_dilation(benchmark::State& state) {
    const HeightMap map = stroke_ground(pitch_of(static_cast<double>(state.range(0))));
    for (auto _ : state) benchmark::DoNotOptimize(dilated(map, 2));
}
BENCHMARK(relief_dilation)
    ->Arg(10'000)
    ->Arg(100'000)
    ->Arg(1'000'000)
    ->Arg(10'000'000)
    ->ArgName("triangles")
    ->Unit(benchmark::kMillisecond);

// How far (mm, root of the mean square) the height that is felt is from the ground itself, which is a formula here: under the
// finger for direct; at the place of the proxy for the other, which feels the facets.
void relief_accuracy(benchmark::State& state) {
    const double pitch = static_cast<double>(state.range(0)) / 1000;
    const ReliefSurface felt(stroke_ground(pitch));
    const auto way = stroke(felt, kTicks);
    Proxy proxy(felt);
    double direct = 0, facets = 0, direct_worst = 0, facets_worst = 0;
    int touched = 0;
    for (auto _ : state)
        for (const Point3& finger : way) {
            const Point3 now = proxy.follow(finger);
            if (finger.x < 1 || finger.y < 1 || finger.x > kStrokeWidth - 1 || finger.y > kStrokeHeight - 1 || now.x < 1 ||
                now.y < 1 || now.x > kStrokeWidth - 1 || now.y > kStrokeHeight - 1)
                continue;
            if (now.z <= finger.z) continue;
            const double a = std::abs(felt.height({finger.x, finger.y}) - terrain(finger.x, finger.y)),
                         b = std::abs(now.z - terrain(now.x, now.y));
            direct += a * a;
            facets += b * b;
            direct_worst = std::max(direct_worst, a);
            facets_worst = std::max(facets_worst, b);
            ++touched;
        }
    const double direct_ns =
        percentiles(way, [&](const Point3& finger) { benchmark::DoNotOptimize(penetration(felt, finger)); }).p50;
    const double proxy_ns = percentiles(way, [&](const Point3& finger) { benchmark::DoNotOptimize(proxy.follow(finger)); }).p50;
    const double direct_error = std::sqrt(direct / touched), proxy_error = std::sqrt(facets / touched);
    state.counters["direct_mm"] = direct_error;
    state.counters["direct_worst_mm"] = direct_worst;
    state.counters["proxy_mm"] = proxy_error;
    state.counters["proxy_worst_mm"] = facets_worst;
    static std::vector<std::string> rows;
    rows.push_back("direct," + std::to_string(pitch) + "," + std::to_string(direct_ns) + "," + std::to_string(direct_error) +
                   "\n");
    rows.push_back("constraint-based," + std::to_string(pitch) + "," + std::to_string(proxy_ns) + "," +
                   std::to_string(proxy_error) + "\n");
    if (const char* const file = std::getenv("TACTICS_RELIEF_TABLE"); file != nullptr) {
        std::ofstream table(file);
        table << "method,resolution_mm,ns,error_mm\n";
        for (const std::string& row : rows) table << row;
    }
}
BENCHMARK(relief_accuracy)
    ->Arg(1000)
    ->Arg(500)
    ->Arg(250)
    ->Arg(125)
    ->ArgName("pitch_um")
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace tactics
