// SPDX-License-Identifier: Apache-2.0
#include "tactics/artwork.h"

namespace tactics {

Kind kind_of(const Artwork& artwork) {
    if (std::holds_alternative<Image>(artwork)) return Kind::picture;
    if (std::holds_alternative<RegionTree>(artwork)) return Kind::regions;
    return std::holds_alternative<EdgeMap>(artwork) ? Kind::edges : Kind::drawing;
}

std::string_view name_of(Kind kind) {
    switch (kind) {
        case Kind::picture: return "picture";
        case Kind::edges: return "edge map";
        case Kind::regions: return "tree of regions";
        case Kind::drawing: return "drawing";
    }
    return "";
}

}  // namespace tactics
