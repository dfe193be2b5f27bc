// SPDX-License-Identifier: Apache-2.0
// What measuring a picture of 12 megapixels takes beside reading it from a JPEG; both on the clock on the wall, as measuring has
// two threads.
//     tactics_bench --benchmark_filter=information
#include <benchmark/benchmark.h>

#include <filesystem>
#include <string>

#include "samples/draw/files.h"
#include "samples/draw/scenes.h"
#include "tactics/information/felt_rate.h"
#include "tactics/information/measures.h"
#include "tactics/readers/read.h"

namespace {

using namespace tactics;

constexpr int kSide = 3464;           // 12 million pixels
constexpr double kFeltLevels = 12.8;  // 0.5 mm of 10 mm in 256 levels

const std::string& photograph() {
    static const std::string kPath = [] {
        const std::string path = (std::filesystem::temp_directory_path() / "tactics-information-bench.jpg").string();
        samples::write_jpeg(samples::draw_scene("house", kSide), path);
        return path;
    }();
    return kPath;
}

Image read_grey() {
    Source source = open_source(photograph());
    return read_picture(source, {0, false});
}

void information_read(benchmark::State& state) {
    photograph();  // is drawn once
    for (auto _ : state) benchmark::DoNotOptimize(read_grey());
}

void information_read_and_measure(benchmark::State& state) {
    photograph();
    for (auto _ : state) benchmark::DoNotOptimize(measure(grid_of(read_grey()), kFeltLevels));
}

BENCHMARK(information_read)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(information_read_and_measure)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
