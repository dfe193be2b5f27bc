// SPDX-License-Identifier: Apache-2.0
// For every rule the pages on which it measures what is asked for.
#pragma once

#include <functional>
#include <map>
#include <string>

#include "tactics/page.h"

namespace tactics::tests {

/// A page on which the rule measures just that.
using PageOf = std::function<Page(double measure)>;

const std::map<std::string, PageOf>& rule_pages();

}  // namespace tactics::tests
