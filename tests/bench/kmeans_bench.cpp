// SPDX-License-Identifier: Apache-2.0
// Exact k-means on a histogram against the iterative one on the pixels: time, and how much worse the iterative one is.
#include <benchmark/benchmark.h>

#include <cmath>

#include "filters/kmeans_exact.h"
#include "filters/kmeans_iterative.h"

namespace tactics {
namespace {

constexpr int kPixels = 154'401;  // 481 x 321

// Three hills, as a photograph of an object before a ground has.
const std::vector<Level>& histogram() {
    static const std::vector<Level> levels = [] {
        std::vector<Level> made;
        double total = 0;
        for (int v = 0; v < 256; ++v) {
            const auto hill = [&](double middle, double width) {
                return std::exp(-(v - middle) * (v - middle) / (2 * width * width)) / width;
            };
            made.push_back({static_cast<double>(v), 0.5 * hill(60, 18) + 0.3 * hill(130, 30) + 0.2 * hill(215, 9)});
            total += made.back().weight;
        }
        for (Level& level : made) level.weight = std::round(level.weight * kPixels / total);
        return made;
    }();
    return levels;
}

void exact(benchmark::State& state) {
    const int k = static_cast<int>(state.range(0));
    for (auto _ : state) benchmark::DoNotOptimize(kmeans_exact(histogram(), k));
}
BENCHMARK(exact)->Arg(2)->Arg(4)->Arg(8)->Arg(16)->Unit(benchmark::kMillisecond);

void iterative(benchmark::State& state) {
    const int k = static_cast<int>(state.range(0));
    std::vector<float> samples;
    for (const Level& level : histogram())
        samples.insert(samples.end(), static_cast<std::size_t>(level.weight), static_cast<float>(level.value));
    const double best = kmeans_exact(histogram(), k).squares;
    double worst = best;
    std::uint64_t seed = 0;
    for (auto _ : state) {
        const auto centres = kmeans_iterative(samples, k, static_cast<int>(state.range(1)), ++seed);
        state.PauseTiming();
        double squares = 0;
        for (const Level& level : histogram()) {
            double least = INFINITY;
            for (const double centre : centres) least = std::min(least, (level.value - centre) * (level.value - centre));
            squares += level.weight * least;
        }
        worst = std::max(worst, squares);
        state.ResumeTiming();
    }
    state.counters["worst_excess_percent"] = 100 * (worst / best - 1);
}
BENCHMARK(iterative)->Args({4, 1})->Args({4, 3})->Args({4, 10})->Args({16, 3})->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace tactics
