// PEF 2008-1 (Portable Embosser Format, DAISY): pages of Unicode braille in XML, which software for embossers reads.
//
// A row is four dots high, and rowgap counts dots below it. 6-dot cells leave their fourth row free, so with rowgap 0 lines stand
// 10 mm apart as Marburg Medium has them; 8-dot cells fill it, and drawings have no gaps between lines.
#include <algorithm>

#include <zlib.h>

#include "print/cell_rows.h"
#include "print/format.h"
#include "print/text_job.h"
#include "print/xml.h"

namespace tactics {

namespace {

constexpr Option kOptions[] = {
    {.name = "dots", .type = Option::Type::choice, .fallback = 0, .min = 0, .max = 1, .unit = "", .summary = "dots of a cell: 8 if the embosser can",
     .choices = "6 8"},
};

DotSetting dots(const Settings& settings) { return {kMarburgMedium, {{6.8, 6.8}, 0, settings.choice("dots") == "8" ? 4 : 3}}; }

// A document must be told from others, and a file of ours knows neither clock nor chance.
std::string identifier_of(std::string_view text) {
    const auto sum = crc32(0, reinterpret_cast<const Bytef*>(text.data()), static_cast<uInt>(text.size()));
    return "tactics-" + std::to_string(sum) + "-" + std::to_string(text.size());
}

std::string encode_pages(std::span<const Page> pages, const Settings&) {
    std::string body;
    std::size_t columns = 1, lines = 1;
    for (const Page& page : pages) {
        const CellRows rows = cell_rows(page);
        columns = std::max(columns, rows.columns);
        lines = std::max(lines, rows.lines);
        body += "        <page>\n";
        for (std::size_t i = 0, end = lines_used(rows); i < end; ++i) {
            const auto line = without_end(rows.line(i));
            std::string text;
            for (const std::uint8_t cell : line) text += unicode_letter(cell);
            body += text.empty() ? "          <row/>\n" : "          <row>" + text + "</row>\n";
        }
        body += "        </page>\n";
    }
    const Page& first = pages.front();
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
           "<pef version=\"2008-1\" xmlns=\"http://www.daisy.org/ns/2008/pef\">\n"
           "  <head>\n"
           "    <meta xmlns:dc=\"http://purl.org/dc/elements/1.1/\">\n"
           "      <dc:format>application/x-pef+xml</dc:format>\n"
           "      <dc:identifier>" + identifier_of(body) + "</dc:identifier>\n" +
           (first.title.empty() ? std::string() : "      <dc:title>" + escaped(first.title) + "</dc:title>\n") +
           "      <dc:language>" + escaped(first.language) + "</dc:language>\n"
           "    </meta>\n"
           "  </head>\n"
           "  <body>\n"
           "    <volume cols=\"" + std::to_string(columns) + "\" rows=\"" + std::to_string(lines) + "\" rowgap=\"0\" duplex=\"false\">\n"
           "      <section>\n" + body +
           "      </section>\n"
           "    </volume>\n"
           "  </body>\n"
           "</pef>\n";
}

}  // namespace

extern const Format pef_format;
const Format pef_format{
    .name = "pef",
    .summary = "Portable Embosser Format, for software that drives embossers",
    .extensions = "pef",
    .medium = "embosser",
    .paper = "11x11.5",
    .options = kOptions,
    .encode_pages = encode_pages,
    .dots = dots,
};

}  // namespace tactics
