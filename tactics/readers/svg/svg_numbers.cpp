// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/svg/svg_numbers.h"

#include <array>

#include "tactics/text/utf8.h"
#include "tactics/units.h"

namespace tactics {

namespace {

void take_separator(std::string_view& text) {
    bool comma = false;
    while (!text.empty() && (is_svg_blank(text[0]) || (text[0] == ',' && !comma))) {
        comma = comma || text[0] == ',';
        text.remove_prefix(1);
    }
}

// How many letters of the front are a number.
std::size_t number_length(std::string_view text) {
    std::size_t at = 0;
    const auto digits = [&] {
        const std::size_t from = at;
        while (at < text.size() && is_digit(text[at])) ++at;
        return at - from;
    };
    if (at < text.size() && (text[at] == '+' || text[at] == '-')) ++at;
    std::size_t count = digits();
    if (at < text.size() && text[at] == '.') {
        ++at;
        count += digits();
    }
    if (count == 0) return 0;
    const std::size_t mantissa = at;
    if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
        ++at;
        if (at < text.size() && (text[at] == '+' || text[at] == '-')) ++at;
        if (digits() == 0) return mantissa;  // "2em"
    }
    return at;
}

}  // namespace

std::string_view without_svg_blanks(std::string_view text) {
    while (!text.empty() && is_svg_blank(text.front())) text.remove_prefix(1);
    while (!text.empty() && is_svg_blank(text.back())) text.remove_suffix(1);
    return text;
}

std::optional<double> take_svg_number(std::string_view& text) {
    std::string_view rest = text;
    while (!rest.empty() && is_svg_blank(rest[0])) rest.remove_prefix(1);
    const std::size_t length = number_length(rest);
    if (length == 0) return std::nullopt;
    const auto value = parse_number(rest.substr(0, length));
    if (!value) return std::nullopt;  // 1e999
    rest.remove_prefix(length);
    take_separator(rest);
    text = rest;
    return value;
}

std::optional<bool> take_svg_flag(std::string_view& text) {
    while (!text.empty() && is_svg_blank(text[0])) text.remove_prefix(1);
    if (text.empty() || (text[0] != '0' && text[0] != '1')) return std::nullopt;
    const bool flag = text[0] == '1';
    text.remove_prefix(1);
    take_separator(text);
    return flag;
}

std::optional<double> parse_svg_length(std::string_view text, double whole) {
    struct Unit {
        std::string_view name;
        double px;
    };
    // CSS: 96 px to the inch. em and ex without a font: the usual 16 px.
    static constexpr std::array<Unit, 9> kUnits{{{"px", 1},
                                                 {"pt", 96.0 / 72},
                                                 {"pc", 16},
                                                 {"mm", 96 / kMmPerInch},
                                                 {"cm", 960 / kMmPerInch},
                                                 {"in", 96},
                                                 {"em", 16},
                                                 {"ex", 8},
                                                 {"Q", 24 / kMmPerInch}}};
    text = without_svg_blanks(text);
    const std::size_t length = number_length(text);
    if (length == 0) return std::nullopt;
    const auto value = parse_number(text.substr(0, length));
    const std::string_view unit = without_svg_blanks(text.substr(length));
    if (!value || unit.empty()) return value;
    if (unit == "%") return *value / 100 * whole;
    for (const Unit& known : kUnits)
        if (unit == known.name) return *value * known.px;
    return std::nullopt;
}

double parse_font_size(std::string_view text, double outer) {
    const std::string_view size = without_svg_blanks(text);
    if (size.ends_with("em") && !size.ends_with("rem"))
        if (const auto times = parse_number(size.substr(0, size.size() - 2)); times && *times >= 0) return *times * outer;
    return parse_svg_length(size, outer).value_or(outer);
}

}  // namespace tactics
