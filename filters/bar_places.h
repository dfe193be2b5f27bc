// SPDX-License-Identifier: Apache-2.0
// Thickness and distance of the bars of a chart, so that a finger can tell them apart.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "tactics/medium.h"

namespace tactics {

/// How a bar is drawn, in order of the room needed.
enum class BarLook : std::uint8_t {
    outlined,  ///< a line around its texture
    hollow,    ///< an empty outline; only with one series, since several would be alike
    solid,     ///< black: the same where dots stand in cells, and a line around nothing would need more rows of them
    bare,      ///< its texture alone, with a line across its end
};

/// Bars along their axis. The bars of a category stand side by side as a cluster in the middle of a slot.
struct BarPlaces {
    BarLook look = BarLook::outlined;
    double slot = 0;       ///< mm from one category to the next
    double thickness = 0;  ///< mm of a bar, between the middles of its lines
    double between = 0;    ///< mm from one bar of a cluster to the next
    std::size_t bars = 1;  ///< of a cluster

    double cluster() const { return static_cast<double>(bars) * thickness + static_cast<double>(bars - 1) * between; }
    /// Where a bar of the cluster in that slot begins, from the beginning of the first slot, mm.
    double begin_of(std::size_t category, std::size_t bar) const {
        return static_cast<double>(category) * slot + (slot - cluster()) / 2 + static_cast<double>(bar) * (thickness + between);
    }
};

/// Where dots stand in cells, from a cell to the next or, if bars run level, from a line of cells to the next. All bars meet rows
/// of dots alike if they stand so apart.
struct BarPitch {
    double mm = 0;       ///< 0: anything can stand anywhere
    bool lines = false;  ///< of cells: the first and the last of their rows of dots are 5 mm apart, and there are no others
};

/// Places for that many clusters of that many bars on `length` mm; nothing if they have no room.
std::optional<BarPlaces> bars_on(double length, std::size_t clusters, std::size_t bars, BarLook look, const Medium& medium,
                                 const BarPitch& pitch);

}  // namespace tactics
