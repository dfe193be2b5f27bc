// SPDX-License-Identifier: Apache-2.0
// The operators that PDF and PostScript share: paths in hundredths of a millimetre, in pure black.
#pragma once

#include <cmath>
#include <string>

#include "print/letters.h"
#include "tactics/page.h"

namespace tactics {

/// Hundredths of a millimetre (2540 to the inch): finer than a device pixel up to 2540 dpi; whole numbers are short and
/// independent of the locale.
inline constexpr double kStepsPerMm = 100;
inline long to_steps(double mm) { return std::lround(mm * kStepsPerMm); }

void append_whole(std::string& text, long value);
/// At most `places` digits after the point, without trailing zeros.
void append_number(std::string& text, double value, int places);

/// Sets the page's coordinates, as a matrix for PDF and PostScript: hundredths of mm, origin top left, y down.
std::string page_matrix(const Page& page);

/// Areas and strokes with the operators m l h f* S w (and J, j for round ends and joins).
std::string ink_of(const Page& page);
/// The dots of a braille line with m c f.
std::string ink_of(const BrailleLine& line, const Page& page);

/// A letter's outline with m l c h, in thousandths of em.
std::string outline_of(const Letter& letter);

}  // namespace tactics
