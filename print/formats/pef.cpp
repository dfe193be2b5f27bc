// SPDX-License-Identifier: Apache-2.0
// PEF 2008-1 (Portable Embosser Format, DAISY): pages of Unicode braille in XML, which software for embossers reads.
//
// A row is four dots high, and rowgap counts dots below it. 6-dot cells leave their fourth row free, so with rowgap 0 lines stand
// 10 mm apart as Marburg Medium has them; 8-dot cells fill it, and drawings have no gaps between lines.
//
// graphic=image is an extension of the American Printing House (namespace .../tactile-graphics/1.0), which has no specification
// that can be had; it is as libembosser reads it (class DocumentParser) and BrailleBlaster writes it (class BBX2PEFConverter).
// Of a page, the lines with the drawing stand in a graphic of so many cells and lines, which names a picture behind the body by
// its id: PNG in base64, without a line break, which libembosser's decoder would refuse. A reader that embosses pictures
// (DocumentToPrintableHandler: ViewPlus by the print system) draws it as large as fits those cells and skips the rows; for one
// that takes text the rows of a graphic are rows as any. Sure of the elements, from these sources; not tried on a machine. PEF's
// own grammar has no place for either, so a reader that knows only PEF may miss the rows of a graphic: hence rows as it comes.
#include <zlib.h>

#include <algorithm>
#include <optional>

#include "print/base64.h"
#include "print/cell_rows.h"
#include "print/format.h"
#include "print/one_bit_png.h"
#include "print/sides.h"
#include "print/text_job.h"
#include "print/xml.h"

