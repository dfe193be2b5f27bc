// SPDX-License-Identifier: Apache-2.0
// Heights in a table: points of x, y and z, or a matrix.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tactics/job/table_columns.h"
#include "tactics/plot.h"
#include "tactics/readers/read.h"
#include "tactics/readers/table.h"
#include "tactics/text/phrase.h"

namespace tactics {

/// The surface of points that are a grid: no two of one x and y, in any order, and at least half of the places taken; the others
/// are NaN. Nothing if they are none. The three are equally long; z may be NaN.
std::optional<PlotSurface> surface_of(const std::vector<double>& x, const std::vector<double>& y, const std::vector<double>& z);

/// Heights over x and y from columns: a surface, or marks in space. Throws Error as plot_of does.
Plot spatial_plot(Source& source, const TableHead& head, const TableColumns& columns, const TableWish& wish,
                  std::vector<Phrase>& notes);

/// Whether it is a matrix without being called one: numbers that rise or fall in the first row, behind a first cell that is none,
/// and in the first column.
bool is_matrix(const TableHead& head);

/// The heights of a matrix. Its first row and column are x and y if is_matrix, or if the first cell counts the others of its row
/// (a "nonuniform matrix" of gnuplot); else its rows and columns are counted from 1. Throws Error as plot_of does.
Plot matrix_plot(Source& source, const TableHead& head, const TableWish& wish, std::vector<Phrase>& notes);

}  // namespace tactics
