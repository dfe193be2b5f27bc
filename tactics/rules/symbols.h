// SPDX-License-Identifier: Apache-2.0
// Point symbols as they stand on a page.
#pragma once

#include <vector>

#include "tactics/rules/page_geometry.h"
#include "tactics/text/phrase.h"

namespace tactics {

/// Point symbols: all connected things with this role.
struct Symbol {
    std::vector<std::uint32_t> chains;
    Point middle;
    double size = 0;  ///< mm, the longest way
    Phrase kind;      ///< "filled circle", "square": by which a finger recognises it, besides its size
};

/// Only a file that says what its shapes are for has any.
std::vector<Symbol> symbols_of(const PageGeometry& geometry);

}  // namespace tactics
