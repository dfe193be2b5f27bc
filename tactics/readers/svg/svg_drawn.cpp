// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/svg/svg_drawn.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace tactics {

namespace {

// Elements that stand in a file to be used by others, or that are not drawn.
constexpr std::array<std::string_view, 18> kNotDrawn = {
    "defs",     "symbol", "clipPath", "mask",  "pattern", "marker",    "linearGradient", "radialGradient",   "filter",
    "metadata", "title",  "desc",     "style", "script",  "namedview", "animate",        "animateTransform", "set"};

}  // namespace

bool is_rendered(const Element& element) {
    return std::find(kNotDrawn.begin(), kNotDrawn.end(), element.name) == kNotDrawn.end();
}

bool is_group(const Element& element) {
    return element.name == "g" || element.name == "a" || element.name == "page" || element.name == "pageSet";
}

}  // namespace tactics
