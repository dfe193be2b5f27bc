// SPDX-License-Identifier: Apache-2.0
// Any bytes as a table: rows of as many values as there are columns, or one line of what is wrong.
#include <cstdint>
#include <cstdlib>

#include "tactics/error.h"
#include "tactics/job/table.h"
#include "tactics/readers/csv.h"
#include "tactics/readers/read_table.h"
#include "tactics/text/utf8.h"

namespace {

using namespace tactics;

void read_whole(Source& source) {
    const TableHead head = table_head(source);
    if (head.columns.empty() || head.columns.size() > kMostTableColumns || head.rows.size() > kHeadRows) std::abort();
    for (const std::string& column : head.columns)
        if (column.empty() || to_line(column) != column) std::abort();
    std::vector<std::size_t> all(head.columns.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
    std::size_t line = 0, rows = 0;
    read_rows(source, head, all, [&](std::size_t at, std::span<const std::string_view> cells, bool) {
        if (at <= line || cells.size() != all.size()) std::abort();
        line = at;
        // What was seen of the beginning is what is read.
        if (rows < head.rows.size())
            for (std::size_t i = 0; i < cells.size(); ++i)
                if (cells[i] != head.rows[rows].cells[i]) std::abort();
        ++rows;
    });
    if (rows < head.rows.size()) std::abort();
}

void plot_whole(Source& source) {
    std::vector<Phrase> notes;
    const Plot plot = plot_of(source, {}, notes);
    for (const PlotCurve& curve : plot.curves) {
        if (curve.points.size() < 2) std::abort();
        for (std::size_t i = 0; i < curve.gaps.size(); ++i)
            if (curve.gaps[i] == 0 || curve.gaps[i] >= curve.points.size() || (i > 0 && curve.gaps[i] <= curve.gaps[i - 1]))
                std::abort();
    }
    if (plot.curves.empty() && plot.marks.empty() && plot.surfaces.empty()) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    for (const auto read : {read_whole, plot_whole}) try {
            Source source = memory_source({data, size}, "fuzzed.csv");
            read(source);
        } catch (const Error& error) {
            if (error.what()[0] == '\0') std::abort();
        }
    return 0;
}
