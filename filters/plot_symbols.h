// SPDX-License-Identifier: Apache-2.0
// Five point symbols that a finger can tell apart.
#pragma once

#include "tactics/drawing.h"
#include "tactics/plot.h"

namespace tactics {

/// How far a symbol reaches from its middle, `radius` being that of a disc, mm. A form with corners is larger than a round one.
double reach_of(PlotSymbol symbol, double radius);

/// Puts the symbol there. Discs and triangles are filled, rings and squares are outlines, crosses are two lines: one round and
/// one with corners of each kind, as a finger feels first whether it is filled and then whether it has corners.
void draw_symbol(PlotSymbol symbol, Point at, double radius, Drawing& drawing);

/// The same as one area, so that mending a page moves or leaves it as a whole. Outlines are 0.7 mm wide.
Area symbol_area(PlotSymbol symbol, Point at, double radius);

}  // namespace tactics
