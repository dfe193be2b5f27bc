// SPDX-License-Identifier: Apache-2.0
// Which elements of SVG are rendered where they stand, and which are found by their names.
#pragma once

#include <map>
#include <string>

#include "tactics/readers/xml.h"

namespace tactics {

bool is_rendered(const Element& element);  ///< false: it stands there for others to use, or tells something

bool is_group(const Element& element);  ///< its children are drawn as they stand

/// No hash: a file could have thousands that collide.
using ElementsById = std::map<std::string, const Element*, std::less<>>;
/// The first of each name among `root` and all in it, which outlives this.
ElementsById elements_by_id(const Element& root);

/// Empty: none in it has a title.
std::string first_title_in(const Element& root);

}  // namespace tactics
