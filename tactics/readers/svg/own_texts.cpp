// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/svg/own_texts.h"

#include <algorithm>

#include "tactics/layout/own_marks.h"
#include "tactics/readers/svg/svg_numbers.h"
#include "tactics/readers/svg/svg_style.h"
#include "tactics/text/utf8.h"

namespace tactics {

namespace {

// What stands in it and in its parts, in their order; Inkscape has a part for each line.
void append_said(const Element& element, std::string& said) {
    std::size_t from = 0;
    for (const Element& part : element.children) {
        const std::size_t to = std::min(std::max(part.after, from), element.text.size());
        said += element.text.substr(from, to - from);
        from = to;
        if (part.name != "tspan" && part.name != "textPath" && part.name != "a") continue;
        if (part.attribute("role") == "line" && !said.empty()) said += ' ';
        append_said(part, said);
    }
    said += element.text.substr(from);
}

// Its own place, or that of its first part that has one.
std::optional<double> first_place(const Element& element, std::string_view name) {
    std::string_view numbers = element.attribute(name);
    if (const auto place = take_svg_number(numbers)) return place;
    for (const Element& part : element.children)
        if (part.name == "tspan")
            if (const auto place = first_place(part, name)) return place;
    return std::nullopt;
}

bool is_hidden(const Element& element) {
    if (element.attribute("display") == "none") return true;
    const Declarations style = parse_declarations(element.attribute("style"));
    return std::find(style.begin(), style.end(), Declarations::value_type{"display", "none"}) != style.end();
}

// In a layer that is hidden, only the words of the braille count, which have no place in print.
void collect(const Element& element, const Transform& outer, bool hidden, std::vector<OwnText>& texts) {
    hidden = hidden || is_hidden(element);
    Transform own;
    if (const auto text = element.attribute("transform"); !text.empty() && !parse_transform(text, own)) return;
    const Transform transform = outer * own;
    if (element.name == "text") {
        if (hidden && (element.attribute(marks::kText).empty() || !element.attribute(marks::kNumber).empty())) return;
        std::string said;
        append_said(element, said);
        const Point at{first_place(element, "x").value_or(0), first_place(element, "y").value_or(0)};
        texts.push_back({&element, to_line(said), transform(at), transform});
        return;
    }
    if (element.attribute(marks::kLayer) == marks::kCheckLayer) return;
    if (element.name != "g" && element.name != "a" && element.name != "svg") return;
    for (const Element& child : element.children) collect(child, transform, hidden, texts);
}

}  // namespace

std::vector<OwnText> own_texts(const Element& root, const Transform& to_mm) {
    std::vector<OwnText> texts;
    for (const Element& child : root.children) collect(child, to_mm, false, texts);
    return texts;
}

}  // namespace tactics
