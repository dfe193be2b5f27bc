// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/table.h"

#include <cstdio>
#include <utility>

#include "tactics/error.h"
#include "tactics/job/table_bars.h"
#include "tactics/job/table_columns.h"
#include "tactics/job/table_curves.h"
#include "tactics/job/table_surface.h"
#include "tactics/readers/read_table.h"

namespace tactics {

namespace {

[[noreturn]] void refuse(std::string_view wish, const Phrase& why) { throw Error(Fault::usage, spelled(wish), why); }

void check_wish(const TableWish& wish) {
    if (wish.points && wish.steps)
        refuse("steps", phrase("points are not joined; leave out {0} or {1}", spelled("points"), spelled("steps")));
    const bool curves = wish.points || wish.steps || !wish.group.empty() || !wish.label.empty();
    if (wish.histogram && (curves || !wish.y.empty() || !wish.z.empty() || wish.matrix || wish.log_x || wish.log_y))
        refuse("histogram",
               phrase("it shows one column, named by {0}, and has no points, steps, groups and labels; leave them out",
                      spelled("x")));
    if (wish.bars && (wish.histogram || !wish.z.empty() || wish.matrix || wish.points || wish.steps || !wish.label.empty() ||
                      wish.log_x || wish.log_y))
        refuse("bars", phrase("bars begin at 0 and have words at their axis: no z, matrix, points, steps, labels, histogram or "
                              "logarithmic axis; leave these out"));
    if (!wish.bars && !(wish.errors.empty() && wish.lower.empty() && wish.upper.empty()))
        refuse(wish.errors.empty() ? "lower" : "error", phrase("errors are drawn on bars; add {0} grouped", spelled("bars")));
    if (!wish.bars && wish.bar_way != BarWay::automatic)
        refuse("bar-direction", phrase("there are no bars; add {0}", spelled("bars")));
    if (!wish.other_y.empty() && !wish.bars &&
        (wish.histogram || !wish.z.empty() || wish.points || !wish.group.empty() || !wish.label.empty()))
        refuse("y",
               phrase("several columns are curves or bars, without points, groups, labels and z; name one, or leave those out"));
    if (!wish.z.empty() && (curves || wish.matrix))
        refuse("z", phrase("a surface has no points, steps, groups and labels; leave them out"));
    if (wish.matrix && (curves || !wish.x.empty() || !wish.y.empty() || wish.log_x || wish.log_y))
        refuse("matrix", phrase("it has all rows and columns of the table; leave out which are wanted, and what is for curves"));
}

bool names_nothing(const TableWish& wish) {
    return wish.x.empty() && wish.y.empty() && wish.z.empty() && wish.group.empty() && wish.label.empty() && !wish.points &&
           !wish.bars && !wish.steps && !wish.histogram && !wish.log_x && !wish.log_y;
}

// [x, y, z] are points in space unless somebody names columns.
bool is_of_points(const TableHead& head, const TableWish& wish) {
    return names_nothing(wish) && head.form == TableForm::arrays && !head.named && head.columns.size() == 3;
}

Plot whole_plot(Source& source, const TableWish& wish, std::vector<Phrase>& notes) {
    check_wish(wish);
    TableHead head = table_head(source);
    if (wish.bars && head.form != TableForm::heights) return bars_plot(source, head, wish, notes);
    if (head.form == TableForm::heights && !names_nothing(wish))
        refuse("x", phrase("{0} has x, y and the rows of z, which are all drawn; leave out what is for columns", head.name));
    if (wish.matrix || (names_nothing(wish) && is_matrix(head))) return matrix_plot(source, head, wish, notes);
    TableWish chosen = wish;
    if (is_of_points(head, wish)) chosen.z = "z";
    const TableColumns columns = choose_columns(head, chosen, notes);
    if (chosen.histogram) return histogram_plot(source, head, columns, chosen, notes);
    if (columns.z) return spatial_plot(source, head, columns, chosen, notes);
    return curves_plot(source, head, columns, chosen, notes);
}

}  // namespace

Plot plot_of(Source& source, const TableWish& wish, std::vector<Phrase>& notes) {
    std::vector<Phrase> told;  // no notes for a refused table
    Plot plot = whole_plot(source, wish, told);
    notes.insert(notes.end(), told.begin(), told.end());
    return plot;
}

bool is_of_heights(Source& source, const TableWish& wish) {
    if (!wish.z.empty() || wish.matrix) return true;
    if (!names_nothing(wish)) return false;
    const TableHead head = table_head(source);
    std::rewind(source.file.get());
    return is_matrix(head) || is_of_points(head, wish);
}

std::optional<PlotSurface> surface_in(Source& source, const TableWish& wish, std::vector<Phrase>& notes) {
    Plot plot = plot_of(source, wish, notes);
    if (plot.surfaces.empty()) return std::nullopt;
    return std::move(plot.surfaces.front());
}

}  // namespace tactics
