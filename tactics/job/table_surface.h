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

/// The surface of points that form a grid: in any order, no two with the same x and y, and at least half of the places occupied;
/// the others are NaN. Nothing if they do not form a grid. The three vectors have the same length; z may be NaN.
std::optional<PlotSurface> surface_of(const std::vector<double>& x, const std::vector<double>& y, const std::vector<double>& z);

/// Heights over x and y from columns, as a surface or as marks in space. Throws Error as plot_of does.
Plot spatial_plot(Source& source, const TableHead& head, const TableColumns& columns, const TableWish& wish,
                  std::vector<Phrase>& notes);

/// Whether the table is recognisable as a matrix: numbers that rise or fall in the first row, after a first cell without a
/// number, and in the first column.
bool is_matrix(const TableHead& head);

/// The heights of a matrix. Its first row and column are x and y if is_matrix, or if the first cell gives the number of other
/// cells in its row (gnuplot's "nonuniform matrix"); else rows and columns are numbered from 1. Throws Error as plot_of does.
Plot matrix_plot(Source& source, const TableHead& head, const TableWish& wish, std::vector<Phrase>& notes);

}  // namespace tactics
