// SPDX-License-Identifier: Apache-2.0
// What it costs to start another program, free and shut in, and to ask those that read what strangers wrote.
#include <benchmark/benchmark.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include "tactics/braille/braille.h"
#include "tactics/readers/read.h"
#include "tactics/readers/svg/pdf.h"
#include "tactics/transport/child.h"
#include "tests/cli/pdf_files.h"

namespace tactics {
namespace {

void bench_start_free(benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(run_child({"true"}, "", {}).end);
}
BENCHMARK(bench_start_free)->Unit(benchmark::kMillisecond)->UseRealTime();

void bench_start_shut_in(benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(run_caged({.words = {"true"}}).end);
}
BENCHMARK(bench_start_shut_in)->Unit(benchmark::kMillisecond)->UseRealTime();

// As a file that is gone when it is closed.
Source kept_pdf() {
    Source source{"line.pdf", {std::tmpfile(), &std::fclose}};
    const std::string bytes = tests::pdf_that_says("");
    std::fwrite(bytes.data(), 1, bytes.size(), source.file.get());
    std::fflush(source.file.get());
    return source;
}

void bench_pages_of_pdf(benchmark::State& state) {
    const Source pdf = kept_pdf();
    for (auto _ : state) benchmark::DoNotOptimize(pages_of_pdf(pdf));
}
BENCHMARK(bench_pages_of_pdf)->Unit(benchmark::kMillisecond)->UseRealTime();

void bench_page_of_pdf_as_png(benchmark::State& state) {
    const Source pdf = kept_pdf();
    for (auto _ : state) benchmark::DoNotOptimize(pdf_page_as_png(pdf, 1).size());
}
BENCHMARK(bench_page_of_pdf_as_png)->Unit(benchmark::kMillisecond)->UseRealTime();

// OpenImageIO's program is started once; each picture is a copy of it that shuts itself in.
void bench_picture_in_a_copy(benchmark::State& state) {
    const unsigned char bytes[] = {'P', '5', '\n', '1', ' ', '1', '\n', '2', '5', '5', '\n', 7};
    for (auto _ : state) {
        Source source = memory_source(bytes, "bench");
        benchmark::DoNotOptimize(read_picture(source, {}).width);
    }
}
BENCHMARK(bench_picture_in_a_copy)->Unit(benchmark::kMillisecond)->UseRealTime();

void bench_braille_by_name(benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(to_braille("a title", "en-ueb-g2.ctb").size());
}
BENCHMARK(bench_braille_by_name)->Unit(benchmark::kMillisecond)->UseRealTime();

// Other words each time: the same are kept.
void bench_braille_by_own_table(benchmark::State& state) {
    const std::string table = (std::filesystem::temp_directory_path() / "tactics-bench.ctb").string();
    std::ofstream(table) << "include en-ueb-g2.ctb\n";
    int number = 0;
    for (auto _ : state) benchmark::DoNotOptimize(to_braille("title " + std::to_string(number++), table).size());
    std::filesystem::remove(table);
}
BENCHMARK(bench_braille_by_own_table)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace tactics
