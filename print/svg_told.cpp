// SPDX-License-Identifier: Apache-2.0
#include "print/svg_told.h"

#include <array>
#include <charconv>
#include <initializer_list>

#include "print/xml.h"
#include "tactics/layout/own_layers.h"
#include "tactics/layout/own_marks.h"

namespace tactics {

namespace {

void append_rect(std::string& text, std::string_view name, const Rect& rect) {
    append_exact(text, name, {rect.left, rect.top, rect.width, rect.height});
}

void append_unless_empty(std::string& text, std::string_view name, std::string_view value) {
    if (!value.empty()) append_told(text, name, value);
}

std::string words_told(const PageWords& words, std::size_t number) {
    std::string text = "<g";
    append_told(text, marks::kWords, number);
    append_told(text, marks::kKind, name_of(words.kind));
    append_told(text, marks::kText, words.text);
    append_unless_empty(text, marks::kKey, words.key);
    if (words.kind == WordsKind::label) append_exact(text, marks::kAnchor, {words.at.x, words.at.y, words.across, words.down});
    if (words.within != 0) append_exact(text, marks::kWithin, {words.within});
    if (words.optional) append_told(text, marks::kOptional, "1");
    return text + "/>\n";
}

std::string name_told(const PageName& name, std::size_t number) {
    std::string text = "<g";
    append_told(text, marks::kName, number);
    append_told(text, marks::kText, name.text);
    append_unless_empty(text, marks::kKey, name.key);
    if (name.words >= 0) append_told(text, marks::kWords, static_cast<std::size_t>(name.words));
    append_exact(text, marks::kAt,
                 {name.thing.x, name.thing.y, name.place.left, name.place.top, name.place.width, name.place.height});
    return text + "/>\n";
}

std::string left_out_told(const Name& name, std::size_t number) {
    std::string text = "<g";
    append_told(text, marks::kLeftOut, number);
    append_told(text, marks::kText, name.text);
    append_unless_empty(text, marks::kOrigin, name.origin);
    append_exact(text, marks::kAt, {name.at.x, name.at.y});
    append_exact(text, marks::kWithin, {name.within});
    if (name.optional) append_told(text, marks::kOptional, "1");
    return text + "/>\n";
}

std::string undrawn_told(const Region& region, std::size_t number, std::string_view language) {
    std::string text = "<g" + region_told(region, number);
    append_told(text, marks::kText, region.name.in(language));
    append_unless_empty(text, marks::kPath, region.path);
    append_unless_empty(text, marks::kDescription, region.description.in(language));
    return text + "/>\n";
}

}  // namespace

void append_told(std::string& text, std::string_view name, std::string_view value) {
    text += ' ';
    text += name;
    text += "=\"" + escaped(value) + '"';
}

void append_told(std::string& text, std::string_view name, std::size_t number) {
    append_told(text, name, std::to_string(number));
}

void append_exact(std::string& text, std::string_view name, std::initializer_list<double> numbers) {
    text += ' ';
    text += name;
    text += '=';
    char before = '"';
    for (const double number : numbers) {
        std::array<char, 32> buffer;
        text += before;
        text.append(buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), number).ptr);
        before = ' ';
    }
    text += '"';
}

std::string page_told(const Page& page) {
    std::string text;
    append_told(text, marks::kVersion, marks::kThisVersion);
    append_exact(text, marks::kSize, {page.width, page.height});
    append_rect(text, marks::kLive, page.live);
    if (page.drawing.width > 0) append_rect(text, marks::kDrawing, page.drawing);
    append_unless_empty(text, marks::kMedium, page.medium);
    append_exact(text, marks::kCell, {page.cell.dot_pitch, page.cell.cell_pitch, page.cell.line_pitch, page.cell.dot});
    append_exact(text, marks::kDot, {page.braille_dot});
    if (page.bed)
        append_exact(text, marks::kBed,
                     {page.bed->first.x, page.bed->first.y, page.bed->raster, static_cast<double>(page.bed->dots_down)});
    append_unless_empty(text, marks::kTable, page.braille_table);
    append_told(text, marks::kLanguage, page.language);
    append_unless_empty(text, marks::kTitle, page.title);
    append_unless_empty(text, marks::kCaption, page.caption);
    append_unless_empty(text, marks::kDescription, page.description);
    if (!page.textured.empty()) append_told(text, marks::kTextured, mark_of(page.textured));
    if (page.is_key) append_told(text, marks::kIsKey, "1");
    if (page.scale) {
        const Rect& place = page.scale->place;
        append_exact(text, marks::kScale,
                     {page.scale->length, page.scale->real, place.left, place.top, place.width, place.height});
        append_told(text, marks::kText, page.scale->text);
    }
    return text;
}

std::string region_told(const Region& region, std::size_t number) {
    std::string text, counts;
    append_told(text, marks::kRegion, number);
    if (!region.rings.empty()) append_exact(text, marks::kAt, {region.at.x, region.at.y});
    for (const auto& [name, count] : region.counts) counts += (counts.empty() ? "" : " ") + name + "=" + std::to_string(count);
    append_unless_empty(text, marks::kCounts, counts);
    return text;
}

std::string rest_told(const Page& page) {
    std::string text;
    for (std::size_t i = 0; i < page.words.size(); ++i) text += words_told(page.words[i], i);
    for (std::size_t i = 0; i < page.names.size(); ++i) text += name_told(page.names[i], i);
    for (std::size_t i = 0; i < page.left_out.size(); ++i) text += left_out_told(page.left_out[i], i);
    for (std::size_t i = 0; i < page.regions.size(); ++i)
        if (page.regions[i].rings.empty()) text += undrawn_told(page.regions[i], i, page.language);
    for (const Phrase& remark : page.remarks) {
        text += "<g";
        append_told(text, marks::kRemark, remark.in(page.language));
        text += "/>\n";
    }
    return text.empty() ? text : "<g id=\"told\" style=\"display:none\">\n" + text + "</g>\n";
}

}  // namespace tactics
