// SPDX-License-Identifier: Apache-2.0
// Embossers as CUPS knows printers: PPD files (Adobe PostScript Printer Description 4.3, with CUPS's own lines).
#pragma once

#include <string>
#include <string_view>

#include "print/format.h"

namespace tactics {

/// The name that CUPS calls the program by, as its PPD files name their filters.
inline constexpr std::string_view kCupsFilterName = "tacticstoembosser";

inline constexpr std::string_view kPpdMaker = "TACTICS";
/// The name that people choose it by: "TACTICS index-v4, tactile graphics".
std::string ppd_nick_of(std::string_view embosser);

/// A whole PPD file for that embosser, whose jobs the filter of that path makes.
std::string ppd_of(const Format& embosser, std::string_view filter);

/// "TacticsPitch" for the setting pitch.
std::string ppd_name_of(const Option& option);

/// The paper that a page size means ("A4", "w792h828" in points), as --paper takes it; empty: none is known.
std::string paper_of_ppd(std::string_view size);

}  // namespace tactics
