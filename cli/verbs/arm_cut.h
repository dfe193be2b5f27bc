// SPDX-License-Identifier: Apache-2.0
// A surface on an arm as lines: contours, or sections.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/command.h"
#include "filters/surface_sections.h"
#include "tactics/drawing.h"
#include "tactics/plot.h"
#include "tactics/text/phrase.h"

namespace tactics {

struct CutWish {
    std::optional<int> levels = {};           ///< maximum number; 0: as many as a finger can tell apart
    std::optional<SectionWish> section = {};  ///< alternatively, sections
    bool any() const { return levels || section; }
};
/// --levels and --section. Throws Error(usage).
CutWish cut_wish(const Given& given);

/// A plot of curves: the contours in the plane of x and y, or the sections upright over one of the axes. `field`: largest size of
/// x and y, mm, which decides the number of levels. `told` receives a list of them. Throws Error(usage) if there is no surface,
/// or nothing of it at that height or place.
Plot cut_of(const Plot& plot, const CutWish& wish, Point field, const std::string& name, std::vector<Phrase>& told);

}  // namespace tactics
