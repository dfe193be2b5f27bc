// SPDX-License-Identifier: Apache-2.0
// A shell of a surface by its sides, and which of its faces are one plane to a hand.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "tactics/solid/welded.h"

namespace tactics {

/// A side of a face, as the face goes round it.
struct Half {
    Corner from, to;
    std::uint32_t face;
};

/// All by the places of the shell's faces.
struct Shell {
    const WeldedSurface& surface;
    std::vector<CornerRing> rings = {};
    std::vector<Point3> doubled = {};                                            ///< areas, as doubled_area
    std::vector<Half> halves = {};                                               ///< by their corners
    std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> by_side = {};  ///< halves from a corner to a corner
    std::vector<std::uint32_t> patch = {};                                       ///< of each face, from grow_patches

    static std::uint64_t key(Corner from, Corner to) { return static_cast<std::uint64_t>(from) << 32 | to; }
    /// The faces on the other side of that side; null: none.
    const std::vector<std::uint32_t>* beyond(Corner from, Corner to) const {
        const auto found = by_side.find(key(to, from));
        return found == by_side.end() ? nullptr : &found->second;
    }
};

Shell shell_of(const WeldedSurface& surface, const std::vector<std::uint32_t>& faces);

/// Fills `patch`: connected faces in one plane have the same number. Gives the number of patches.
std::uint32_t grow_patches(Shell& shell);

}  // namespace tactics
