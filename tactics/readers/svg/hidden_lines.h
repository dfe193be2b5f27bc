// SPDX-License-Identifier: Apache-2.0
// What lies behind an opaque surface of a figure is not seen, and not drawn; words there are told of.
#pragma once

#include <cstddef>
#include <vector>

#include "tactics/geometry/box.h"
#include "tactics/geometry/grid.h"
#include "tactics/readers/svg/found_page.h"
#include "tactics/readers/svg/svg_path.h"
#include "tactics/readers/svg/svg_style.h"

namespace tactics {

/// The surfaces of a figure that are drawn and let nothing through, in their order. White ones without an outline are no such
/// surfaces, as they only make room for words; nor are those of points and other small marks, which sit on lines.
class Covers {
public:
    /// The next surface, before it is drawn. `clip`: what is to be seen of all, mm.
    void add(const std::vector<Subpath>& surface, const Paint& fill, const Paint& stroke, const Rect& clip,
             const FoundPage& figure);

    /// Cuts away what lies behind them. Of very many lines and surfaces some stay.
    void hide_behind(FoundPage& figure);

private:
    struct Cover {
        std::vector<std::vector<Point>> rings;
        Box box;
        std::size_t strokes, areas, words;  // of the page, that were drawn before
        bool drawn;                         // it is not white, or has a line around it
    };
    static bool has_outline(const Cover& cover, const FoundPage& figure);
    void hide_areas(FoundPage& figure, const Grid& grid, std::size_t work) const;
    void hide_words(FoundPage& figure, const Grid& grid) const;

    std::vector<Cover> all_;
};

}  // namespace tactics
