// SPDX-License-Identifier: Apache-2.0
// A place in a picture named by a person: a box around a thing, or a point in it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tactics {

/// Shares of the picture's width and height, from its left and top, 0 to 1. A point has no size.
struct Spot {
    double left = 0, top = 0, right = 0, bottom = 0;

    bool is_box() const { return right > left && bottom > top; }
    bool operator==(const Spot&) const = default;
};

inline constexpr std::size_t kMostSpots = 100;

/// "20%,30%-70%,90%" is a box by any two opposite corners; "40%,50%" is a point; ";" separates several. Empty text: none. Throws
/// Error(usage) at `place`; `what` begins its message: "outlines subject".
std::vector<Spot> parse_spots(std::string_view text, std::string_view place, std::string_view what);

/// Text that parse_spots reads back to the same spots.
std::string to_text(const Spot& spot);
std::string to_text(const std::vector<Spot>& spots);

}  // namespace tactics
