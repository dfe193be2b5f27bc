// SPDX-License-Identifier: Apache-2.0
// What any program that does this job must pay, on a photograph of 12 megapixels: decoding it, whole and no larger than a
// page shows it, counting its greys and solving K-means on the count. Whole runs (bench/compare) are held against these.
#include <benchmark/benchmark.h>

#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "filters/kmeans_exact.h"
#include "samples/draw/files.h"
#include "samples/draw/scenes.h"
#include "tactics/readers/read.h"

namespace tactics {
namespace {

const std::vector<unsigned char>& photograph() {
    static const std::vector<unsigned char> bytes = [] {
        constexpr int kSide = 4000;
        const std::string path = (std::filesystem::temp_directory_path() / "tactics-floor-bench.jpg").string();
        samples::write_jpeg(samples::draw_scene("house", kSide), path);
        std::vector<unsigned char> read(std::filesystem::file_size(path));
        const Source file = open_source(path);
        read.resize(std::fread(read.data(), 1, read.size(), file.file.get()));
        std::filesystem::remove(path);
        return read;
    }();
    return bytes;
}

Image decoded(int longest) {
    Source source = memory_source(photograph(), "photograph");
    return read_picture(source, {longest, false});
}

void floor_decode(benchmark::State& state) {
    photograph();
    for (auto _ : state) benchmark::DoNotOptimize(decoded(static_cast<int>(state.range(0))));
}
BENCHMARK(floor_decode)->Arg(0)->Arg(1100)->Arg(500)->Unit(benchmark::kMillisecond);  // whole; A4 at 150 and at 45 dpi

void floor_histogram(benchmark::State& state) {
    const Image image = decoded(0);
    for (auto _ : state) benchmark::DoNotOptimize(count_levels(image));
}
BENCHMARK(floor_histogram)->Unit(benchmark::kMillisecond);

void floor_histogram_and_kmeans(benchmark::State& state) {
    const Image image = decoded(0);
    for (auto _ : state) benchmark::DoNotOptimize(kmeans_exact(levels_of(image), 4));
}
BENCHMARK(floor_histogram_and_kmeans)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace tactics
