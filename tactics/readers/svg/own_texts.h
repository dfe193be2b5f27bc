// SPDX-License-Identifier: Apache-2.0
// The texts of an SVG of ours, shown or not, as a person has left them.
#pragma once

#include <string>
#include <vector>

#include "tactics/readers/svg/transform.h"
#include "tactics/readers/xml.h"

namespace tactics {

struct OwnText {
    const Element* element = nullptr;
    std::string text;     ///< one line
    Point at;             ///< mm: where its line begins
    Transform transform;  ///< from the element's units to mm
};

/// In the order of the file; `to_mm` is that of the root. Where a text runs over several lines, these are put together.
std::vector<OwnText> own_texts(const Element& root, const Transform& to_mm);

}  // namespace tactics
