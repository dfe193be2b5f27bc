// SPDX-License-Identifier: Apache-2.0
// Mending, and what it asks again and again, on what sobel-kmeans draws of a photograph: on one sheet of A4, and on the 2x2 and
// 3x3 that are tried where one has no room. `pieces`: short parts of lines that are compared with each other.
#include <benchmark/benchmark.h>

#include <variant>

#include "filters/list.h"
#include "samples/draw/scenes.h"
#include "tactics/repair/near.h"
#include "tactics/repair/repair.h"
#include "tactics/rules/coverage.h"

namespace tactics {
namespace {

constexpr double kAcross = 170;  // mm, of one sheet

const Medium& swell() { return find_medium("swell", "bench"); }

Drawing drawing_on(int sheets) {
    static const Drawing drawn = [] {
        Image photograph = samples::draw_scene("house", 1004);
        photograph.mm_per_pixel = kAcross / photograph.width;
        return std::get<Drawing>(run(find_recipe("sobel-kmeans", "bench"), to_grey(std::move(photograph))));
    }();
    return scaled_to(drawn, sheets * kAcross);
}

void mend(benchmark::State& state) {
    const Drawing drawing = drawing_on(static_cast<int>(state.range(0)));
    for (auto _ : state) benchmark::DoNotOptimize(repair(drawing, swell()));
}
BENCHMARK(mend)->Name("repair/sheets")->Arg(1)->Arg(2)->Arg(3)->Unit(benchmark::kMillisecond);

void look(benchmark::State& state) {
    const Page page = page_of(drawing_on(static_cast<int>(state.range(0))), swell());
    const PageGeometry geometry(page);
    for (auto _ : state) benchmark::DoNotOptimize(NearSuspects(geometry, swell()));
    state.counters["pieces"] = static_cast<double>(geometry.pieces.size());
}
BENCHMARK(look)->Name("near_suspects/sheets")->Arg(1)->Arg(2)->Arg(3)->Unit(benchmark::kMillisecond);

void measure(benchmark::State& state) {
    const Page page = page_of(drawing_on(1), swell());
    for (auto _ : state) benchmark::DoNotOptimize(PageGeometry(page));
}
BENCHMARK(measure)->Name("page_geometry")->Unit(benchmark::kMillisecond);

void blacken(benchmark::State& state) {
    const Page page = page_of(drawing_on(1), swell());
    const PageGeometry geometry(page);
    for (auto _ : state) benchmark::DoNotOptimize(ink_beyond(geometry, static_cast<double>(state.range(0))));
}
// 45 percent is told from lengths alone; 1 has to be measured.
BENCHMARK(blacken)->Name("ink_beyond/percent")->Arg(45)->Arg(1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace tactics
