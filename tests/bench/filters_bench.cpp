// SPDX-License-Identifier: Apache-2.0
// Each filter of the list, at its defaults, on a page-sized photograph (150 dpi of a 170 mm square).
#include <benchmark/benchmark.h>

#include <string>

#include "filters/list.h"
#include "samples/draw/scenes.h"

namespace {

using namespace tactics;

Artwork input_for(const Filter& filter) {
    constexpr int kSide = 1004;
    static const Image kPhoto = [] {
        Image image = samples::draw_scene("house", kSide);
        image.mm_per_pixel = 25.4 / 150;
        return image;
    }();
    if (filter.name == "resample") {  // at its default of 150 dpi it would have nothing to do
        Image fine = kPhoto;
        fine.mm_per_pixel /= 2;
        return fine;
    }
    if (contains(filter.takes, Kind::picture)) return filter.uses_colour ? kPhoto : to_grey(kPhoto);
    // What comes before it in the list's own order: edges from sobel, a drawing from trace.
    Recipe recipe = parse_recipe(contains(filter.takes, Kind::edges) ? "sobel" : "sobel\ntrace", "bench", filters());
    return run(recipe, to_grey(kPhoto));
}

}  // namespace

int main(int count, char** words) {
    for (const Filter* filter : filters())
        benchmark::RegisterBenchmark(std::string(filter->name).c_str(), [filter](benchmark::State& state) {
            const Artwork input = input_for(*filter);
            const Settings settings(filter->options);
            for (auto _ : state) {
                state.PauseTiming();
                Artwork copy = input;
                state.ResumeTiming();
                benchmark::DoNotOptimize(filter->apply(std::move(copy), settings));
            }
        })->Unit(benchmark::kMillisecond);
    benchmark::Initialize(&count, words);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
