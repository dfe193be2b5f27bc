// SPDX-License-Identifier: Apache-2.0
// Which elements of SVG are rendered where they stand.
#pragma once

#include "tactics/readers/xml.h"

namespace tactics {

bool is_rendered(const Element& element);  ///< false: it stands there for others to use, or tells something

bool is_group(const Element& element);  ///< its children are drawn as they stand

}  // namespace tactics
