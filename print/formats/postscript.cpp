// SPDX-License-Identifier: Apache-2.0
// PostScript level 2 (Adobe, 2nd edition) with document structuring conventions 3.0: for printers that speak it.
#include <algorithm>
#include <array>
#include <cmath>

#include "print/fax.h"
#include "print/format.h"
#include "print/ink.h"
#include "tactics/text/utf8.h"
#include "tactics/units.h"

namespace tactics {

namespace {

// A PostScript string on one line; comments may have 255 characters, and only ASCII is sure to pass every spooler.
std::string quoted(std::string_view title) {
    std::string text = "(";
    while (!title.empty() && text.size() < 200) {
        const char32_t letter = take_letter(title);
        if (letter == '(' || letter == ')' || letter == '\\') text += '\\';
        text += letter >= 0x20 && letter < 0x7F ? static_cast<char>(letter) : '?';
    }
    return text + ")";
}

// Four bytes become five letters (PLRM 3.13, ASCII85Encode).
std::string to_ascii85(const std::string& bytes) {
    std::string text;
    text.reserve(bytes.size() * 13 / 10);
    std::size_t column = 0;
    const auto put = [&](char c) {
        text += c;
        if (++column % 75 == 0) text += '\n';
    };
    for (std::size_t at = 0; at < bytes.size(); at += 4) {
        const std::size_t count = std::min<std::size_t>(4, bytes.size() - at);
        std::uint32_t word = 0;
        for (std::size_t i = 0; i < 4; ++i) word = word << 8 | (i < count ? static_cast<unsigned char>(bytes[at + i]) : 0u);
        if (word == 0 && count == 4) {
            put('z');
            continue;
        }
        std::array<char, 5> digits{};
        for (std::size_t i = 5; i-- > 0; word /= 85) digits[i] = static_cast<char>('!' + word % 85);
        for (std::size_t i = 0; i <= count; ++i) put(digits[i]);
    }
    return text + "~>\n";
}

void append_picture_postscript(std::string& text, const Bitmap& picture) {
    const auto size = std::to_string(picture.width) + " " + std::to_string(picture.height);
    text += "gsave\n";
    append_whole(text, to_steps(picture.place.left));
    text += ' ';
    append_whole(text, to_steps(picture.place.top));
    text += " translate ";
    append_whole(text, to_steps(picture.place.width));
    text += ' ';
    append_whole(text, to_steps(picture.place.height));
    // Zeros are painted: black is 0 in what a fax decoder gives. The data follows "imagemask" and one blank.
    text += " scale\n" + size + " false [" + std::to_string(picture.width) + " 0 0 " + std::to_string(picture.height) +
            " 0 0] currentfile /ASCII85Decode filter\n<< /K -1 /Columns " + std::to_string(picture.width) + " /Rows " +
            std::to_string(picture.height) + " >> /CCITTFaxDecode filter imagemask\n";
    text += to_ascii85(group4_of(picture));
    text += "grestore\n";
}

// As outlines, so that no printer needs the font.
void append_print_postscript(std::string& text, const Page& page) {
    const auto letters = letters_of(page);
    for (const PrintLine& line : page.print) {
        text += "gsave\n";
        append_whole(text, to_steps(line.baseline.x));
        text += ' ';
        append_whole(text, to_steps(line.baseline.y));
        text += " translate ";
        append_number(text, line.size * kStepsPerMm / 1000, 6);
        text += " dup neg scale\n";
        for (std::string_view rest = line.text; !rest.empty();) {
            const auto found = letters.find(take_letter(rest));
            if (found == letters.end()) continue;
            const std::string outline = outline_of(found->second);
            if (!outline.empty()) text += outline + "f\n";
            append_whole(text, found->second.advance);
            text += " 0 translate\n";
        }
        text += "grestore\n";
    }
}

std::string encode_pages_postscript(std::span<const Page> all, const Settings&) {
    const Page& page = all.front();  // which speaks for the document
    std::string width, height;
    append_number(width, page.width / kMmPerPoint, 4);
    append_number(height, page.height / kMmPerPoint, 4);
    const std::string box = std::to_string(std::lround(std::ceil(page.width / kMmPerPoint - 1e-6))) + " " +
                            std::to_string(std::lround(std::ceil(page.height / kMmPerPoint - 1e-6)));
    std::string text = "%!PS-Adobe-3.0\n%%Creator: TACTICS\n";
    if (!page.title.empty()) text += "%%Title: " + quoted(page.title) + "\n";
    text += "%%LanguageLevel: 2\n%%DocumentData: Clean7Bit\n%%Pages: " + std::to_string(all.size()) + "\n%%BoundingBox: 0 0 " +
            box + "\n%%HiResBoundingBox: 0 0 " + width + " " + height + "\n%%DocumentMedia: Page " + width + " " + height +
            " 0 () ()\n%%EndComments\n"
            "%%BeginProlog\n"
            "/m {moveto} bind def /l {lineto} bind def /c {curveto} bind def /h {closepath} bind def\n"
            "/f {fill} bind def /f* {eofill} bind def /S {stroke} bind def\n"
            "/w {setlinewidth} bind def /J {setlinecap} bind def /j {setlinejoin} bind def\n"
            "%%EndProlog\n"
            "%%BeginSetup\n"
            "/setpagedevice where {pop << /PageSize [" +
            width + " " + height +
            "] >> setpagedevice} if\n"
            "%%EndSetup\n";
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Page& each = all[i];
        const std::string number = std::to_string(i + 1);
        text += "%%Page: " + number + " " + number + "\n%%PageMedia: Page\n%%PageBoundingBox: 0 0 " + box +
                "\n"
                "%%BeginPageSetup\n/saved save def 0 setgray [" +
                page_matrix(each) + "] concat\n%%EndPageSetup\n";
        if (each.picture) append_picture_postscript(text, *each.picture);
        text += ink_of(each);
        for (const BrailleLine& line : each.braille) text += ink_of(line, each);
        append_print_postscript(text, each);
        text += "saved restore showpage\n";
    }
    return text + "%%Trailer\n%%EOF\n";
}

}  // namespace

extern const Format postscript_format;
const Format postscript_format{
    .name = "ps",
    .summary = "PostScript level 2, for PostScript printers",
    .extensions = "ps",
    .medium = "swell",
    .paper = "a4",
    .encode_pages = encode_pages_postscript,
};

}  // namespace tactics
