// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/svg/svg_fonts.h"

#include <algorithm>
#include <utility>

#include "tactics/readers/svg/data_uri.h"
#include "tactics/readers/svg/svg_numbers.h"
#include "tactics/readers/svg/svg_style.h"
#include "tactics/text/utf8.h"
#include "tactics/units.h"

namespace tactics {

namespace {

constexpr std::size_t kMostFontsOfFile = 64, kMostFontBytes = 8u << 20;
const LetterWidths kNoFont;

// "Name" or 'Name'.
std::string_view without_quotes(std::string_view name) {
    name = without_svg_blanks(name);
    const bool quoted = name.size() > 1 && (name.front() == '"' || name.front() == '\'') && name.back() == name.front();
    return quoted ? name.substr(1, name.size() - 2) : name;
}

std::string_view first_family(std::string_view families) { return without_quotes(families.substr(0, families.find(','))); }

double length_of(const Element& element, std::string_view name, double otherwise) {
    return parse_number(element.attribute(name)).value_or(otherwise);
}

// Of a font whose letters are elements.
LetterWidths widths_in(const Element& font) {
    double em = 1000;
    for (const Element& child : font.children)
        if (child.name == "font-face") em = length_of(child, "units-per-em", em);
    if (!(em > 0)) return {};
    std::map<char32_t, double> widths;
    const double otherwise = length_of(font, "horiz-adv-x", 0);
    for (const Element& child : font.children) {
        if (child.name != "glyph") continue;
        std::string_view rest = child.attribute("unicode");
        if (rest.empty()) continue;
        const char32_t code = take_letter(rest);
        if (rest.empty()) widths.emplace(code, length_of(child, "horiz-adv-x", otherwise) / em);
    }
    return [widths = std::move(widths)](char32_t code) {
        const auto found = widths.find(code);
        return found == widths.end() ? std::nullopt : std::optional(found->second);
    };
}

}  // namespace

void SvgFonts::know(const Element& element) {
    if (element.name == "style") know_sheet(element.text);
    if (element.name == "font" && fonts_.size() < kMostFontsOfFile)
        for (const Element& child : element.children)
            if (child.name == "font-face")
                fonts_.emplace(first_family(child.attribute("font-family")), Font{&element, {}, false, {}});
    for (const Element& child : element.children) know(child);
}

void SvgFonts::know_sheet(std::string_view sheet) {
    constexpr std::string_view kFace = "@font-face", kSource = "src:", kAddress = "url(";
    for (auto at = sheet.find(kFace); at != sheet.npos && fonts_.size() < kMostFontsOfFile; at = sheet.find(kFace, at + 1)) {
        const auto open = sheet.find('{', at), close = sheet.find('}', at);
        if (open == sheet.npos || close == sheet.npos || close < open) return;
        const std::string_view face = sheet.substr(open + 1, close - open - 1);
        std::string family;
        for (const auto& [name, value] : parse_declarations(face.substr(0, face.find(kSource))))
            if (name == "font-family") family = first_family(value);
        const auto source = face.find(kSource), begin = face.find(kAddress, std::min(source, face.size()));
        if (family.empty() || begin == face.npos) continue;
        const auto end = face.find(')', begin);
        if (end == face.npos) continue;
        const std::string_view address = without_quotes(face.substr(begin + kAddress.size(), end - begin - kAddress.size()));
        fonts_.emplace(std::move(family), Font{nullptr, address, false, {}});
    }
}

const LetterWidths& SvgFonts::widths_of(std::string_view families) {
    const auto found = fonts_.find(first_family(families));
    if (found == fonts_.end()) return kNoFont;
    Font& font = found->second;
    if (std::exchange(font.opened, true)) return font.widths;
    if (font.element != nullptr) {
        font.widths = widths_in(*font.element);
    } else if (open_ && font.address.size() <= kMostFontBytes) {
        if (auto bytes = bytes_of_data_uri(font.address)) font.widths = open_(std::string(bytes->begin(), bytes->end()));
    }
    return font.widths;
}

}  // namespace tactics
