// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/svg/svg_choice.h"

#include <array>
#include <optional>
#include <string_view>
#include <utility>

#include "tactics/readers/svg/clip.h"
#include "tactics/readers/svg/svg_drawn.h"
#include "tactics/readers/svg/svg_numbers.h"
#include "tactics/text/utf8.h"

namespace tactics {

namespace {

constexpr double kEmCapital = 0.72, kEmLetter = 0.55;  // em, as of texts

bool begins_line(std::string_view name) { return name == "div" || name == "p" || name == "br" || name == "li" || name == "tr"; }

void add_text(const Element& element, std::string& text) {
    if (element.name == "style" || element.name == "script") return;
    if (begins_line(element.name)) text += ' ';
    std::size_t from = 0;
    for (const Element& child : element.children) {
        text += element.text.substr(from, child.after - from);
        from = child.after;
        add_text(child, text);
    }
    text += element.text.substr(from);
    if (begins_line(element.name)) text += ' ';
}

std::string html_text(const Element& element) {
    std::string text;
    add_text(element, text);
    return to_line(text);
}

std::optional<double> css_length(std::string_view style, std::string_view name) {
    while (!style.empty()) {
        const auto end = std::min(style.find(';'), style.size());
        const std::string_view one = style.substr(0, end);
        style.remove_prefix(std::min(end + 1, style.size()));
        const auto colon = one.find(':');
        if (colon != one.npos && without_svg_blanks(one.substr(0, colon)) == name)
            return parse_svg_length(without_svg_blanks(one.substr(colon + 1)), 0);
    }
    return std::nullopt;
}

std::optional<double> font_size_in(const Element& element) {
    for (const Element& child : element.children)
        if (const auto size = font_size_in(child)) return size;
    const auto size = css_length(element.attribute("style"), "font-size");
    return size && *size > 0 ? size : std::nullopt;
}

FoundWords words_of_html(const Element& foreign, const Transform& transform, const Style& style) {
    FoundWords words;
    words.text = html_text(foreign);
    if (words.text.empty()) return words;
    const auto number = [&](std::string_view name) {
        const auto text = foreign.attribute(name);
        return text.empty() || text.ends_with('%') ? std::nullopt : parse_svg_length(text, 0);
    };
    Point middle{number("x").value_or(0) + number("width").value_or(0) / 2,
                 number("y").value_or(0) + number("height").value_or(0) / 2};
    if (!foreign.children.empty()) {
        const std::string_view css = foreign.children.front().attribute("style");
        if (const auto left = css_length(css, "margin-left"), top = css_length(css, "padding-top"); left && top)
            middle = {number("x").value_or(0) + *left + css_length(css, "width").value_or(0) / 2, number("y").value_or(0) + *top};
    }
    const double size = font_size_in(foreign).value_or(style.font_size) * transform.scale();
    words.middle = transform(middle);
    words.height = kEmCapital * size;
    words.width = static_cast<double>(words.text.size()) * kEmLetter * size;
    return words;
}

FoundWords words_of_flow(const Element& flow, const Transform& transform, const Style& style, const SvgLengths& lengths) {
    FoundWords words;
    Extent region;
    for (const Element& part : flow.children) {
        if (part.name == "flowRegionExclude") continue;
        if (part.name != "flowRegion") {
            words.text += " " + html_text(part);
            continue;
        }
        for (const Element& shape : part.children) {
            Pen pen(transform);
            if (draw_outline(shape, lengths, pen, nullptr)) add_all(region, pen.finish());
        }
    }
    words.text = to_line(words.text);
    words.middle = region.points > 0 ? region.box.middle() : transform({0, 0});
    words.height = kEmCapital * style.font_size * transform.scale();
    words.width = region.box.width;
    return words;
}

}  // namespace

SvgChoice chosen_in(const Element& choice) {
    // From the least to the most wanted.
    std::array<const Element*, 4> found{};
    for (const Element& child : choice.children) {
        if (!is_rendered(child)) continue;
        const std::string_view language = child.attribute("systemLanguage");
        const std::size_t rank = child.name == "foreignObject" ? 1 : language.empty() ? 3 : language.starts_with("en") ? 2 : 0;
        if (found[rank] == nullptr) found[rank] = &child;
    }
    SvgChoice chosen;
    for (const Element* one : found)
        if (one != nullptr) chosen.drawn = one;
    if (found[1] == nullptr || chosen.drawn == found[1]) return chosen;
    const std::string whole = html_text(*found[1]), cut = to_line(chosen.drawn->text);
    // A picture of the words has none of its own; other parts than a text may say more than the HTML.
    if (chosen.drawn->name == "image" && !whole.empty())
        chosen.drawn = found[1];
    else if (chosen.drawn->name == "text" && cut.ends_with("..."))
        chosen.words = whole;
    return chosen;
}

bool has_words(const Element& element) {
    return element.name == "text" || element.name == "foreignObject" || element.name == "flowRoot";
}

std::vector<FoundWords> words_in(const Element& element, const Transform& transform, const Style& style, const TextNeeds& needs,
                                 const SvgLengths& lengths) {
    if (element.name == "text") return words_of_text(element, transform, style, needs);
    FoundWords words =
        element.name == "flowRoot" ? words_of_flow(element, transform, style, lengths) : words_of_html(element, transform, style);
    return words.text.empty() ? std::vector<FoundWords>() : std::vector{std::move(words)};
}

}  // namespace tactics
