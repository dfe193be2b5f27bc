// SPDX-License-Identifier: Apache-2.0
// What the lines of a page are for, and how high each kind stands where dots have several heights.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace tactics {

/// From the highest to the lowest.
enum class LineKind : std::uint8_t {
    drawn,    ///< outlines, curves, symbols, areas; braille stands as high
    inner,    ///< details inside things
    values,   ///< axes, ticks, lead lines, scale bars, marks
    grid,     ///< grid lines
    pattern,  ///< textures of areas
};
inline constexpr std::size_t kLineKinds = 5;

/// The heights of a machine's dots.
struct DotHeights {
    int levels = 2;  ///< including down
    /// Shares of the full height that the user gave to kinds of lines, at most 1; 0: left to the page.
    std::array<double, kLineKinds> wished = {};

    bool operator==(const DotHeights&) const = default;
    bool any_wished() const {
        return std::any_of(wished.begin(), wished.end(), [](double share) { return share > 0; });
    }
};

/// A choice for all pages of a drawing (layout/chosen_heights.h). As it begins, all lines have the full height.
struct KindHeights {
    DotHeights dots = {};
    int used = 1;                             ///< the fewest that lose the least
    std::array<int, kLineKinds> rank = {};    ///< of each kind, from 0, the highest, to used - 1
    std::array<bool, kLineKinds> there = {};  ///< which kinds are on the pages
    std::vector<double> losses = {};  ///< share of the bits that 1, 2 ... heights do not tell; one for each that was tried

    int most() const { return std::max(1, dots.levels - 1); }  ///< that a dot can be raised to
    /// Of the full height, what the user wished or, for two heights, 1 and 0.5. Over 0.
    double share(LineKind kind) const {
        const auto at = static_cast<std::size_t>(kind);
        return dots.wished[at] > 0 ? dots.wished[at] : static_cast<double>(used - rank[at]) / used;
    }
    /// Lines of one kind are higher than those of another.
    bool differ() const {
        for (std::size_t kind = 0; kind < kLineKinds; ++kind)
            if (there[kind] && share(static_cast<LineKind>(kind)) != share(LineKind::drawn)) return true;
        return false;
    }
};

}  // namespace tactics
