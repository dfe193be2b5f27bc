// SPDX-License-Identifier: Apache-2.0
// One try at setting the names of a page, for set_names.
#pragma once

#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "tactics/layout/key.h"
#include "tactics/layout/sheet.h"
#include "tactics/page.h"

namespace tactics {

/// What gives way where names have no room.
struct Yielding {
    std::set<std::string> in_letters = {};  ///< before others have words away from their places
    bool all_letters = false;               ///< for names that must be there, even where one of them has room for its words
    bool one_line = false;                  ///< names in several lines take the room of others: all words stand in one
    bool off_thing = false;  ///< names of nothing told apart go to the border of what lies there, if they must be there
};

/// A page with its names.
struct NamedPage {
    Page page;
    std::vector<KeyEntry> key;  ///< if it has no room on the page
    double cost = 0;
};

/// As set_names does; nothing if it costs `most` or more. Throws as set_names does.
std::optional<NamedPage> named_page(const Page& page, const std::vector<Name>& names, const Sheet& sheet,
                                    std::span<const Rect> windows, const Yielding& yielding, double most);

}  // namespace tactics
