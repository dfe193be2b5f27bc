// SPDX-License-Identifier: Apache-2.0
// A simulated reader who feels raised sheets and finds a sheet again among others: closed-set matching, as in the pilot study of
// TACTICS (J. P. Fritz, T. P. Way, K. E. Barner, Haptic Representation of Scientific Data for Visually Impaired or Blind Persons,
// section 2). There a blindfolded person felt one sheet and then looked by touch for the identical one among all sheets that were
// processed alike. So the reader compares felt sheets with each other, never a sheet with a picture: the result shows which
// sheets can be told apart and remembered, not whether anybody recognises what they show. The reader has not been validated on
// people.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "tactics/text/phrase.h"

namespace tactics {

/// A square sheet: for each cell the raised share (0 to 1), row by row.
struct Relief {
    int cells = 0;           ///< along a side
    double mm_per_cell = 0;  ///< 0.5 or less: finer than any fingertip
    std::vector<float> raised;
};

/// The defaults describe a typical reader. Sources are named where they exist; places, edges, following and returning model a
/// person's strategy, which has not been measured on such sheets, and the order of recipes depends most on these.
struct FingertipReader {
    /// mm; what lies closer than this is felt as one: width at half height of a Gaussian low-pass (the filter is that of
    /// J. M. Loomis 1990). Gaps of 0.87 mm (K. O. Johnson, J. R. Phillips 1981) and gratings of 0.94 mm (R. W. Van Boven,
    /// K. O. Johnson 1994) are told by young adults who touch with care.
    double acuity = 1.5;
    /// 0 to 1; how much of what is felt are changes of height rather than height: nerves answer to an edge more than to a
    /// plateau (J. R. Phillips, K. O. Johnson 1981, part II).
    double edges = 0;
    /// Error of the finger's believed position: standard deviation as a share of the distance from the nearest edge of the sheet,
    /// on each axis. Distances that an arm moves are told apart at 11 % (F. E. van Beek, W. M. Bergmann Tiest, A. M. L. Kappers
    /// 2014); that compares two, each with an error of 1 / sqrt(2) of it. On 63.5 mm it is 1.2 mm on average. Without any edge to
    /// feel it would be 4 to 7 mm or 0.25 to 0.4 (elbow and shoulder are known to 0.6-1.1 degrees, R. J. van Beers, A. C. Sittig,
    /// J. J. Denier van der Gon 1998).
    double position_noise = 0.08;
    /// The sheet is remembered as squares, this many along a side: 8 on 63.5 mm are squares as wide as a finger pad.
    int grid = 8;
    /// Number of remembered squares: the middle of the range of 8 to 20 of 64 in which the prototype of this reader came closest
    /// to the pilot study. Spans of touch in the laboratory are lower (E. Q. Gilson, A. D. Baddeley 1969).
    int places = 14;
    /// Resolution of the memory of a square: 2 bits are 4 grades. People distinguish 4 to 8 grades of one quantity (G. A. Miller
    /// 1956).
    double bits = 2;
    /// 0 to 1; how often the finger continues next to its position, towards the strongest sensation (contour following, S. J.
    /// Lederman, R. L. Klatzky 1987), rather than to anything anywhere.
    double following = 1;
    /// 0 to 1; share of trials in which each sheet of the collection is felt only in the squares remembered from the target. In
    /// the others, each sheet is explored like the target, from anywhere, and both memories are compared.
    double returning = 0;
};

/// The range of a parameter in a search for readers under whom a result holds.
struct ReaderRange {
    SourceWords name;
    SourceWords unit;
    double least = 0, most = 0;
    double (*get)(const FingertipReader& reader) = nullptr;
    void (*set)(FingertipReader& reader, double value) = nullptr;
};
/// For all parameters except the grid.
std::array<ReaderRange, 7> reader_ranges();
/// Each parameter anywhere in its range, evenly.
FingertipReader random_reader(std::uint64_t seed);

/// The chosen sheet for reader r who felt sheet s, at r * sheets + s.
struct Answers {
    std::size_t sheets = 0;
    std::vector<std::uint16_t> taken;
};
/// Each of `readers` readers, alike but for chance, looks once for each sheet among all. All sheets have the same size.
Answers match_sheets(const std::vector<Relief>& sheets, const FingertipReader& reader, int readers, std::uint64_t seed);

struct Interval {
    double low = 0, high = 0;
};
/// 95 % interval of a share (E. B. Wilson 1927).
Interval wilson(std::size_t hits, std::size_t trials);

}  // namespace tactics
