// SPDX-License-Identifier: Apache-2.0
// What stands in a text, by regular expressions in ECMAScript's grammar; ^ and $ are the ends of lines. <regex> takes the
// compiler longer than most tests, so only patterns.cpp includes it.
#pragma once

#include <string>
#include <vector>

namespace tactics::tests {

/// The whole of a place that fits a pattern, then its groups; one that took no part is empty.
using Fit = std::vector<std::string>;

/// Empty if the whole text does not fit.
Fit whole_fit(const std::string& text, const std::string& pattern);
/// Empty if nothing fits.
Fit first_fit(const std::string& text, const std::string& pattern);
/// From the begin to the end, none in another.
std::vector<Fit> all_fits(const std::string& text, const std::string& pattern);
std::string without(const std::string& text, const std::string& pattern);

}  // namespace tactics::tests