namespace tactics {

namespace {

constexpr Option kPefOptions[] = {
    {.name = "dots",
     .type = Option::Type::choice,
     .fallback = 0,
     .min = 0,
     .max = 1,
     .summary = "dots per cell: 8 if the embosser supports them",
     .choices = "6 8"},
    {.name = "graphic",
     .type = Option::Type::choice,
     .fallback = 0,
     .min = 0,
     .max = 1,
     .summary = "image: include the drawing also as a picture, for BrailleBlaster and ViewPlus (an extension in APH's programs, "
                "not in PEF 2008-1)",
     .choices = "rows image"},
    kSides,
};

DotSetting pef_dots(const Settings& settings) {
    return {kMarburgMedium, {{6.8, 6.8}, 0, settings.choice("dots") == "8" ? 4 : 3}};
}

// A document needs a unique identifier, and our files use neither clock nor randomness.
std::string identifier_of(std::string_view text) {
    const auto sum = crc32(0, reinterpret_cast<const Bytef*>(text.data()), static_cast<uInt>(text.size()));
    return "tactics-" + std::to_string(sum) + "-" + std::to_string(text.size());
}

// Lines of a page from the first that has something of the drawing to the last; nothing if none has.
struct Lines {
    std::size_t begin = 0, end = 0;
};

std::optional<Lines> lines_of_drawing(const Page& page) {
    Page bare = page;
    bare.braille.clear();
    const CellRows rows = cell_rows(bare);
    const std::size_t end = lines_used(rows);
    std::size_t begin = 0;
    while (begin < end && without_end(rows.line(begin)).empty()) ++begin;
    if (begin == end) return std::nullopt;
    return Lines{begin, end};
}

// All dots of these lines, round, in their places on the page: a row is four dots high, a cell as wide as set.
std::string picture_of(const CellRows& rows, Lines lines, const CellSize& cell) {
    constexpr int kPixels = 4;    // of a mm: whole ones from dot to dot and from cell to cell of Marburg Medium
    constexpr double kDot = 1.6;  // mm across
    constexpr int kReach = 3;     // pixels
    const auto pixels = [](double mm) { return static_cast<int>(mm * kPixels + 0.5); };
    const int pitch = pixels(cell.dot_pitch), across = pixels(cell.cell_pitch), down = 4 * pitch;
    const int width = across * static_cast<int>(rows.columns), height = down * static_cast<int>(lines.end - lines.begin);
    const std::size_t row_bytes = (static_cast<std::size_t>(width) + 7) / 8;
    std::vector<std::uint8_t> bits(row_bytes * static_cast<std::size_t>(height));
    const auto draw = [&](int x, int y) {  // the corner of four pixels is its centre
        for (int j = -kReach; j < kReach; ++j)
            for (int i = -kReach; i < kReach; ++i)
                if ((i + 0.5) * (i + 0.5) + (j + 0.5) * (j + 0.5) <= kDot * kPixels / 2 * (kDot * kPixels / 2))
                    bits[row_bytes * static_cast<std::size_t>(y + j) + static_cast<std::size_t>(x + i) / 8] |=
                        static_cast<std::uint8_t>(0x80u >> (static_cast<unsigned>(x + i) % 8));
    };
    for (std::size_t line = lines.begin; line < lines.end; ++line)
        for (std::size_t column = 0; column < rows.columns; ++column)
            for (int dot = 0; dot < 8; ++dot) {
                if ((rows.line(line)[column] >> dot & 1) == 0) continue;
                const int right = dot < 6 ? dot / 3 : dot - 6, below = dot < 6 ? dot % 3 : 3;
                draw(across * static_cast<int>(column) + (across - pitch) / 2 + pitch * right,
                     down * static_cast<int>(line - lines.begin) + pitch / 2 + pitch * below);
            }
    OneBitPng png(width, height, kPixels * 1000, kPixels * 1000);
    for (std::size_t y = 0; y < static_cast<std::size_t>(height); ++y) png.add_row(bits.data() + y * row_bytes);
    return png.finish();
}

std::string encode_pages_pef(std::span<const Page> pages, const Settings& settings) {
    const bool with_pictures = settings.choice("graphic") == "image";
    std::string body, images;
    int pictures = 0;
    std::size_t columns = 1, lines = 1;
    for (const Page& page : pages) {
        const CellRows rows = cell_rows(page);
        columns = std::max(columns, rows.columns);
        lines = std::max(lines, rows.lines);
        const std::optional<Lines> drawing = with_pictures ? lines_of_drawing(page) : std::nullopt;
        body += "        <page>\n";
        // Empty cells of the page's braille may have emptied the drawing's last line.
        const std::size_t end = std::max(lines_used(rows), drawing ? drawing->end : 0);
        for (std::size_t i = 0; i < end; ++i) {
            if (drawing && i == drawing->begin) {
                const std::string id = "drawing" + std::to_string(++pictures);
                body += "          <tg:graphic idref=\"" + id + "\" width=\"" + std::to_string(rows.columns) + "\" height=\"" +
                        std::to_string(drawing->end - drawing->begin) + "\">\n";
                images += "    <tg:imageData id=\"" + id + "\" format=\"image/png\" encoding=\"base64\">" +
                          to_base64(picture_of(rows, *drawing, page.cell)) + "</tg:imageData>\n";
            }
            const auto line = without_end(rows.line(i));
            std::string text;
            for (const std::uint8_t cell : line) text += unicode_letter(cell);
            body += text.empty() ? "          <row/>\n" : "          <row>" + text + "</row>\n";
            if (drawing && i + 1 == drawing->end) body += "          </tg:graphic>\n";
        }
        body += "        </page>\n";
    }
    const std::string extension = pictures > 0 ? " xmlns:tg=\"http://www.aph.org/ns/tactile-graphics/1.0\"" : "";
    if (pictures > 0) images = "  <tg:images>\n" + images + "  </tg:images>\n";
    const Page& first = pages.front();
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
           "<pef version=\"2008-1\" xmlns=\"http://www.daisy.org/ns/2008/pef\"" +
           extension +
           ">\n"
           "  <head>\n"
           "    <meta xmlns:dc=\"http://purl.org/dc/elements/1.1/\">\n"
           "      <dc:format>application/x-pef+xml</dc:format>\n"
           "      <dc:identifier>" +
           identifier_of(body) + "</dc:identifier>\n" +
           (first.title.empty() ? std::string() : "      <dc:title>" + escaped(first.title) + "</dc:title>\n") +
           "      <dc:language>" + escaped(first.language) +
           "</dc:language>\n"
           "    </meta>\n"
           "  </head>\n"
           "  <body>\n"
           "    <volume cols=\"" +
           std::to_string(columns) + "\" rows=\"" + std::to_string(lines) + "\" rowgap=\"0\" duplex=\"" +
           (on_both(settings) ? "true" : "false") +
           "\">\n"
           "      <section>\n" +
           body +
           "      </section>\n"
           "    </volume>\n"
           "  </body>\n" +
           images + "</pef>\n";
}

}  // namespace

extern const Format pef_format;
const Format pef_format{
    .name = "pef",
    .summary = "Portable Embosser Format, for software that drives embossers",
    .extensions = "pef",
    .medium = "embosser",
    .paper = "11x11.5",
    .options = kPefOptions,
    .encode_pages = encode_pages_pef,
    .dots = pef_dots,
};

}  // namespace tactics
