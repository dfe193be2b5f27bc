// SPDX-License-Identifier: Apache-2.0
// A histogram of a column's values, as bars.
#pragma once

#include <vector>

#include "tactics/plot.h"

namespace tactics {

inline constexpr int kMostChosenBins = 30;  // on a page 150 mm wide: a finger cannot separate bars narrower than 5 mm
inline constexpr int kMostHistogramBins = 100;

/// Bins of width 2 IQR / cbrt(n) over all values (D. Freedman and P. Diaconis, "On the histogram as a density estimator: L2
/// theory", Z. Wahrscheinlichkeitstheorie verw. Gebiete 57, 1981, pp. 453-476), with quartiles at the ranks n/4 and 3n/4; if half
/// of the values are equal, 1 + log2 n bins (H. A. Sturges, "The choice of a class interval", J. Am. Stat. Assoc. 21, 1926, pp.
/// 65-66). From 1 to kMostChosenBins. Reorders `values`, which must not be empty.
int bins_for(std::vector<double>& values);

/// A bar for each of `bins` equal parts of their span (if all are equal, a span of 1 around them): a point at the beginning of
/// each bar, with its count, and a point with 0 at the end of the last. A value on the border of two bars counts in the right
/// one, the highest value in the last.
PlotCurve histogram_of(const std::vector<double>& values, int bins);

}  // namespace tactics
