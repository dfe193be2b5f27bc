// SPDX-License-Identifier: Apache-2.0
// A hundred pages of dots for each embosser: what convert does with a page once it is laid out.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "print/format.h"
#include "tactics/layout/lay_out.h"
#include "tactics/measure/random.h"

namespace tactics {
namespace {

// As busy as repair leaves the page of a map: some 4 m of line, a surface, a title.
Page busy_page(const Format& format, const Settings& settings, std::uint64_t seed) {
    RandomNumbers random(seed);
    const auto between = [&](double least, double most) { return least + random.uniform() * (most - least); };
    Drawing drawing;
    drawing.width = 160;
    drawing.height = 220;
    for (int i = 0; i < 30; ++i) {
        Stroke stroke;
        Point p{between(0, 160), between(0, 220)};
        double way = between(0, 6.28);
        for (int k = 0; k < 60; ++k) {
            stroke.points.push_back({std::clamp(p.x, 0.0, 160.0), std::clamp(p.y, 0.0, 220.0)});
            way += between(-0.3, 0.3);
            p = {p.x + 2.5 * std::cos(way), p.y + 2.5 * std::sin(way)};
        }
        drawing.strokes.push_back(std::move(stroke));
    }
    drawing.areas.push_back({{{{20, 20}, {70, 20}, {70, 60}, {20, 60}}}});
    Sheet sheet;
    sheet.paper = find_paper("a4", "bench");
    sheet.medium = &find_medium(format.medium, "bench");
    sheet.orientation = Orientation::portrait;
    sheet.title = "A busy page";
    sheet.print_title = false;
    fit_to_machine(sheet, format, settings);
    return lay_out(drawing, sheet);
}

void encode(benchmark::State& state, const Format* format) {
    const Settings settings(format->options);
    std::vector<Page> pages;
    for (std::uint64_t i = 0; i < 100; ++i) pages.push_back(busy_page(*format, settings, i));
    for (auto _ : state) {
        benchmark::DoNotOptimize(files_of(*format, pages, settings));
    }
}

[[maybe_unused]] const bool kRegistered = [] {
    for (const Format* format : formats())
        if (format->embosser != nullptr || format->dots != nullptr)
            benchmark::RegisterBenchmark(("hundred pages/" + std::string(format->name)).c_str(), encode, format)
                ->Unit(benchmark::kMillisecond);
    return true;
}();

}  // namespace
}  // namespace tactics
