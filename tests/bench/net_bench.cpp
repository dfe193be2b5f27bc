// SPDX-License-Identifier: Apache-2.0
// The contour net on a picture of 481 x 321, one core: each kernel, and what comes before and after the layers.
#include <benchmark/benchmark.h>

#include <string>

#include "filters/contour_maps.h"
#include "filters/net/input.h"
#include "filters/net/nets.h"
#include "samples/draw/scenes.h"

namespace tactics {
namespace {

const Image& picture() {
    static const Image kPicture = [] {
        const Image whole = samples::draw_scene("house", 481);
        Image image = make_image(481, 321, 3, 0, 0);
        for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = whole.pixels[i % whole.pixels.size()];
        return image;
    }();
    return kPicture;
}

void input(benchmark::State& state) {
    NetPlane plane(248, 168, 24);
    for (auto _ : state) see(picture(), net_levels(picture()), 0, 0, plane);
}
BENCHMARK(input)->Unit(benchmark::kMillisecond);

void map(benchmark::State& state, std::vector<double> scales) {
    const auto net = find_net();
    if (!net) return state.SkipWithError("there are no weights");
    for (auto _ : state) benchmark::DoNotOptimize(contour_map(*net, picture(), scales));
}
BENCHMARK_CAPTURE(map, one_size, std::vector<double>{1})->Unit(benchmark::kMillisecond);

// At the sizes that a page is made of.
void map_of_page(benchmark::State& state) {
    const auto net = find_net();
    if (!net) return state.SkipWithError("there are no weights");
    for (auto _ : state) benchmark::DoNotOptimize(learned_map_of(picture(), *net));
}
BENCHMARK(map_of_page)->Unit(benchmark::kMillisecond);

// Registered before main() of Google Benchmark reads its words.
const bool kRegistered = [] {
    for (const NetKernel* kernel : net_kernels())
        benchmark::RegisterBenchmark(("logits/" + std::string(kernel->name)).c_str(), [kernel](benchmark::State& state) {
            const auto net = find_net();
            if (!net) return state.SkipWithError("there are no weights");
            for (auto _ : state) benchmark::DoNotOptimize(logits_of(*net, picture(), {.kernel = kernel}));
        })->Unit(benchmark::kMillisecond);
    return true;
}();

}  // namespace
}  // namespace tactics
