// SPDX-License-Identifier: Apache-2.0
// What the lines of a drawing are for, told by their heights, where dots stand at several of them.
//
// A finger that meets a line wants to know whether it is of the thing itself or of what is around it. Heights tell this at once,
// and the drawing stands highest. The measure is how many bits of it they tell: the entropy of what a mm of line is for, of which
// lines that share a height leave their own. No more heights are taken than tell more, so that steps between them are large.
#pragma once

#include <span>

#include "tactics/layout/pages.h"

namespace tactics {

/// Of pages that are felt as one.
KindHeights kind_heights(std::span<const Page> pages, const DotHeights& dots);

/// For all pages of a drawing, so that a line has one height on every sheet and in every part that a display shows.
void choose_heights(Pages& pages, const DotHeights& dots);

}  // namespace tactics
