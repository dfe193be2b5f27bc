// SPDX-License-Identifier: Apache-2.0
// Any bytes as a table in JSON: a plot that keeps its promises, or one line of what is wrong.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "tactics/error.h"
#include "tactics/job/table.h"
#include "tactics/readers/json_table.h"

namespace {

using namespace tactics;

void read_whole(Source& source) {
    if (!begins_json(source)) return;
    const TableHead head = json_table_head(source);
    if (head.form != TableForm::heights && head.columns.empty()) std::abort();
    if (head.rows.size() > kHeadRows) std::abort();
    std::vector<std::size_t> all(head.columns.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
    std::size_t rows = 0;
    read_json_rows(source, head, all, [&](std::size_t, std::span<const std::string_view> cells, bool) {
        if (head.form != TableForm::heights && cells.size() != all.size()) std::abort();
        ++rows;
    });
    if (head.form != TableForm::heights && rows < head.rows.size()) std::abort();
}

void plot_whole(Source& source, const TableWish& wish) {
    std::vector<Phrase> notes;
    const Plot plot = plot_of(source, wish, notes);
    for (const PlotCurve& curve : plot.curves) {
        const auto finite = [](const PlotPoint& point) { return std::isfinite(point.x) && std::isfinite(point.y); };
        if (curve.points.size() < 2 || !std::all_of(curve.points.begin(), curve.points.end(), finite)) std::abort();
    }
    for (const PlotSurface& surface : plot.surfaces) {
        const auto rises = [](const std::vector<double>& along) {
            return along.size() >= 2 && std::adjacent_find(along.begin(), along.end(), std::greater_equal<>()) == along.end();
        };
        if (!rises(surface.x) || !rises(surface.y) || surface.z.size() != surface.x.size() * surface.y.size()) std::abort();
    }
    if (plot.curves.empty() && plot.marks.empty() && plot.surfaces.empty()) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    const auto with = [&](auto read) {
        try {
            Source source = memory_source({data, size}, "fuzzed.json");
            read(source);
        } catch (const Error& error) {
            if (error.what()[0] == '\0') std::abort();
        }
    };
    with(read_whole);
    with([](Source& source) { plot_whole(source, {}); });
    with([](Source& source) { plot_whole(source, {.matrix = true}); });
    with([](Source& source) { plot_whole(source, {.histogram = 0}); });
    return 0;
}
