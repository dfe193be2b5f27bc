// SPDX-License-Identifier: Apache-2.0
// A place in a picture that a person names: a box around a thing, or a point in it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tactics {

/// As shares of the picture's width and height, from its left and its top, 0 to 1. A point has no size.
struct Spot {
    double left = 0, top = 0, right = 0, bottom = 0;

    bool is_box() const { return right > left && bottom > top; }
    bool operator==(const Spot&) const = default;
};

inline constexpr std::size_t kMostSpots = 100;

/// "20%,30%-70%,90%" is a box, any two opposite corners of it; "40%,50%" a point; several are joined by ";". Nothing: none.
/// Throws Error(usage) at `place`; `what` begins its message: "outlines subject".
std::vector<Spot> parse_spots(std::string_view text, std::string_view place, std::string_view what);

/// Text that parse_spots reads back to the same.
std::string to_text(const Spot& spot);
std::string to_text(const std::vector<Spot>& spots);

}  // namespace tactics
