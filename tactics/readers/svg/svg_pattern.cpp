// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/svg/svg_pattern.h"

#include <cstddef>
#include <cstdint>
#include <set>
#include <vector>

namespace tactics {

namespace {

constexpr std::size_t kMostWritten = 4000;  // bytes of a pattern; what comes later tells none apart

std::string_view href_of(const Element& element) {
    const std::string_view name = element.attribute("href");
    return name.starts_with('#') ? name.substr(1) : std::string_view();
}

template <typename Visit>
void each_element(const Element& element, const Visit& visit) {
    visit(element);
    for (const Element& child : element.children) each_element(child, visit);
}

using Kept = std::map<std::string_view, const Element*>;

// All that it paints; a name is not painted, and a clip path of a pattern is its tile.
void write(const Element& element, const Kept& kept, bool follow, std::string& text) {
    text += '<' + element.name;
    for (const auto& [name, value] : element.attributes)
        if (name != "id" && name != "clip-path" && name != "href") text += ' ' + name + '=' + value;
    const auto found = follow ? kept.find(href_of(element)) : kept.end();
    if (found != kept.end()) write(*found->second, kept, false, text);
    for (const Element& child : element.children)
        if (text.size() < kMostWritten) write(child, kept, follow, text);
    text += '>';
}

}  // namespace

double pattern_number(std::string_view text) {
    std::uint32_t hash = 2166136261u;  // FNV-1a
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619u;
    return 1 + hash / 4294967296.0;
}

std::map<std::string, double, std::less<>> pattern_numbers(const Element& root) {
    std::vector<const Element*> patterns;
    std::set<std::string_view> wanted;
    each_element(root, [&](const Element& element) {
        if (element.name != "pattern") return;
        patterns.push_back(&element);
        each_element(element, [&](const Element& part) { wanted.insert(href_of(part)); });
    });
    wanted.erase("");
    Kept kept;
    if (!wanted.empty())
        each_element(root, [&](const Element& element) {
            if (const auto id = element.attribute("id"); wanted.contains(id)) kept.emplace(id, &element);
        });
    std::map<std::string, double, std::less<>> numbers;
    for (const Element* pattern : patterns) {
        std::string text;
        write(*pattern, kept, true, text);
        numbers.emplace(pattern->attribute("id"), pattern_number(text));
    }
    return numbers;
}

}  // namespace tactics
