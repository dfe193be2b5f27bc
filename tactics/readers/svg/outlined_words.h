// SPDX-License-Identifier: Apache-2.0
// Words whose letters the maker of a figure turned into filled paths, which nothing tells from what else is filled: Google
// Drawings writes them so, and "outline text" of many tools.
#pragma once

#include <functional>

#include "tactics/readers/svg/found_page.h"
#include "tactics/readers/svg/svg_path.h"
#include "tactics/readers/svg/svg_style.h"

namespace tactics {

/// The next surface of a figure, before it is drawn: kept if it is no larger than letters and as light as paper.
void add_light_shape(FoundPage& figure, const std::vector<Subpath>& surface, const Paint& fill, double lightness);

/// Takes shapes that stand in a row as letters do, and are as large as letters, out of the figure: each row becomes words that
/// say nothing yet, for `read` among its other letters, which is called if there are any. Rows that it takes for no print are
/// drawn again; where it reads most, all are print. Few such shapes, as icons have them, and such as are drawn as their outlines
/// alone, or light on something darker, are print only where they are read.
void read_with_outlined_words(FoundPage& figure, const std::function<void(FoundPage& figure)>& read);

}  // namespace tactics
