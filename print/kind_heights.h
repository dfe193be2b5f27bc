// SPDX-License-Identifier: Apache-2.0
// What the lines of a page are for, told by their heights, where dots stand at several of them.
//
// A finger that meets a line wants to know whether it is of the thing itself or of what is around it. Heights tell this at once,
// and the drawing stands highest. The measure is how many bits of it they tell: the entropy of what a mm of line is for, of which
// lines that share a height leave their own. No more heights are taken than tell more, so that steps between them are large.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "print/dots.h"
#include "tactics/page.h"

namespace tactics {

/// From the highest to the lowest.
enum class LineKind : std::uint8_t {
    drawn,    ///< outlines, curves, symbols, areas; braille stands as high
    values,   ///< axes, ticks, lead lines, scale bars, marks
    grid,     ///< grid lines
    pattern,  ///< textures of areas
};
inline constexpr std::size_t kLineKinds = 4;
LineKind line_kind(Role role);

struct KindHeights {
    int most = 1;                             ///< that a dot can be raised to
    int used = 1;                             ///< the fewest that lose the least
    std::array<int, kLineKinds> rank = {};    ///< of each kind, from 0, the highest, to used - 1
    std::array<bool, kLineKinds> there = {};  ///< which kinds are on the page
    std::vector<double> losses = {};  ///< share of the bits that 1, 2 ... heights do not tell; one for each that was tried

    /// Of the full height: 1, or for two heights 1 and 0.5. Over 0.
    double share(LineKind kind) const { return static_cast<double>(used - rank[static_cast<std::size_t>(kind)]) / used; }
};

/// Of pages that are felt as one. `most` is 1 at least.
KindHeights kind_heights(std::span<const Page> pages, int most);

/// The dots of raise_on_bed (dots.h), each with 1 and the kind of the highest line through it in place of 1.
Dots kinds_on_bed(const Page& page);
inline LineKind kind_of_dot(std::uint8_t dot) { return static_cast<LineKind>(dot - 1); }  ///< of a dot that is not 0

/// Settings of a format with such dots: 0 takes what kind_heights chooses.
inline constexpr std::string_view kKindSettings[kLineKinds] = {"", "axes", "grid", "pattern"};

}  // namespace tactics
