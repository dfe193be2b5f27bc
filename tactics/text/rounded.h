// SPDX-License-Identifier: Apache-2.0
// Numbers in sentences for people.
#pragma once

#include <cmath>
#include <string>

#include "tactics/text/number.h"

namespace tactics {

/// The nearest whole number of steps: rounded(2.3456, 0.01) is "2.35". `step` over 0.
inline std::string rounded(double value, double step) { return to_text(std::round(value / step) * step); }

}  // namespace tactics
