// SPDX-License-Identifier: Apache-2.0
// Sides of faces, brought together where they are between the same two corners.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace tactics {

/// One side of a face, the way that the face goes round.
struct FaceSide {
    std::uint32_t from, to, face;
};

inline std::uint64_t key_of_side(std::uint32_t one, std::uint32_t other) {
    return static_cast<std::uint64_t>(std::min(one, other)) << 32 | std::max(one, other);
}

/// By their two corners, whichever way they are gone, and of those by their faces.
inline std::vector<FaceSide> sides_of(const std::vector<std::vector<std::uint32_t>>& faces) {
    std::vector<FaceSide> sides;
    for (std::uint32_t face = 0; face < faces.size(); ++face)
        for (std::size_t i = 0; i < faces[face].size(); ++i)
            sides.push_back({faces[face][i], faces[face][(i + 1) % faces[face].size()], face});
    std::stable_sort(sides.begin(), sides.end(),
                     [](const FaceSide& a, const FaceSide& b) { return key_of_side(a.from, a.to) < key_of_side(b.from, b.to); });
    return sides;
}

/// `take` is handed the sides that share their two corners.
template <typename Take>
void each_edge(const std::vector<FaceSide>& sides, Take take) {
    for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
        while (end < sides.size() &&
               key_of_side(sides[end].from, sides[end].to) == key_of_side(sides[begin].from, sides[begin].to))
            ++end;
        take(std::span(sides).subspan(begin, end - begin));
    }
}

}  // namespace tactics
