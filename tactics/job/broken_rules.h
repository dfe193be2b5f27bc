// SPDX-License-Identifier: Apache-2.0
// The rules that pages break.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "tactics/medium.h"
#include "tactics/page.h"

namespace tactics {

struct BrokenRule {
    std::string_view name;
    bool hard = false;       ///< the page is not fit to be used; otherwise a person should look
    std::size_t places = 0;  ///< on all pages together
    bool complete = true;    ///< false: there is so much that looking was ended, and there may be more places
};

/// Uses the limits of that medium; in the order of the rules. Time and memory are bounded as in check_page.
std::vector<BrokenRule> rules_broken_by(const std::vector<Page>& pages, const Medium& medium);

}  // namespace tactics
