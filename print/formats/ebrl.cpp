// eBraille 1.0 (DAISY, 14 August 2025; all that is said here was read there): an EPUB 3 publication in a ZIP archive, with
// its text in Unicode braille. The page as a tactile graphic: an SVG that is shown and a PDF to print at its own size,
// with its description in braille, in plain text and in BRF for an embosser.
//
// PDF, text and BRF stand beside the publication as exempt resources (3.6): they need no fallback as nothing embeds them.
//
// Uncertain, as nothing here can check it: the names of braille systems, since their registry is a draft with none registered;
// and what is complete (5.3.3.3) of a picture whose lines were chosen, so it is said not to be.
#include <algorithm>
#include <array>
#include <cstdint>

#include "print/format.h"
#include "print/xml.h"
#include "print/zip_file.h"
#include "tactics/braille.h"
#include "tactics/description.h"
#include "tactics/units.h"
#include "tactics/utf8.h"

namespace tactics {

namespace {

// Copyright, publication and change must be dated (5.3.3), and a file of ours knows no clock: the year comes from the user.
// 1980 is the first that ZIP knows.
constexpr Option kOptions[] = {
    {"year", Option::Type::whole, 1980, 1000, 9999, "", "year of copyright and publication, which eBraille wants told", ""},
};

constexpr std::string_view kEnglish = "en-ueb-g2.ctb";

using Cells = std::vector<std::uint8_t>;

// The script subtag stands behind the language and before the region: en-GB is en-Brai-GB (5.3.3.8, BCP 47).
std::string braille_tag(std::string_view language) {
    const std::size_t end = std::min(language.find('-'), language.size());
    return std::string(language.substr(0, end)) + "-Brai" + std::string(language.substr(end));
}

// The spelling of the specification's own examples.
std::string system_of(std::string_view table) {
    if (table == "en-ueb-g1.ctb") return "UEB grade1";
    if (table == "en-ueb-g2.ctb") return "UEB grade2";
    return std::string(table.substr(0, table.rfind('.')));
}

std::string unicode_braille(const Cells& cells) {
    constexpr char32_t kBlankCell = 0x2800;  // the dots are its lowest bits (Unicode, Braille Patterns)
    std::string text;
    for (const std::uint8_t cell : cells) {
        if (cell == 0) text += ' ';  // where a line may end; U+2800 is none (6.2.1 has both)
        else append_letter(text, kBlankCell + cell);
    }
    return text;
}

// Everything that the package says in braille.
struct Words {
    std::string language;  // of the title and the package
    std::string title;
    Cells title_cells;
    std::vector<std::string> lines;  // of the description
    std::vector<Cells> line_cells;
    std::string lines_language;
    Cells note_cells;                      // in English
    std::vector<std::string_view> tables;  // the one of the title first
    bool eight_dots = false;
};

Words words_of(const Page& page) {
    Words words;
    words.language = page.language;
    // A book of braille is in braille even if the page is not to have any.
    const std::string_view own = page.braille_table.empty() ? kEnglish : std::string_view(page.braille_table);
    words.title = page.title.empty() ? "Tactile graphic" : page.title;
    words.title_cells = to_braille(words.title, own);
    // Our own words are English, whatever the title is in.
    const std::string_view english = own.starts_with("en") ? own : kEnglish;
    words.lines_language = alternative_language(page);
    if (page.description.empty()) {
        Description description = describe(page);
        description.title.clear();
        words.lines = lines_of(description);
        for (const std::string& line : words.lines) words.line_cells.push_back(to_braille(line, english, "the description"));
    } else {
        words.lines.push_back(page.description);
        words.line_cells.push_back(to_braille(page.description, own, "--describe"));
    }
    words.note_cells = to_braille("To print this page at its own size: drawing.pdf in the folder ebraille of this package.", english);
    words.tables.push_back(own);
    if (english != own) words.tables.push_back(english);
    const auto tall = [](const Cells& cells) {
        return std::any_of(cells.begin(), cells.end(), [](std::uint8_t cell) { return cell > 0x3F; });
    };
    words.eight_dots = tall(words.title_cells) || std::any_of(words.line_cells.begin(), words.line_cells.end(), tall);
    return words;
}

// Made of what is in the package, so that the same page has the same name and another page another: FNV-1a twice, as a UUID
// of version 8 (RFC 9562, 5.8).
std::string identifier(std::string_view bytes) {
    std::array<std::uint64_t, 2> hash{0xcbf29ce484222325u, 0x84222325cbf29ce4u};
    for (const char c : bytes)
        for (auto& half : hash) half = (half ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
    hash[0] = (hash[0] & ~std::uint64_t{0xF000}) | 0x8000;
    hash[1] = (hash[1] & ~(std::uint64_t{3} << 62)) | std::uint64_t{1} << 63;
    std::string text = "urn:uuid:";
    for (int digit = 0; digit < 32; ++digit) {
        if (digit == 8 || digit == 12 || digit == 16 || digit == 20) text += '-';
        text += "0123456789abcdef"[hash[static_cast<std::size_t>(digit / 16)] >> (60 - 4 * (digit % 16)) & 15];
    }
    return text;
}

std::string meta(const std::string& property, const std::string& value) {
    return "<meta property=\"" + property + "\">" + escaped(value) + "</meta>\n";
}

std::string package_document(const Words& words, const std::string& plain, const std::string& id, int year) {
    std::string digits = std::to_string(year);
    std::string text =
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<package xmlns=\"http://www.idpf.org/2007/opf\" version=\"3.0\" "
        "unique-identifier=\"uid\" xml:lang=\"" + escaped(words.lines_language) + "\">\n"
        "<metadata xmlns:dc=\"http://purl.org/dc/elements/1.1/\">\n"
        "<dc:identifier id=\"uid\">" + id + "</dc:identifier>\n"
        "<dc:title xml:lang=\"" + escaped(words.language) + "\">" + escaped(words.title) + "</dc:title>\n"
        "<dc:creator>Unknown</dc:creator>\n"
        "<dc:format>eBraille 1.0</dc:format>\n"
        "<dc:language>" + escaped(braille_tag(words.language)) + "</dc:language>\n";
    if (words.language != "en") text += "<dc:language>en-Brai</dc:language>\n";  // of the note at least
    text += "<dc:date>" + digits + "</dc:date>\n<dc:description>" + escaped(plain) + "</dc:description>\n";
    text += meta("dcterms:dateCopyrighted", digits) + meta("dcterms:modified", digits + "-01-01T00:00:00Z");
    text += meta("a11y:brailleCellType", words.eight_dots ? "8, 6" : "6");
    for (const std::string_view table : words.tables) text += meta("a11y:brailleSystem", system_of(table));
    text += meta("a11y:completeTranscription", "false") + meta("a11y:producer", "TACTICS") + meta("a11y:tactileGraphics", "SVG, PDF");
    text += meta("schema:accessMode", "tactile") + meta("schema:accessModeSufficient", "tactile");
    for (const char* feature : {"braille", "tactileGraphic", "alternativeText", "tableOfContents"})
        text += meta("schema:accessibilityFeature", feature);
    text += meta("schema:accessibilityHazard", "none") +
            meta("schema:accessibilitySummary", "One tactile graphic with its description in braille.");
    return text +
           "</metadata>\n<manifest>\n"
           "<item id=\"nav\" href=\"index.html\" media-type=\"application/xhtml+xml\" properties=\"nav\"/>\n"
           "<item id=\"page\" href=\"ebraille/page.html\" media-type=\"application/xhtml+xml\"/>\n"
           "<item id=\"drawing\" href=\"ebraille/drawing.svg\" media-type=\"image/svg+xml\"/>\n"
           "<item id=\"print\" href=\"ebraille/drawing.pdf\" media-type=\"application/pdf\"/>\n"
           "<item id=\"text\" href=\"ebraille/description.txt\" media-type=\"text/plain\"/>\n"
           "<item id=\"volume\" href=\"ebraille/description.brf\" media-type=\"text/plain\"/>\n"
           "</manifest>\n<spine>\n<itemref idref=\"page\"/>\n</spine>\n</package>\n";
}

std::string html_head(const Words& words, const std::string& more) {
    const std::string tag = escaped(braille_tag(words.language));
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!DOCTYPE html>\n<html xmlns=\"http://www.w3.org/1999/xhtml\" "
           "xmlns:epub=\"http://www.idpf.org/2007/ops\" xml:lang=\"" + tag + "\" lang=\"" + tag + "\">\n<head>\n<meta charset=\"utf-8\"/>\n"
           "<title>" + unicode_braille(words.title_cells) + "</title>\n" + more + "</head>\n<body>\n";
}

std::string navigation(const Words& words) {
    return html_head(words, "<link rel=\"publication\" href=\"package.opf\" type=\"application/oebps-package+xml\"/>\n") +
           "<nav epub:type=\"toc\" role=\"doc-toc\" aria-label=\"" + unicode_braille(words.title_cells) +
           "\">\n<ol style=\"list-style-type: none\">\n<li><a href=\"ebraille/page.html\">" + unicode_braille(words.title_cells) +
           "</a></li>\n</ol>\n</nav>\n</body>\n</html>\n";
}

// Text that is rendered is braille, alternative text too (6.2.1). The description stands below the drawing as text, so
// the drawing's own alternative text is its title, or it would be read twice.
std::string content_document(const Words& words) {
    const std::string tag = escaped(braille_tag(words.lines_language));
    std::string text = html_head(words, "") + "<section aria-labelledby=\"title\">\n<h1 id=\"title\">" +
                       unicode_braille(words.title_cells) + "</h1>\n<figure>\n<img src=\"drawing.svg\" alt=\"" +
                       unicode_braille(words.title_cells) + "\" aria-describedby=\"description\"/>\n</figure>\n<div id=\"description\" lang=\"" +
                       tag + "\" xml:lang=\"" + tag + "\">\n";
    for (const Cells& cells : words.line_cells) text += "<p>" + unicode_braille(cells) + "</p>\n";
    return text + "</div>\n<p lang=\"en-Brai\" xml:lang=\"en-Brai\">" + unicode_braille(words.note_cells) +
           "</p>\n</section>\n</body>\n</html>\n";
}

// Pages of 40 cells and 25 lines, which all braille embossers hold (11 x 11.5 in paper), in 6-dot cells. A paragraph begins
// in cell 3.
std::string braille_volume(const Words& words) {
    constexpr std::size_t kCells = 40, kLines = 25;
    std::string text;
    std::size_t lines = 0;
    const auto end_line = [&](const std::string& line) { text += line + (++lines % kLines == 0 ? "\r\n\f" : "\r\n"); };
    const auto add = [&](const Cells& cells, std::size_t indent) {
        std::string line(indent, ' ');
        std::size_t at = 0;
        while (at < cells.size()) {
            std::size_t end = at;
            while (end < cells.size() && cells[end] != 0) ++end;
            const bool fresh = line.find_first_not_of(' ') == std::string::npos;
            if (!fresh && line.size() + 1 + (end - at) > kCells) {
                end_line(line);
                line.clear();
            } else if (!fresh) {
                line += ' ';
            }
            for (; at < end; ++at) {
                if (line.size() == kCells) {
                    end_line(line);
                    line.clear();
                }
                line += brf_letter(cells[at]);
            }
            while (at < cells.size() && cells[at] == 0) ++at;
        }
        end_line(line);
    };
    add(words.title_cells, 4);
    for (const Cells& cells : words.line_cells) add(cells, 2);
    if (!text.ends_with('\f')) text += '\f';
    return text;
}

std::string encode(const Page& page, const Settings& settings) {
    const Words words = words_of(page);
    const auto in_format = [&](std::string_view name) {
        const Format& format = *find_format(name);
        return format.encode(page, Settings(format.options));
    };
    const std::string drawing = in_format("svg");
    std::string plain;
    for (const std::string& line : words.lines) plain += (plain.empty() ? "" : " ") + line;
    ZipFile zip;
    // First, as it is and without an extra field: it tells what the archive is at a fixed place (EPUB 3.3, 4.3.2).
    zip.add("mimetype", "application/epub+zip", ZipFile::Packing::stored);
    const auto add = [&](std::string_view name, const std::string& bytes) { zip.add(name, bytes, ZipFile::Packing::deflated); };
    add("META-INF/container.xml",
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<container version=\"1.0\" "
        "xmlns=\"urn:oasis:names:tc:opendocument:xmlns:container\">\n<rootfiles>\n"
        "<rootfile full-path=\"package.opf\" media-type=\"application/oebps-package+xml\"/>\n</rootfiles>\n</container>\n");
    add("package.opf", package_document(words, plain, identifier(drawing + plain), settings.whole("year")));
    add("index.html", navigation(words));
    add("ebraille/page.html", content_document(words));
    add("ebraille/drawing.svg", drawing);
    add("ebraille/drawing.pdf", in_format("pdf"));
    add("ebraille/description.txt", in_format("text"));
    add("ebraille/description.brf", braille_volume(words));
    return zip.finish();
}

}  // namespace

extern const Format ebrl_format;
const Format ebrl_format{
    .name = "ebrl",
    .summary = "eBraille package: the drawing, with its description in braille",
    .extensions = "ebrl",
    .medium = "swell",
    .paper = "a4",
    .options = kOptions,
    .encode = encode,
};

}  // namespace tactics
