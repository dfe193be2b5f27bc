// SPDX-License-Identifier: Apache-2.0
// The name of a quantity and its unit, as written above a column or at an axis.
#pragma once

#include <string>
#include <string_view>

namespace tactics {

struct NamedUnit {
    std::string_view name;
    std::string_view unit;  ///< empty: there is none
};

/// "time (s)", "time [s]" and "time, s" are time in s. Text after a comma is a unit if it has no blank and no word of more than
/// six letters: "time for a picture, ms" and "force, N/mm", not "rivers, unnamed". The views point into `text`.
NamedUnit name_and_unit(std::string_view text);

/// The name without its unit.
inline std::string bare_name(std::string_view text) { return std::string(name_and_unit(text).name); }

}  // namespace tactics
