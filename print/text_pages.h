// SPDX-License-Identifier: Apache-2.0
// Pages of braille text for a machine, to stand between pages with drawings.
#pragma once

#include <string>
#include <string_view>

#include "print/format.h"

namespace tactics {

/// A file of BRF (North American Braille Computer Code; lines end with LF or CR LF, pages with FF or, if it has none, where the
/// sheet is full; 1Ah at its end is not read) as the bytes of that embosser, on sheets of that size (upright, mm). Throws Error
/// at `name`: usage, a line or a page that has no room on the sheet, or a machine that takes pictures only; failed, a byte that
/// is no letter of braille, or over 20,000 pages.
std::string text_for(std::string_view brf, const Format& format, const Settings& settings, const Paper& paper,
                     std::string_view name);

}  // namespace tactics
