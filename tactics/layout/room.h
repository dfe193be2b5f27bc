// SPDX-License-Identifier: Apache-2.0
// Free space on a page, for things that must stand clear of everything else.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "tactics/page.h"

namespace tactics {

/// The point of a rectangle that is nearest to a point.
Point nearest_of(const Rect& rect, Point p);

/// From braille to the edge of anything else: 1/8 in between any two elements (L. Hasty, Designing Tactile Graphics), mm.
inline constexpr double kFromBraille = 3.2;
/// The same on that medium, whose gap between lines may be more or less.
inline double clear_of_braille(const Medium& medium) { return medium.gap > kFromBraille ? medium.gap : kFromBraille; }

/// The rectangle around all possible dots of the cells of that line.
Rect extent_of(const BrailleLine& line, const CellSize& cell, double dot);

/// The rectangle of a line of print, as high as its tallest letters.
Rect extent_of(const PrintLine& line);

/// The page in squares of half a millimetre (larger on a page of several square metres). A free place is at least the requested
/// distance from all ink; it may be up to a square farther away.
class Room {
public:
    /// Nothing may stand within `clear` mm of anything on the page or of the live area's border.
    Room(const Page& page, double clear);

    bool is_free(const Rect& rect) const;

    /// The free place of that size nearest to a point, at most `reach` away; `accept` may refuse places. A place around the point
    /// is nearest of all, then one to its right.
    template <typename Accept>
    std::optional<Rect> nearest(Point to, double width, double height, double reach, Accept accept) const {
        for (const Rect& rect : around(to, width, height, reach))
            if (accept(rect)) return rect;
        return std::nullopt;
    }
    /// Any free place of that size that `accept` does not refuse: the lowest, and of these the leftmost.
    template <typename Accept>
    std::optional<Rect> lowest(double width, double height, Accept accept) const {
        for (double top = down_.at_most(live_.top + live_.height - height); top >= live_.top; top -= down_.step)
            for (double left = across_.at_least(live_.left); left + width <= live_.left + live_.width; left += across_.step)
                if (const Rect rect{left, top, width, height}; is_free(rect) && accept(rect)) return rect;
        return std::nullopt;
    }

    /// Marks that box as occupied; it keeps its distance from then on.
    void take(const Rect& rect);
    void take(Point from, Point to, double width);

private:
    /// Possible left and top edges of braille: anywhere, tried every millimetre, or where a machine has dots for it.
    struct Edges {
        double step = 1;  ///< mm
        std::optional<double> first;
        double at_least(double edge) const { return first ? *first + std::ceil((edge - *first) / step - 1e-9) * step : edge; }
        double at_most(double edge) const { return first ? *first + std::floor((edge - *first) / step + 1e-9) * step : edge; }
    };

    struct Span {
        int begin, end;  // of squares; exclusive
    };
    Span span_of(double from, double length) const;
    bool is_free(Span across, Span down) const;
    std::vector<Rect> around(Point to, double width, double height, double reach) const;
    struct Squares {
        int left, top, right, bottom;  // right and bottom are exclusive
    };
    Squares squares_of(const Rect& rect) const;
    void fill(std::vector<std::uint8_t>& squares, const Rect& rect) const;
    void mark(const Rect& rect);
    void mark(Point from, Point to, double width);
    void mark(const Area& area);
    void keep_clear();
    /// How many squares each of a row is from its ink, at most so many.
    void measure_row(const std::uint8_t* ink, std::uint8_t most, std::uint8_t* away) const;
    void block_margins();
    void add_up(int top, int bottom);  // updates the rows that have changed

    double clear_;
    double square_;  // mm
    Rect live_;
    Edges across_, down_;
    int columns_, rows_;
    std::vector<std::uint8_t> ink_;      // 1: something is there
    std::vector<std::uint8_t> blocked_;  // 1: something is too near
    // Counts of blocked squares above and to the left of each corner, separately for each strip of rows: adding a thing to a page
    // of many sheets changes only a few counts.
    std::vector<std::uint32_t> sums_;
};

}  // namespace tactics
