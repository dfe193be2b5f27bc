// SPDX-License-Identifier: Apache-2.0
// The data that pass through a recipe: pixels, then edges or regions, then a drawing.
#pragma once

#include <string_view>
#include <variant>

#include "tactics/drawing.h"
#include "tactics/image.h"
#include "tactics/region_tree.h"

namespace tactics {

using Artwork = std::variant<Image, EdgeMap, RegionTree, Drawing>;

/// The kinds as bits, so that a filter can list those it takes.
enum class Kind : unsigned { picture = 1, edges = 2, drawing = 4, regions = 8 };
using Kinds = unsigned;
constexpr Kinds operator|(Kind a, Kind b) { return static_cast<Kinds>(a) | static_cast<Kinds>(b); }
constexpr bool contains(Kinds kinds, Kind kind) { return (kinds & static_cast<Kinds>(kind)) != 0; }

Kind kind_of(const Artwork& artwork);
std::string_view name_of(Kind kind);  ///< "picture", "edge map", "tree of regions", "drawing"

}  // namespace tactics
