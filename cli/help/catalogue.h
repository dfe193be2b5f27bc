// SPDX-License-Identifier: Apache-2.0
// All lists of the program in one, for `list`, `help`, completion and the man page. A group is one row of catalogue.cpp.
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
    std::string_view name;  ///< as typed; for a reader, its extensions, which users know
    std::string_view summary;
    std::function<std::string()> text;           ///< further help text
    std::span<const Option> options = {};        ///< for a group with settings
    std::string tail = {};                       ///< text of `list` after the summary
    std::function<void(JsonObject&)> json = {};  ///< further members for `list --json`
};

struct Group {
    std::string_view name;      ///< "filters", as typed
    std::string_view singular;  ///< "filter"
    std::string_view summary;
    std::vector<Entry> (*entries)();
    enum class Settings { none, listed, in_manual } settings = Settings::none;  ///< in_manual: and listed
    bool text_in_manual = false;                                                ///< the manual includes the texts of entries
    bool installed = false;         ///< the entries depend on this installation, so the manual, which is made elsewhere, leaves
                                    ///< them out
    bool begins_with_text = false;  ///< in help, without a preceding line with name and summary
    std::vector<Entry> (*kept)() = nullptr;  ///< the user's own entries: for list and help, not for output meant for others
};

std::span<const Group> groups();
/// Includes the user's own entries.
std::vector<Entry> all_entries(const Group& group);
const Group* find_group(std::string_view name);  ///< nullptr if there is none

/// Every NAME.OPTION that --set accepts: of filters, then of formats.
std::vector<std::string> setting_names();
/// Every RULE.LIMIT that --set of check also accepts.
std::vector<std::string> limit_names();

}  // namespace tactics
