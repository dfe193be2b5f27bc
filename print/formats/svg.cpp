// SPDX-License-Identifier: Apache-2.0
// Scalable Vector Graphics 1.1: the page in millimetres, in layers that drawing programs show (Inkscape's), with curves as
// curves. It holds the page as it is, so that it can be read back (readers/svg/own_page.h).
#include <algorithm>
#include <set>

#include "print/base64.h"
#include "print/format.h"
#include "print/ink.h"
#include "print/one_bit_png.h"
#include "print/svg_lines.h"
#include "print/svg_told.h"
#include "print/xml.h"
#include "tactics/description/description.h"
#include "tactics/geometry/dashed_line.h"
#include "tactics/layout/named_lines.h"
#include "tactics/layout/own_layers.h"
#include "tactics/layout/own_marks.h"
#include "tactics/text/catalogue.h"

namespace tactics {

namespace {

// Unsmoothed, in the older and the newer word for it; who knows neither will smooth it.
std::string picture_group(const Bitmap& picture) {
    OneBitPng png(picture.width, picture.height, 0, 0);
    for (int y = 0; y < picture.height; ++y) png.add_row(picture.bits.data() + picture.row_bytes() * static_cast<std::size_t>(y));
    std::string text = "<image id=\"picture\"";
    append_attribute(text, "x", picture.place.left);
    append_attribute(text, "y", picture.place.top);
    append_attribute(text, "width", picture.place.width);
    append_attribute(text, "height", picture.place.height);
    append_exact(text, marks::kAt, {picture.place.left, picture.place.top, picture.place.width, picture.place.height});
    text += " preserveAspectRatio=\"none\" style=\"image-rendering:optimizeSpeed;image-rendering:pixelated\"";
    return text + " xlink:href=\"data:image/png;base64," + to_base64(png.finish()) + "\"/>\n";
}

// Of the words that are the program's and not a person's.
std::string own_language(const Description& description) { return escaped(std::string(spoken_language(description.language))); }

// The main things have a name of their own, so that they can be pointed at, told and found again.
void append_thing(std::string& text, const Description& description, bool area, std::size_t index, const std::string& path) {
    for (std::size_t i = 0; i < description.things.size(); ++i) {
        const Thing& thing = description.things[i];
        if (thing.area != area || thing.index != index) continue;
        const std::string number = std::to_string(i + 1);
        text += "<g id=\"thing-" + number + "\" role=\"img\" aria-labelledby=\"thing-" + number + "-title\"><title id=\"thing-" +
                number + "-title\" xml:lang=\"" + own_language(description) + "\">" + number + ". " +
                escaped(as_sentence(phrase("{0}, {1}", thing.what, thing.place).in(description.language))) + "</title>\n" + path +
                "</g>\n";
        return;
    }
    text += path;
}

std::string role_class(Role role) { return role == Role::line ? "" : " class=\"tactics-" + std::string(name_of(role)) + "\""; }

std::string number_of(std::size_t number) {
    std::string text;
    append_told(text, marks::kNumber, number);
    return text;
}

void append_areas(std::string& text, const Page& page, const Description& description, std::string_view layer) {
    for (std::size_t i = 0; i < page.areas.size(); ++i) {
        if (layer_of(page.areas[i]) != layer) continue;
        std::string path = "<path" + role_class(page.areas[i].role) + number_of(i) + " fill=\"#000\" stroke=\"none\" d=\"";
        for (const auto& ring : page.areas[i].rings) append_path(path, ring, true);
        append_thing(text, description, true, i, path + "\"/>\n");
    }
    if (layer != marks::kGround) return;
    // Nothing is seen of these: they say where the patterns among the lines are.
    for (std::size_t i = 0; i < page.textured.size(); ++i) {
        std::string path = "<path class=\"tactics-texture-";
        append_whole(path, page.textured[i].texture);
        path += '"' + number_of(i) + " fill=\"none\" stroke=\"none\" d=\"";
        for (const auto& ring : page.textured[i].rings) append_path(path, ring, true);
        append_thing(text, description, true, page.areas.size() + i, path + "\"/>\n");
    }
}

std::string stroke_start(const PageStroke& stroke, std::size_t number) {
    std::string path = "<path" + role_class(stroke.role) + number_of(number);
    append_attribute(path, "stroke-width", stroke.width);
    return path + " fill=\"none\" stroke=\"#000\"";
}

void append_strokes(std::string& text, const Page& page, const Description& description, std::string_view layer) {
    for (std::size_t i = 0; i < page.strokes.size(); ++i) {
        const PageStroke& stroke = page.strokes[i];
        if (layer_of(stroke, page) != layer) continue;
        std::string path = stroke_start(stroke, i);
        if (stroke.role == Role::pattern) {
            // Thousands of marks, too short to have an element each.
            path += " d=\"";
            append_path(path, stroke.points, stroke.closed);
            while (i + 1 < page.strokes.size() && page.strokes[i + 1].role == Role::pattern &&
                   page.strokes[i + 1].width == stroke.width) {
                ++i;
                append_path(path, page.strokes[i].points, page.strokes[i].closed);
            }
            text += path + "\"/>\n";
            continue;
        }
        path += course_attributes(stroke) + "/>\n";
        // A thing that is a dashed line is all of its dashes.
        const std::size_t first = i;
        for (const std::size_t last = last_of_line(page, first); i < last; ++i)
            path += stroke_start(page.strokes[i + 1], i + 1) + course_attributes(page.strokes[i + 1]) + "/>\n";
        append_thing(text, description, false, first, path);
    }
}

// Two digits a cell, so that who reads the file need not guess what its dots say: dots 1 to 8 are bits 0 to 7.
std::string cells_class(const BrailleLine& line) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string name = "tactics-cells-";
    for (const std::uint8_t cell : line.cells) {
        name += kDigits[cell >> 4];
        name += kDigits[cell & 15];
    }
    return name;
}

bool is_title(int words, const Page& page) {
    if (words < 0) return false;
    const WordsKind kind = page.words[static_cast<std::size_t>(words)].kind;
    return kind == WordsKind::title || kind == WordsKind::caption;
}

// What the lines of one text are called, and whose they are.
std::string braille_start(const PageName* name, int words, const Page& page) {
    std::string text = "<g";
    if (name != nullptr) {
        text += " class=\"tactics-name";
        if (!name->key.empty()) text += " tactics-key-" + escaped(name->key);
        text += '"';
    }
    const std::string said = name != nullptr ? name->text : words >= 0 ? page.words[static_cast<std::size_t>(words)].text : "";
    if (!said.empty()) text += " aria-label=\"" + escaped(said) + "\" inkscape:label=\"" + escaped(said) + '"';
    return text + ">\n";
}

void append_braille_svg(std::string& text, const Page& page, bool title) {
    const std::vector<const PageName*> names = names_of_lines(page);
    for (std::size_t i = 0; i < page.braille.size();) {
        const int words = page.braille[i].words;
        const PageName* name = names[i];
        if (is_title(words, page) != title) {
            ++i;
            continue;
        }
        text += braille_start(name, words, page);
        for (; i < page.braille.size() && page.braille[i].words == words && names[i] == name; ++i) {
            const BrailleLine& line = page.braille[i];
            text += "<g class=\"" + cells_class(line) + "\"" + number_of(i);
            if (words >= 0) append_told(text, marks::kWords, static_cast<std::size_t>(words));
            append_exact(text, marks::kAt, {line.first_dot.x, line.first_dot.y});
            text += ">\n";
            for (const Point& dot : dots_of(line, page.cell)) {
                text += "<circle";
                append_attribute(text, "cx", dot.x);
                append_attribute(text, "cy", dot.y);
                append_attribute(text, "r", page.braille_dot / 2);
                text += "/>\n";
            }
            text += "</g>\n";
            if (words < 0 && name == nullptr) {
                ++i;
                break;
            }
        }
        text += "</g>\n";
    }
}

std::string cell_class(const Page& page) {
    std::string text = " class=\"tactics-cell";
    for (const double size : {page.cell.dot_pitch, page.cell.cell_pitch, page.cell.line_pitch, page.cell.dot}) {
        text += '-';
        append_number(text, size, 4);
    }
    return text + (page.is_key ? " tactics-is-key\"" : "\"");
}

std::string text_element(int words, Point baseline, double size, std::string_view said, const std::string& more) {
    std::string text = "<text" + more;
    if (words >= 0) append_told(text, marks::kWords, static_cast<std::size_t>(words));
    append_told(text, marks::kText, said);
    append_exact(text, marks::kAt, {baseline.x, baseline.y, size});
    append_attribute(text, "x", baseline.x);
    append_attribute(text, "y", baseline.y);
    append_attribute(text, "font-size", size);
    return text + ">" + escaped(said) + "</text>\n";
}

void append_print_svg(std::string& text, const Page& page, bool title) {
    for (std::size_t i = 0; i < page.print.size(); ++i) {
        const PrintLine& line = page.print[i];
        if (is_title(line.words, page) == title)
            text += text_element(line.words, line.baseline, line.size, line.text, number_of(i));
    }
}

// What is in braille only, as texts that nobody sees before the layer is shown: there the words can be typed anew.
void append_unprinted(std::string& text, const Page& page) {
    constexpr double kSize = 3.53;  // mm, 10 pt
    std::set<int> said;
    for (const PrintLine& line : page.print) said.insert(line.words);
    std::string texts;
    for (const BrailleLine& line : page.braille) {
        if (line.words < 0 || !said.insert(line.words).second) continue;
        const PageWords& words = page.words[static_cast<std::size_t>(line.words)];
        if (words.kind == WordsKind::letters) {
            const bool listed = std::any_of(page.words.begin(), page.words.end(), [&](const PageWords& other) {
                return other.kind == WordsKind::key && other.key == words.key;
            });
            if (listed) continue;  // its words are in the key
        }
        texts += text_element(line.words, {line.first_dot.x, line.first_dot.y - page.braille_dot}, kSize, words.text, "");
    }
    // A key on pages of its own: its words stand at the letters.
    for (std::size_t i = 0; i < page.words.size(); ++i) {
        const PageWords& words = page.words[i];
        if (words.kind != WordsKind::key || said.count(static_cast<int>(i)) > 0) continue;
        for (const BrailleLine& line : page.braille) {
            if (line.words < 0) continue;
            const PageWords& letters = page.words[static_cast<std::size_t>(line.words)];
            if (letters.kind != WordsKind::letters || letters.key != words.key) continue;
            texts +=
                text_element(static_cast<int>(i), {line.first_dot.x, line.first_dot.y - page.braille_dot}, kSize, words.text, "");
            break;
        }
    }
    if (!texts.empty())
        text +=
            "<g id=\"words-of-braille\" inkscape:groupmode=\"layer\" inkscape:label=\"words of the braille\" "
            "style=\"display:none\">\n" +
            texts + "</g>\n";
}

std::string layer_group(const marks::PageLayer& layer, const Page& page, const Description& description) {
    std::string text;
    if (layer.name == marks::kGround && page.picture) text += picture_group(*page.picture);
    append_areas(text, page, description, layer.name);
    append_strokes(text, page, description, layer.name);
    const bool title = layer.name == marks::kTitleLayer, braille = title || layer.name == marks::kBraille,
               print = title || layer.name == marks::kWordsLayer;
    if (braille) append_braille_svg(text, page, title);
    if (print) append_print_svg(text, page, title);
    if (layer.name == marks::kWordsLayer) append_unprinted(text, page);
    std::string start = "<g id=\"layer-" + std::string(layer.name) + "\" inkscape:groupmode=\"layer\" inkscape:label=\"" +
                        std::string(layer.label) + '"';
    append_told(start, marks::kLayer, layer.name);
    if (braille && !page.braille.empty()) start += cell_class(page);
    if (print) start += " font-family=\"DejaVu Sans, sans-serif\"";
    // What a person draws in a layer of lines has a pen of its own.
    if (!braille) start += " fill-rule=\"evenodd\" stroke-linecap=\"round\" stroke-linejoin=\"round\"";
    return start + ">\n" + text + "</g>\n";
}

// Over all that is drawn, so that a pointer or a touch tablet meets them first; of two that lie over each other the later one.
// Nothing of them is seen or printed. They are told, and reached by the keyboard, in their order.
std::string regions_group(const Page& page, const Description& description) {
    std::string text = "<g id=\"regions\" fill=\"none\" pointer-events=\"all\">\n";
    std::size_t number = 0;
    for (std::size_t i = 0; i < page.regions.size(); ++i) {
        const Region& region = page.regions[i];
        if (region.rings.empty()) continue;
        const std::string id = "region-" + std::to_string(++number);
        text +=
            "<path id=\"" + id + "\" class=\"tactics-region\" role=\"img\" tabindex=\"0\" aria-labelledby=\"" + id + "-title\"";
        if (!region.description.empty()) text += " aria-describedby=\"" + id + "-desc\"";
        if (!region.path.empty()) text += " data-path=\"" + escaped(region.path) + "\"";
        text += region_told(region, i) + " d=\"";
        for (const auto& ring : region.rings) append_path(text, ring, true);
        text += "\"><title id=\"" + id + "-title\">" + escaped(region.name.in(page.language)) + "</title>";
        if (!region.description.empty())
            text += "<desc id=\"" + id + "-desc\" xml:lang=\"" + own_language(description) + "\">" +
                    escaped(region.description.in(page.language)) + "</desc>";
        text += "</path>\n";
    }
    return number > 0 ? text + "</g>\n" : "";
}

std::string encode_svg(const Page& page, const Settings&) {
    const Description description = describe(page);
    std::string width, height;
    append_number(width, page.width, 4);
    append_number(height, page.height, 4);
    std::string text =
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" "
        "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\"";
    if (page.picture) text += " xmlns:xlink=\"http://www.w3.org/1999/xlink\"";
    // Not the role "img": what is in one is hidden from screen readers (WAI-ARIA: children presentational), and the things
    // have titles. "graphics-document" would say it better, but EPUB allows only older roles.
    text += " version=\"1.1\" width=\"" + width + "mm\" height=\"" + height + "mm\" viewBox=\"0 0 " + width + " " + height +
            "\" xml:lang=\"" + escaped(page.language) + '"' + page_told(page) +
            " role=\"document\" aria-labelledby=\"title\" aria-describedby=\"desc\">\n<title id=\"title\"" +
            (page.title.empty() ? " xml:lang=\"" + own_language(description) + "\">" + phrase("Tactile graphic").in(page.language)
                                : ">" + escaped(page.title)) +
            "</title>\n<desc id=\"desc\" xml:lang=\"" + escaped(alternative_language(page)) + "\">" +
            escaped(alternative_text(page, description)) + "</desc>\n";
    for (const marks::PageLayer& layer : marks::kLayers) text += layer_group(layer, page, description);
    text += rest_told(page);
    text += regions_group(page, description);
    return text + "</svg>\n";
}

}  // namespace

extern const Format svg_format;
const Format svg_format{
    .name = "svg",
    .summary = "scalable vector graphics in mm, for further drawing",
    .extensions = "svg",
    .medium = "swell",
    .paper = "a4",
    .encode_page = encode_svg,
};

}  // namespace tactics
