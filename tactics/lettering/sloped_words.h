// SPDX-License-Identifier: Apache-2.0
// Pieces of ink along a slope, in groups that may be words.
#pragma once

#include <optional>
#include <vector>

#include "tactics/lettering/ink.h"
#include "tactics/lettering/sloped_print.h"

namespace tactics {

/// A setting: pixels of a letter's longer side.
inline constexpr int kMostSlopedSide = 60;

/// A piece of ink as somebody sees it who reads along the slope.
struct Leaning {
    double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
    double ink = 0;
    double width() const { return right - left; }
    double height() const { return bottom - top; }
    void add(const Leaning& other);
};
Leaning leaning(const InkPiece& piece, const SlopedAxes& axes);

/// Numbers are those of its pieces.
struct SlopedGroup {
    std::vector<std::size_t> letters, marks;
    Leaning all;
    double height = 0;  ///< of its tallest letter
    PixelBox box;
    bool certain = false;  ///< its letters are of several shapes, stand on one line and nothing else is near
};

/// The slope that most long groups share, in radians.
std::optional<double> common_slope(const std::vector<InkPiece>& pieces);
/// A name at a slope of its own, of letters that stand free.
struct SlopedName {
    double slope = 0;
    Leaning all;
    PixelBox box;
};
std::vector<SlopedName> sloped_names(const std::vector<InkPiece>& pieces);
/// Each piece is in one of them at most.
std::vector<SlopedGroup> groups_along(const std::vector<InkPiece>& pieces, const SlopedAxes& axes);

}  // namespace tactics
