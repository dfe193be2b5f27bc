// SPDX-License-Identifier: Apache-2.0
#include "cli/sheet_values.h"

#include "tactics/error.h"
#include "tactics/units.h"

namespace tactics {

namespace {

// BCP 47 (RFC 5646): a language of 2 to 8 letters, then parts of 1 to 8 letters or digits. What they mean is not looked up.
bool is_language(std::string_view tag) {
    const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    std::size_t at = 0;
    for (bool first = true; at <= tag.size(); first = false) {
        const std::string_view part = tag.substr(at, tag.find('-', at) - at);
        if (part.size() < (first ? 2u : 1u) || part.size() > 8) return false;
        for (const char c : part)
            if (!is_letter(c) && (first || c < '0' || c > '9')) return false;
        at += part.size() + 1;
    }
    return true;
}

}  // namespace

std::string language_of(const std::string& text, std::string_view place) {
    if (!is_language(text))
        throw Error(Fault::usage, place,
                    phrase("it cannot be \"{0}\"; it is a language tag such as en, en-GB or de", text.substr(0, 80)));
    return text;
}

double margin_of(const std::string& text, std::string_view place) {
    const auto length = parse_length(text);
    if (!length || *length < 0)
        throw Error(Fault::usage, place,
                    phrase("it cannot be \"{0}\"; it is a length such as 12mm or 0.5in, at least 0 mm", text.substr(0, 80)));
    return *length;
}

Binding binding_of(const std::string& text, std::string_view place) {
    const auto equals = text.find('=');
    const std::string edge = text.substr(0, equals);
    const auto room = parse_length(equals == std::string::npos ? "" : text.substr(equals + 1));
    if ((edge != "left" && edge != "top" && edge != "right") || !room || *room < 0)
        throw Error(
            Fault::usage, place,
            phrase("it cannot be \"{0}\"; it is left, top or right with a length, such as left=15mm", text.substr(0, 80)));
    return Binding{edge == "left" ? Binding::Edge::left : edge == "top" ? Binding::Edge::top : Binding::Edge::right, *room};
}

Tiles tiles_value(const Given& given) {
    const std::string text = given.value("--tiles", "1x1");
    const auto is_count = [](char c) { return c >= '1' && c <= '9'; };
    if (text.size() != 3 || !is_count(text[0]) || text[1] != 'x' || !is_count(text[2]))
        throw Error(Fault::usage, "--tiles",
                    phrase("it cannot be \"{0}\"; it is columns x rows of sheets, such as 2x2, at most 9x9", text.substr(0, 80)));
    return {text[0] - '0', text[2] - '0'};
}

// Mm on the page for a mm in the world: "1:100", "1cm=1m".
double scale_value(const Given& given) {
    const std::string text = given.value("--scale");
    const auto colon = text.find(':'), equals = text.find('=');
    std::optional<double> page, world;
    if (colon != std::string::npos) {
        page = parse_number(text.substr(0, colon));
        world = parse_number(text.substr(colon + 1));
    } else if (equals != std::string::npos) {
        page = parse_length(text.substr(0, equals));
        world = parse_length(text.substr(equals + 1));
    }
    constexpr double kMost = 1e12;  // the earth fits on a page
    const double scale = page && world ? *page / *world : 0;
    if (!page || !world || !(*page > 0) || !(*world > 0) || !(scale > 1 / kMost && scale < kMost))
        throw Error(
            Fault::usage, "--scale",
            phrase(
                "it cannot be \"{0}\"; it is a ratio such as 1:100, or a length on the page and one in the world, such as 1cm=1m",
                text.substr(0, 80)));
    return scale;
}

}  // namespace tactics
