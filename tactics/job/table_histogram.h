// SPDX-License-Identifier: Apache-2.0
// How often values of a column are where, as bars.
#pragma once

#include <vector>

#include "tactics/plot.h"

namespace tactics {

inline constexpr int kMostChosenBins = 30;  // of a page that is 150 mm wide: narrower bars than 5 mm are no longer felt apart
inline constexpr int kMostHistogramBins = 100;

/// Bins of width 2 IQR / cbrt(n) over all values (D. Freedman and P. Diaconis, "On the histogram as a density estimator: L2
/// theory", Z. Wahrscheinlichkeitstheorie verw. Gebiete 57, 1981, pp. 453-476), the quartiles being the values at the ranks n/4
/// and 3n/4; where half of the values are one, 1 + log2 n of them (H. A. Sturges, "The choice of a class interval", J. Am. Stat.
/// Assoc. 21, 1926, pp. 65-66). From 1 to kMostChosenBins. `values` is put into another order; it is not empty.
int bins_for(std::vector<double>& values);

/// A bar for each of `bins` equal parts of their span (1 wide around them if they are one): a point where it begins, with its
/// count, and one of 0 where the last ends. A value between two bars is in the right one, the highest in the last.
PlotCurve histogram_of(const std::vector<double>& values, int bins);

}  // namespace tactics
