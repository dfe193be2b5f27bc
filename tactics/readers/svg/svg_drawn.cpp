// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/svg/svg_drawn.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "tactics/readers/svg/svg_numbers.h"

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

namespace {

void add_by_id(const Element& element, ElementsById& all) {
    if (const auto id = element.attribute("id"); !id.empty()) all.emplace(id, &element);
    for (const Element& child : element.children) add_by_id(child, all);
}

}  // namespace

ElementsById elements_by_id(const Element& root) {
    ElementsById all;
    add_by_id(root, all);
    return all;
}

std::string first_title_in(const Element& root) {
    if (root.name == "title") return std::string(without_svg_blanks(root.text));
    std::string title;
    for (auto child = root.children.begin(); title.empty() && child != root.children.end(); ++child)
        title = first_title_in(*child);
    return title;
}

}  // namespace tactics
