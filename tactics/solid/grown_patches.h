// SPDX-License-Identifier: Apache-2.0
// Which faces of a shell are one plane to a finger.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "tactics/solid/welded_surface.h"

namespace tactics {

/// Faces that hang together and all that is asked of them, by their places in the shell.
struct FaceShell {
    const WeldedSurface& surface;
    std::vector<CornerRing> rings;
    std::vector<Point3> doubled;
    std::vector<FaceSide> halves;                                           // by their corners
    std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> by_side;  // halves from a corner to a corner
    std::vector<std::uint32_t> patch;                                       // of each face

    static std::uint64_t key(std::uint32_t from, std::uint32_t to) { return static_cast<std::uint64_t>(from) << 32 | to; }
    // The faces on the other side of that side.
    const std::vector<std::uint32_t>* beyond(std::uint32_t from, std::uint32_t to) const {
        const auto found = by_side.find(key(to, from));
        return found == by_side.end() ? nullptr : &found->second;
    }
};

/// Fills in `patch`; gives how many there are. The same patches however a plane is cut into faces.
std::uint32_t grow_patches(FaceShell& shell);

}  // namespace tactics
