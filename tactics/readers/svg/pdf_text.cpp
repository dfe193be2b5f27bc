// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/svg/pdf_text.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "tactics/error.h"
#include "tactics/readers/svg/cairo_glyphs.h"
#include "tactics/readers/xml.h"
#include "tactics/text/utf8.h"
#include "tactics/units.h"

namespace tactics {

namespace {

// In em. What a letter takes on average; a gap over which a line does not go on, as between the numbers of an axis; and one that
// is no space.
constexpr double kLetterWidth = 0.55, kPiece = 0.9, kSpace = 0.12;
// Shares of the size of a line: an exponent or an index is smaller, and off its base line.
constexpr double kSmall = 0.85, kOff = 0.1;

double number(std::string_view text) { return parse_number(text).value_or(0); }

Rect box_of(const Element& element) {
    const double left = number(element.attribute("xMin")), top = number(element.attribute("yMin"));
    return {left, top, number(element.attribute("xMax")) - left, number(element.attribute("yMax")) - top};
}

std::size_t letters_in(std::string_view text) {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

// Words one above the other run up or down; a single word does so if it is much higher than wide.
void find_direction(PdfLine& line) {
    const PdfWord &first = line.words.front(), &last = line.words.back();
    const double across = std::abs(last.box.left - first.box.left), down = last.box.top - first.box.top;
    if (line.words.size() > 1) {
        line.upwards = across < -down;
        line.downwards = across < down;
    } else {
        line.upwards = letters_in(first.text) > 1 && first.box.height > 1.5 * first.box.width;
    }
}

// Along its line, whichever way that runs.
struct Along {
    double from = 0, to = 0, high = 0;
};
Along along(const PdfLine& line, const PdfWord& word) {
    const Rect& box = word.box;
    if (line.upwards) return {-(box.top + box.height), -box.top, box.width};
    if (line.downwards) return {box.top, box.top + box.height, box.width};
    return {box.left, box.left + box.width, box.height};
}

// The size of letters, from their widths: boxes of fonts differ more than letters do.
double size_of(const PdfLine& line, std::size_t from, std::size_t to) {
    double width = 0, high = 0;
    std::size_t letters = 0;
    for (std::size_t i = from; i < to; ++i) {
        const Along at = along(line, line.words[i]);
        width += at.to - at.from;
        high = std::max(high, at.high);
        letters += letters_in(line.words[i].text);
    }
    return std::clamp(width / (kLetterWidth * static_cast<double>(std::max<std::size_t>(1, letters))), 0.45 * high, 0.9 * high);
}

std::string in_xml(std::string_view text) {
    std::string out;
    for (const char c : text) {
        if (c == '&')
            out += "&amp;";
        else if (c == '<')
            out += "&lt;";
        else
            out += c;
    }
    return out;
}

constexpr std::string_view kMinus = "\u2212";

bool begins_with_digit(std::string_view text) { return text[0] == '.' || (text[0] >= '0' && text[0] <= '9'); }

// The words from `from` to `to`, which go on without a gap, as an element of SVG.
std::string text_element(const PdfLine& line, std::size_t from, std::size_t to, CairoGlyphs& glyphs) {
    const double size = size_of(line, from, to);
    double high = 0, left = INFINITY, right = -INFINITY, top = INFINITY, bottom = -INFINITY;
    for (std::size_t i = from; i < to; ++i) {
        const Rect& box = line.words[i].box;
        high = std::max(high, along(line, line.words[i]).high);
        left = std::min(left, box.left);
        right = std::max(right, box.left + box.width);
        top = std::min(top, box.top);
        bottom = std::max(bottom, box.top + box.height);
    }
    std::string words;
    std::optional<double> base;
    double risen = 0;  // of the words now
    for (std::size_t i = from; i < to; ++i) {
        const PdfWord& word = line.words[i];
        const Along here = along(line, word);
        const auto stands = glyphs.take(word.box);
        const bool small = here.high < kSmall * high;
        if (!base && stands && !small) base = stands;
        double rise = 0;
        if (small && base && stands && !line.upwards && !line.downwards && std::abs(*base - *stands) > kOff * size)
            rise = *base - *stands;
        if (i > from && here.from - along(line, line.words[i - 1]).to > kSpace * size) words += ' ';
        const bool apart = rise != 0 || rise != risen;
        if (apart)
            words += "<tspan dy=\"" + to_text(risen - rise) + "\" font-size=\"" + to_text(rise == 0 ? size : 0.7 * size) + "\">";
        if (i == from && begins_with_digit(word.text) && !line.upwards && !line.downwards &&
            glyphs.take_minus(word.box, size, stands))
            words += kMinus;
        words += in_xml(word.text);
        if (apart) words += "</tspan>";
        risen = rise;
    }
    const double x = (left + right) / 2, y = (top + bottom) / 2, down = 0.36 * size;
    std::string element = "<text font-size=\"" + to_text(size) + "\" text-anchor=\"middle\" ";
    if (line.upwards || line.downwards)
        element += "transform=\"translate(" + to_text(x) + " " + to_text(y) + ") rotate(" + (line.upwards ? "-90" : "90") +
                   ")\" x=\"0\" y=\"" + to_text(down) + "\">";
    else
        element += "x=\"" + to_text(x) + "\" y=\"" + to_text(base && bottom - top < 1.5 * high ? *base : y + down) + "\">";
    return element + words + "</text>\n";
}

}  // namespace

std::size_t PdfText::count() const {
    std::size_t words = 0;
    for (const PdfBlock& block : blocks)
        for (const PdfLine& line : block.lines) words += line.words.size();
    return words;
}

PdfText pdf_text_of(std::string_view bbox_layout, const std::string& file) {
    // What stands before may be the author's, and is no XML.
    const auto from = bbox_layout.find("<doc>"), to = bbox_layout.rfind("</doc>");
    if (from == std::string_view::npos || to == std::string_view::npos || to < from)
        throw Error(Fault::failed, file, "pdftotext does not tell its words; open it in a viewer to see what is wrong");
    const Element root = parse_xml(bbox_layout.substr(from, to + 6 - from), file);
    PdfText text;
    if (root.children.empty()) return text;
    const Element& page = root.children.front();
    text.width = number(page.attribute("width"));
    text.height = number(page.attribute("height"));
    for (const Element& flow : page.children)
        for (const Element& block : flow.children) {
            PdfBlock& into = text.blocks.emplace_back();
            for (const Element& line : block.children) {
                PdfLine found;
                for (const Element& word : line.children)
                    if (!to_line(word.text).empty()) found.words.push_back({to_line(word.text), box_of(word)});
                if (found.words.empty()) continue;
                find_direction(found);
                into.lines.push_back(std::move(found));
            }
        }
    return text;
}

std::string with_words(std::string_view svg, const PdfText& text) {
    CairoGlyphs glyphs(svg);
    std::string texts;
    for (const PdfBlock& block : text.blocks)
        for (PdfLine line : block.lines) {
            std::erase_if(line.words, [&](const PdfWord& word) { return glyphs.are_slanted(word.box); });
            if (line.words.empty()) continue;
            const double size = size_of(line, 0, line.words.size());
            for (std::size_t from = 0, to = 1; from < line.words.size(); from = to, to = from + 1) {
                while (to < line.words.size() &&
                       std::abs(along(line, line.words[to]).from - along(line, line.words[to - 1]).to) < kPiece * size)
                    ++to;
                texts += text_element(line, from, to, glyphs);
            }
        }
    return glyphs.without_taken(texts);
}

}  // namespace tactics
