// SPDX-License-Identifier: Apache-2.0
// Figures without the white around them. A photograph is drawn as it is.
#pragma once

#include "tactics/drawing.h"
#include "tactics/image.h"
#include "tactics/job/placed_words.h"
#include "tactics/page.h"

namespace tactics {

struct FoundPage;

/// The part of a picture with all that stands out from its ground, and a little of the ground around it, in shares of its sides.
/// The whole picture if its edge is not of one ground, or if there is nothing on it.
Rect inked_part(const Image& picture);
/// The same of a figure of lines, with its pictures.
Rect inked_part(const FoundPage& figure);

/// That part of a drawing of the whole picture, in which nothing is drawn elsewhere.
Drawing cut_out(Drawing whole, const Rect& part);

}  // namespace tactics
