// SPDX-License-Identifier: Apache-2.0
// All lists of the program as one: what `list`, `help`, completion and the man page walk through.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tactics {

struct Group {
    std::string_view name;      ///< "filters", as it is typed
    std::string_view singular;  ///< "filter"
    std::string_view summary;
};

struct Entry {
    std::string_view name;  ///< as it is typed; for a reader its extensions are what a user knows
    std::string_view summary;
};

std::span<const Group> groups();
const Group* find_group(std::string_view name);  ///< nullptr if there is none
std::vector<Entry> entries_of(std::string_view group);

/// Every NAME.OPTION that --set knows: of filters, then of formats.
std::vector<std::string> setting_names();
/// Every RULE.LIMIT that the --set of check knows besides.
std::vector<std::string> limit_names();

}  // namespace tactics
