// SPDX-License-Identifier: Apache-2.0
// Figures without the white around them. A photograph is drawn as it is.
#pragma once

#include "tactics/drawing.h"
#include "tactics/image.h"
#include "tactics/page.h"

namespace tactics {

struct FoundPage;

/// A whole picture, as a part of it in shares of its sides.
inline constexpr Rect kWhole{0, 0, 1, 1};

/// The part of a picture with all that stands out from its ground, pale areas and thin lines too, and a little of the ground
/// around it, in shares of its sides. Specks are left out.
/// The whole picture if its edge is not of one ground, or if there is nothing on it.
Rect inked_part(const Image& picture);
/// The same of a figure of lines, with its pictures.
Rect inked_part(const FoundPage& figure);

/// Those pixels, each as large as before.
Image cut_out(Image whole, const Rect& part);
/// That part of a drawing of the whole figure, whose inked part it holds.
Drawing cut_out(Drawing whole, const Rect& part);

}  // namespace tactics
