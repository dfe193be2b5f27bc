// SPDX-License-Identifier: Apache-2.0
// Letters that small print hardly tells from each other.
#pragma once

namespace tactics {

bool is_accented(char32_t code);
bool is_raised_figure(char32_t code);
bool is_lowered_figure(char32_t code);
/// A stem, with or without a dot or an accent.
bool is_thin(char32_t code);
/// They differ by their height alone, which a pixel more or less does not tell. A 0 is seldom an o.
bool is_same_in_two_sizes(char32_t one, char32_t other);

}  // namespace tactics
