// Round values along an axis.
#pragma once

#include <vector>

namespace tactics {

/// At most `most` (>= 3) round values, ascending, the outer ones on or outside [low, high], which are finite: steps of 1, 2 or 5
/// times a power of ten. On a logarithmic axis (low > 0) powers of ten, or 1, 2 and 5 times these if there is room.
std::vector<double> ticks_for(double low, double high, bool logarithmic, int most);

}  // namespace tactics
