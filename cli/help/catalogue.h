// SPDX-License-Identifier: Apache-2.0
// All lists of the program as one: what `list`, `help`, completion and the man page walk through. A group is one row of
// catalogue.cpp.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tactics/option.h"
#include "tactics/text/json.h"

namespace tactics {

struct Entry {
    std::string_view name;  ///< as it is typed; for a reader its extensions are what a user knows
    std::string_view summary;
    std::function<std::string()> text;           ///< what help tells besides
    std::span<const Option> options = {};        ///< of a group with settings
    std::string tail = {};                       ///< what list tells behind the summary
    std::function<void(JsonObject&)> json = {};  ///< what `list --json` tells besides
};

struct Group {
    std::string_view name;      ///< "filters", as it is typed
    std::string_view singular;  ///< "filter"
    std::string_view summary;
    std::vector<Entry> (*entries)();
    enum class Settings { none, listed, in_manual } settings = Settings::none;  ///< in_manual: and listed
    bool text_in_manual = false;                                                ///< that of entries, as it stands
    bool installed = false;         ///< what is installed here decides, so the manual, which is made elsewhere, leaves them out
    bool begins_with_text = false;  ///< in help, without a line of name and summary before it
    std::vector<Entry> (*kept)() = nullptr;  ///< what a person keeps besides: for list and help, not for what is made for others
};

std::span<const Group> groups();
/// With those that a person keeps.
std::vector<Entry> all_entries(const Group& group);
const Group* find_group(std::string_view name);  ///< nullptr if there is none

/// Every NAME.OPTION that --set knows: of filters, then of formats.
std::vector<std::string> setting_names();
/// Every RULE.LIMIT that the --set of check knows besides.
std::vector<std::string> limit_names();

}  // namespace tactics
