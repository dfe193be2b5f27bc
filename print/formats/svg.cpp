// SPDX-License-Identifier: Apache-2.0
// Scalable Vector Graphics 1.1: the page in millimetres, in groups that can be found again in a drawing program.
#include <algorithm>

#include "print/base64.h"
#include "print/format.h"
#include "print/ink.h"
#include "print/one_bit_png.h"
#include "print/xml.h"
#include "tactics/description/description.h"
#include "tactics/geometry/dashed_line.h"
#include "tactics/layout/named_lines.h"
#include "tactics/text/catalogue.h"

namespace tactics {

namespace {

// Hundredths of a millimetre as millimetres, as short as can be: 1.5, .05, -3.
void append_steps(std::string& text, long steps) {
    if (steps < 0) {
        text += '-';
        steps = -steps;
    }
    const long rest = steps % 100;
    if (steps >= 100 || rest == 0) append_whole(text, steps / 100);
    if (rest == 0) return;
    text += '.';
    text += static_cast<char>('0' + rest / 10);
    if (rest % 10 != 0) text += static_cast<char>('0' + rest % 10);
}
void append_mm(std::string& text, double mm) { append_steps(text, to_steps(mm)); }

void append_attribute(std::string& text, const char* name, double mm) {
    text += std::string(" ") + name + "=\"";
    append_mm(text, mm);
    text += '"';
}

// Each point from the one before it, on the grid of whole steps: shorter, and no error adds up.
void append_path(std::string& text, const std::vector<Point>& points, bool closed) {
    long x = 0, y = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const long px = to_steps(points[i].x), py = to_steps(points[i].y);
        if (i > 1 && px == x && py == y) continue;  // but a line of no length stays, it is a dot
        if (i < 2) text += i == 0 ? "M" : "l";
        const long dx = px - x, dy = py - y;
        if (i > 1 && dx >= 0) text += ' ';
        append_steps(text, dx);
        if (dy >= 0) text += ' ';
        append_steps(text, dy);
        x = px;
        y = py;
    }
    if (closed) text += 'z';
}

// Unsmoothed, in the older and the newer word for it; who knows neither will smooth it.
std::string picture_group(const Bitmap& picture) {
    OneBitPng png(picture.width, picture.height, 0, 0);
    for (int y = 0; y < picture.height; ++y) png.add_row(picture.bits.data() + picture.row_bytes() * static_cast<std::size_t>(y));
    std::string text = "<image id=\"picture\"";
    append_attribute(text, "x", picture.place.left);
    append_attribute(text, "y", picture.place.top);
    append_attribute(text, "width", picture.place.width);
    append_attribute(text, "height", picture.place.height);
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

std::string areas_group(const Page& page, const Description& description) {
    std::string text = "<g id=\"areas\" fill-rule=\"evenodd\">\n";
    for (std::size_t i = 0; i < page.areas.size(); ++i) {
        std::string path = "<path" + role_class(page.areas[i].role) + " d=\"";
        for (const auto& ring : page.areas[i].rings) append_path(path, ring, true);
        append_thing(text, description, true, i, path + "\"/>\n");
    }
    // Nothing is seen of these: they say where the patterns among the lines are.
    for (std::size_t i = 0; i < page.textured.size(); ++i) {
        std::string path = "<path class=\"tactics-texture-";
        append_whole(path, page.textured[i].texture);
        path += "\" fill=\"none\" d=\"";
        for (const auto& ring : page.textured[i].rings) append_path(path, ring, true);
        append_thing(text, description, true, page.areas.size() + i, path + "\"/>\n");
    }
    return text + "</g>\n";
}

// Left open, for more of the same.
std::string stroke_start(const PageStroke& stroke) {
    std::string path = "<path" + role_class(stroke.role);
    append_attribute(path, "stroke-width", stroke.width);
    path += " d=\"";
    append_path(path, stroke.points, stroke.closed);
    return path;
}
std::string stroke_path(const PageStroke& stroke) { return stroke_start(stroke) + "\"/>\n"; }

std::string strokes_group(const Page& page, const Description& description) {
    std::string text = "<g id=\"lines\" fill=\"none\" stroke=\"#000\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n";
    for (std::size_t i = 0; i < page.strokes.size(); ++i) {
        const PageStroke& stroke = page.strokes[i];
        std::string path = stroke_start(stroke);
        // A pattern is thousands of marks, too short to have an element each.
        while (stroke.role == Role::pattern && i + 1 < page.strokes.size() && page.strokes[i + 1].role == Role::pattern &&
               page.strokes[i + 1].width == stroke.width) {
            ++i;
            append_path(path, page.strokes[i].points, page.strokes[i].closed);
        }
        path += "\"/>\n";
        // A thing that is a dashed line is all of its dashes.
        const std::size_t first = i;
        for (const std::size_t last = last_of_line(page, first); i < last; ++i) path += stroke_path(page.strokes[i + 1]);
        append_thing(text, description, false, first, path);
    }
    return text + "</g>\n";
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

std::string name_group(const PageName& name) {
    std::string text = "<g class=\"tactics-name";
    if (!name.key.empty()) text += " tactics-key-" + escaped(name.key);
    return text + "\" aria-label=\"" + escaped(name.text) + "\">\n";
}

std::string braille_group(const Page& page) {
    std::string text = "<g id=\"braille\" class=\"tactics-cell";
    for (const double size : {page.cell.dot_pitch, page.cell.cell_pitch, page.cell.line_pitch, page.cell.dot}) {
        text += '-';
        append_number(text, size, 4);
    }
    text += page.is_key ? " tactics-is-key\">\n" : "\">\n";
    const std::vector<const PageName*> names = names_of_lines(page);
    const PageName* open = nullptr;
    for (std::size_t i = 0; i < page.braille.size(); ++i) {
        const BrailleLine& line = page.braille[i];
        const PageName* name = names[i];
        if (name != open && open != nullptr) text += "</g>\n";
        if (name != open && name != nullptr) text += name_group(*name);
        open = name;
        text += "<g class=\"" + cells_class(line) + "\">\n";
        for (const Point& dot : dots_of(line, page.cell)) {
            text += "<circle";
            append_attribute(text, "cx", dot.x);
            append_attribute(text, "cy", dot.y);
            append_attribute(text, "r", page.braille_dot / 2);
            text += "/>\n";
        }
        text += "</g>\n";
    }
    return text + (open != nullptr ? "</g>\n</g>\n" : "</g>\n");
}

std::string print_group(const Page& page) {
    std::string text = "<g id=\"print\" font-family=\"DejaVu Sans, sans-serif\">\n";
    for (const PrintLine& line : page.print) {
        text += "<text";
        append_attribute(text, "x", line.baseline.x);
        append_attribute(text, "y", line.baseline.y);
        append_attribute(text, "font-size", line.size);
        text += ">" + escaped(line.text) + "</text>\n";
    }
    return text + "</g>\n";
}

// Over all that is drawn, so that a pointer or a touch tablet meets them first; of two that lie over each other the later one.
// Nothing of them is seen or printed. They are told, and reached by the keyboard, in their order.
std::string regions_group(const Page& page, const Description& description) {
    std::string text = "<g id=\"regions\" fill=\"none\" pointer-events=\"all\">\n";
    std::size_t number = 0;
    for (const Region& region : page.regions) {
        if (region.rings.empty()) continue;
        const std::string id = "region-" + std::to_string(++number);
        text +=
            "<path id=\"" + id + "\" class=\"tactics-region\" role=\"img\" tabindex=\"0\" aria-labelledby=\"" + id + "-title\"";
        if (!region.description.empty()) text += " aria-describedby=\"" + id + "-desc\"";
        if (!region.path.empty()) text += " data-path=\"" + escaped(region.path) + "\"";
        text += " d=\"";
        for (const auto& ring : region.rings) append_path(text, ring, true);
        text += "\"><title id=\"" + id + "-title\">" + escaped(region.name.in(page.language)) + "</title>";
        if (!region.description.empty())
            text += "<desc id=\"" + id + "-desc\" xml:lang=\"" + own_language(description) + "\">" +
                    escaped(region.description.in(page.language)) + "</desc>";
        text += "</path>\n";
    }
    return number > 0 ? text + "</g>\n" : "";
}

std::string encode(const Page& page, const Settings&) {
    const Description description = describe(page);
    std::string width, height;
    append_number(width, page.width, 4);
    append_number(height, page.height, 4);
    std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\"";
    if (page.picture) text += " xmlns:xlink=\"http://www.w3.org/1999/xlink\"";
    // Not the role "img": what is in one is hidden from screen readers (WAI-ARIA: children presentational), and the things
    // have titles. "graphics-document" would say it better, but EPUB allows only older roles.
    text += " version=\"1.1\" width=\"" + width + "mm\" height=\"" + height + "mm\" viewBox=\"0 0 " + width + " " + height +
            "\" xml:lang=\"" + escaped(page.language) +
            "\" role=\"document\" aria-labelledby=\"title\" aria-describedby=\"desc\">\n<title id=\"title\">" +
            escaped(page.title.empty() ? phrase("Tactile graphic").in(page.language) : page.title) +
            "</title>\n<desc id=\"desc\" xml:lang=\"" + escaped(alternative_language(page)) + "\">" +
            escaped(alternative_text(page, description)) + "</desc>\n";
    text += "<g id=\"drawing\">\n";
    if (page.picture) text += picture_group(*page.picture);
    if (!page.areas.empty() || !page.textured.empty()) text += areas_group(page, description);
    if (!page.strokes.empty()) text += strokes_group(page, description);
    text += "</g>\n";
    if (!page.braille.empty()) text += braille_group(page);
    if (!page.print.empty()) text += print_group(page);
    text += regions_group(page, description);
    return text + "</svg>\n";
}

}  // namespace

extern const Format svg_format;
const Format svg_format{
    .name = "svg",
    .summary = "scalable vector graphics in mm, to go on drawing",
    .extensions = "svg",
    .medium = "swell",
    .paper = "a4",
    .encode_page = encode,
};

}  // namespace tactics
