// SPDX-License-Identifier: Apache-2.0
// How large an SVG is on paper, and what its numbers mean there.
#pragma once

#include <optional>
#include <string>

#include "tactics/medium.h"
#include "tactics/readers/svg/transform.h"
#include "tactics/readers/xml.h"
#include "tactics/text/phrase.h"

namespace tactics {

struct SvgSize {
    double width = 0, height = 0;            ///< mm
    double view_width = 0, view_height = 0;  ///< in its own units
    Transform to_mm;
    bool told = true;  ///< false: in pixels, or it is that of the paper
    Phrase note;       ///< what was assumed; empty: nothing
};

/// `paper` is for a file that tells no size. Throws Error(failed).
SvgSize size_of_svg(const Element& root, const std::string& file, const std::optional<Paper>& paper);

/// Every figure is 200 mm wide or high while it is read, so that the same drawing is the same page in any size.
void scale_to_figure(SvgSize& size);

/// The four numbers of a viewBox; gives false if it has none.
bool view_box(const Element& element, double view[4]);

}  // namespace tactics
