// SPDX-License-Identifier: Apache-2.0
// Embossers as CUPS printers: PPD files (Adobe PostScript Printer Description 4.3, with CUPS's own lines).
#pragma once

#include <string>
#include <string_view>

#include "print/format.h"
#include "tactics/medium.h"

namespace tactics {

/// The filter name in the PPD files, under which CUPS calls the program.
inline constexpr std::string_view kCupsFilterName = "tacticstoembosser";

inline constexpr std::string_view kPpdMaker = "TACTICS";
/// The name that users see: "TACTICS index-v4, tactile graphics".
std::string ppd_nick_of(std::string_view embosser);

/// A whole PPD file for that embosser, with the filter at that path.
std::string ppd_of(const Format& embosser, std::string_view filter);

/// "TacticsPitch" for the setting pitch.
std::string ppd_name_of(const Option& option);

/// The page size for a paper, as the specification names it (PPD 4.3, appendix B): "A4", "Tabloid".
std::string ppd_size_of(const Paper& paper);

/// The paper for a page size ("A4", "w792h828" in points), as for --paper; empty: unknown.
std::string paper_of_ppd(std::string_view size);

}  // namespace tactics
