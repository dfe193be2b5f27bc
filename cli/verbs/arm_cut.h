// SPDX-License-Identifier: Apache-2.0
// A surface felt on an arm by its lines: those of equal height, or those along which it is cut open.
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
    std::optional<int> levels = {};           ///< at most; 0: as many as a finger tells
    std::optional<SectionWish> section = {};  ///< or that
    bool any() const { return levels || section; }
};
/// --levels and --section. Throws Error(usage).
CutWish cut_wish(const Given& given);

/// A plot of curves: the contours in the plane of x and y, or the sections upright over one of them. `field`: mm that x and y
/// will have at most, by which the number of levels is chosen. `told` is told which there are. Throws Error(usage): there is no
/// surface, nothing of it at that height or place.
Plot cut_of(const Plot& plot, const CutWish& wish, Point field, const std::string& name, std::vector<Phrase>& told);

}  // namespace tactics
