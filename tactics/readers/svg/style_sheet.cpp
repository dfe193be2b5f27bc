// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/svg/style_sheet.h"

#include <algorithm>
#include <optional>

#include "tactics/readers/svg/svg_gradient.h"
#include "tactics/readers/svg/svg_numbers.h"
#include "tactics/readers/svg/svg_pattern.h"

namespace tactics {

namespace {

constexpr std::size_t kMostParts = 16;   // of a selector
constexpr int kMostOuter = 64;           // elements around one that are asked
constexpr std::size_t kMostAlike = 200;  // rules for one id, class or tag
constexpr int kMostClasses = 64;         // of an element

std::string without_comments(std::string_view text) {
    std::string clean;
    for (std::size_t at = 0; at < text.size();) {
        const auto open = text.find("/*", at);
        clean += text.substr(at, open == std::string_view::npos ? open : open - at);
        if (open == std::string_view::npos) break;
        const auto close = text.find("*/", open + 2);
        if (close == std::string_view::npos) break;
        at = close + 2;
    }
    return clean;
}

bool in_name(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_' || (c & 0x80) != 0;
}

std::string_view take_name(std::string_view& text) {
    const auto end = static_cast<std::size_t>(std::find_if_not(text.begin(), text.end(), in_name) - text.begin());
    const std::string_view name = text.substr(0, end);
    text.remove_prefix(end);
    return name;
}

bool has_class(std::string_view classes, std::string_view name) {
    while (!classes.empty()) {
        const auto length =
            static_cast<std::size_t>(std::find_if(classes.begin(), classes.end(), is_svg_blank) - classes.begin());
        if (classes.substr(0, length) == name) return true;
        classes.remove_prefix(std::min(length + 1, classes.size()));
    }
    return false;
}

bool blurs(const Element& filter) {
    return std::any_of(filter.children.begin(), filter.children.end(),
                       [](const Element& part) { return part.name == "feGaussianBlur"; });
}

}  // namespace

bool StyleSheet::Simple::fits(const Element& element) const {
    if ((!tag.empty() && element.name != tag) || (!id.empty() && element.attribute("id") != id)) return false;
    return std::all_of(classes.begin(), classes.end(),
                       [&](const std::string& name) { return has_class(element.attribute("class"), name); });
}

bool StyleSheet::Rule::fits(const Element& element, const Style& parent) const {
    if (!parts.back().fits(element)) return false;
    const Style* around = &parent;
    int steps = 0;
    for (std::size_t i = parts.size() - 1; i-- > 0;) {
        const bool child = parts[i + 1].child;
        while (around != nullptr && around->of != nullptr && !parts[i].fits(*around->of)) {
            if (child || ++steps > kMostOuter) return false;
            around = around->outer;
        }
        if (around == nullptr || around->of == nullptr) return false;
        around = around->outer;
    }
    return true;
}

bool StyleSheet::parse(std::string_view selector, Rule& rule) {
    bool child = false;
    selector = without_svg_blanks(selector);
    while (!selector.empty()) {
        if (selector.front() == '>' && !child && !rule.parts.empty()) {
            child = true;
            selector = without_svg_blanks(selector.substr(1));
            continue;
        }
        Simple part;
        part.child = child;
        child = false;
        const std::size_t before = selector.size();
        if (selector.front() == '*')
            selector.remove_prefix(1);
        else
            part.tag = take_name(selector);
        while (!selector.empty() && (selector.front() == '.' || selector.front() == '#')) {
            const bool is_class = selector.front() == '.';
            selector.remove_prefix(1);
            const std::string name(take_name(selector));
            if (name.empty()) return false;
            if (is_class)
                part.classes.push_back(name);
            else
                part.id = name;
        }
        if (selector.size() == before || rule.parts.size() == kMostParts) return false;
        rule.rank += (part.id.empty() ? 0 : 10'000) + 100 * static_cast<int>(part.classes.size()) + (part.tag.empty() ? 0 : 1);
        rule.parts.push_back(std::move(part));
        if (!selector.empty() && !is_svg_blank(selector.front()) && selector.front() != '>') return false;
        selector = without_svg_blanks(selector);
    }
    return !rule.parts.empty() && !child;
}

void StyleSheet::add(std::string_view text, Missed& missed) {
    const std::string clean = without_comments(text);
    std::string_view rest = clean;
    for (;;) {
        const auto open = rest.find('{'), close = rest.find('}');
        if (open == std::string_view::npos || close == std::string_view::npos || close < open) break;
        std::string_view selectors = rest.substr(0, open);
        const auto declarations = parse_declarations(rest.substr(open + 1, close - open - 1));
        rest.remove_prefix(close + 1);
        if (without_svg_blanks(selectors).starts_with("@font-face")) continue;
        while (!selectors.empty()) {
            const auto comma = selectors.find(',');
            Rule rule;
            const bool known = parse(selectors.substr(0, comma), rule);
            selectors = comma == std::string_view::npos ? std::string_view() : selectors.substr(comma + 1);
            if (!known) {
                ++missed.selectors;
                continue;
            }
            rule.declarations = declarations;
            rule.number = ++count_;
            const Simple& last = rule.parts.back();
            const std::string key = !last.id.empty() ? "#" + last.id : !last.classes.empty() ? "." + last.classes[0] : last.tag;
            std::vector<Rule>& alike = rules_[key];
            if (alike.size() < kMostAlike)
                alike.push_back(std::move(rule));
            else
                ++missed.selectors;
        }
    }
}

void StyleSheet::know(const Element& root, Missed& missed) {
    know_styles(root, missed);
    // Stops may be coloured by classes.
    const auto colour = [&](const Element& stop) {
        Declarations all;
        for (const auto& [name, value] : stop.attributes) all.emplace_back(name, value);
        for (const Rule* rule : rules_for(stop, Style{}))
            all.insert(all.end(), rule->declarations.begin(), rule->declarations.end());
        const Declarations own = parse_declarations(stop.attribute("style"));
        all.insert(all.end(), own.begin(), own.end());
        return all;
    };
    for (const auto& [id, element] : gradient_elements_) {
        if (element->name == "filter") {
            if (blurs(*element)) gradients_["filter " + id] = {};
        } else if (const auto mean = mean_of_gradient(*element, gradient_elements_, colour)) {
            gradients_[id] = *mean;
        }
    }
    for (const auto& [id, number] : pattern_numbers(root)) gradients_[id] = {.pattern = number};
}

void StyleSheet::know_styles(const Element& element, Missed& missed) {
    if (element.name == "style") add(element.text, missed);
    if (element.name == "linearGradient" || element.name == "radialGradient" || element.name == "filter")
        gradient_elements_.emplace(element.attribute("id"), &element);
    for (const Element& child : element.children) know_styles(child, missed);
}

// Later and more particular wins.
std::vector<const StyleSheet::Rule*> StyleSheet::rules_for(const Element& element, const Style& parent) const {
    std::vector<const Rule*> fitting;
    if (rules_.empty()) return fitting;
    const auto look = [&](std::string_view key) {
        const auto found = rules_.find(key);
        if (found == rules_.end()) return;
        for (const Rule& rule : found->second)
            if (rule.fits(element, parent)) fitting.push_back(&rule);
    };
    look("");
    look(element.name);
    std::string_view classes = element.attribute("class");
    for (int count = 0; !classes.empty() && count < kMostClasses; ++count) {
        const auto length =
            static_cast<std::size_t>(std::find_if(classes.begin(), classes.end(), is_svg_blank) - classes.begin());
        if (length > 0) look("." + std::string(classes.substr(0, length)));
        classes.remove_prefix(std::min(length + 1, classes.size()));
    }
    if (const auto id = element.attribute("id"); !id.empty()) look("#" + std::string(id));
    std::sort(fitting.begin(), fitting.end(),
              [](const Rule* a, const Rule* b) { return a->rank != b->rank ? a->rank < b->rank : a->number < b->number; });
    return fitting;
}

Style StyleSheet::style_of(const Element& element, const Style& parent, Missed& missed) const {
    Style style = parent;
    style.of = &element;
    style.outer = parent.of == nullptr ? nullptr : &parent;
    const std::vector<const Rule*> rules = rules_for(element, parent);
    const Declarations own = parse_declarations(element.attribute("style"));
    // What currentColor is comes first, wherever it is told.
    const auto take_colour = [&](std::string_view name, std::string_view value) {
        if (name == "color") style.current = lightness_of(value).value_or(style.current);
    };
    const auto each = [&](const auto& take) {
        for (const auto& [name, value] : element.attributes) take(name, without_svg_blanks(value));
        for (const Rule* rule : rules)
            for (const auto& [name, value] : rule->declarations) take(name, std::string_view(value));
        for (const auto& [name, value] : own) take(name, std::string_view(value));
    };
    each(take_colour);
    each([&](std::string_view name, std::string_view value) { set_property(style, name, value, gradients_, missed); });
    return style;
}

}  // namespace tactics
