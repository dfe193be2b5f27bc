// SPDX-License-Identifier: Apache-2.0
// Pages of braille text for a machine, for use between pages with drawings.
#pragma once

#include <string>
#include <string_view>

#include "print/format.h"

namespace tactics {

/// Converts a BRF file (North American Braille Computer Code; lines end with LF or CR LF, pages with FF or, if it has none, when
/// the sheet is full; 1Ah at its end is ignored) to the bytes of that embosser, on sheets of that size (upright, mm). Throws
/// Error at `name`: usage for a line or a page that has no room on the sheet, or a machine that takes only pictures; failed for a
/// byte that is no braille letter, or over 20,000 pages.
std::string text_for(std::string_view brf, const Format& format, const Settings& settings, const Paper& paper,
                     std::string_view name);

}  // namespace tactics
