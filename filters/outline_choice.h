// SPDX-License-Identifier: Apache-2.0
// Chooses the outlines to draw: whole ones that are worth their length.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tactics/region_tree.h"

namespace tactics {

/// A partition of the picture; the arcs between faces of different parts are drawn.
struct Parts {
    std::vector<std::uint32_t> part;  ///< of each face
    bool divides(const RegionArc& arc) const { return part[arc.faces[0]] != part[arc.faces[1]]; }
};

/// Number of pixel sides drawn.
double length_of(const RegionTree& tree, const Parts& parts);

/// The parts whose boundaries are worth the most within a budget: of each step of a boundary its worth less `price`, added up; of
/// outlines the one that gains most for its new length is drawn first. `worth`: of a step of each arc; `most`: sides of pixels.
Parts best_parts(const RegionTree& tree, std::span<const float> worth, double price, double most);

/// The line budget at which photographs were judged, mm, as in line_budget.h.
inline constexpr double kUsualLine = 140;

/// The minimum probability at which something is drawn if nothing is more certain.
inline constexpr double kFaint = 0.15;

/// The parts of a page without a subject: within a line budget (mm, as in line_budget.h), and something faint rather than
/// nothing. A multiple of kUsualLine gives the same multiple of the usual line, if people would draw that much. Arcs that are
/// already `drawn` stay, as in more_parts.
Parts parts_of_page(const RegionTree& tree, std::span<const float> worth, double price, double line, const Parts& drawn = {});

/// The maximum of pixel sides on a page with such a budget.
double most_of_page(const RegionTree& tree, double line);

/// The same as best_parts, with what is drawn already: its arcs stay where their worth is 1, and count for `most`, which they may
/// exceed. An arc of a worth far below 0 is drawn only where the rest of a new outline gains more than it loses.
Parts more_parts(const RegionTree& tree, Parts drawn, std::span<const float> worth, double price, double most);

}  // namespace tactics
