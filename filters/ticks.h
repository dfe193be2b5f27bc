// SPDX-License-Identifier: Apache-2.0
// Round values along an axis.
#pragma once

#include <vector>

namespace tactics {

/// An axis from `low` to `high`, both inclusive, and its marked values.
struct Ticks {
    double low = 0, high = 0;
    std::vector<double> at;  ///< at least 2, ascending, within low and high
};

/// An axis that holds [low, high] (finite) with at most `most` (>= 3) round ticks. It ends where the values do if two ticks
/// lie between them, for the next round value may be far: steps of 1, 2 or 5 times a power of ten. On a logarithmic axis
/// (low > 0) 1, 2 and 5 times powers of ten if there is room, else 1 and 3 times, else powers of ten or fewer.
Ticks ticks_for(double low, double high, bool logarithmic, int most);

/// Where the values of an axis are: `low` at `from` and `high` at `to`, mm from the drawing's left or, of an axis that runs up,
/// from its top.
struct AxisPlace {
    double low = 0, high = 0;
    double from = 0, to = 0;
};

}  // namespace tactics
