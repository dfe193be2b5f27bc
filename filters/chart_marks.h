// SPDX-License-Identifier: Apache-2.0
// The marks of a plot on a chart: which of them have a symbol, and what the key says of them.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "filters/chart_axis.h"
#include "tactics/drawing.h"
#include "tactics/plot.h"

namespace tactics {

/// Symbols that stand for all their marks, in the key by themselves: those of which there are several marks and one has a name,
/// and then others of which one has a name.
struct MarkGroups {
    std::array<bool, kSymbols> is_group{};
    bool has(PlotSymbol symbol) const { return is_group[static_cast<std::size_t>(symbol)]; }
};
MarkGroups groups_of(const std::vector<PlotMark>& marks);

/// Marks of a spatial plot, seen from above: the name of a mark is followed by its z; unnamed marks get a symbol by their z, low,
/// middle or high, unless they already have several kinds of symbols. True: they have, so the z of unnamed marks is not visible.
bool flatten_marks(Plot& plot, std::string_view language);

/// A drawn mark.
struct ChartMark {
    const PlotMark* mark = nullptr;
    Point at;
};

/// Marks with a name of their own, and of the others those that keep the gap from all that are drawn: in turns, one of each
/// symbol, so that no group hides another. The rest are counted in `left_out`, and of those the ones that are at the very place
/// of another in `repeated`.
std::vector<ChartMark> marks_apart(const std::vector<PlotMark>& marks, const MarkGroups& groups, const AxisScale& across,
                                   const AxisScale& up, double radius, double gap, std::size_t& left_out, std::size_t& repeated);

}  // namespace tactics
