// SPDX-License-Identifier: Apache-2.0
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
#include <iterator>

#include "print/format.h"
#include "print/xml.h"
#include "print/zip_file.h"
#include "tactics/braille/braille.h"
#include "tactics/braille/tables.h"
#include "tactics/description/description.h"
#include "tactics/error.h"
#include "tactics/text/catalogue.h"
#include "tactics/text/utf8.h"
#include "tactics/text/words.h"
#include "tactics/units.h"

namespace tactics {

namespace {

// A package must name them (5.3.3.4, 5, 9, 10 and 11; the day of its last change EPUB 3.3, 5.5.4, too), and only the user knows
// them. Missing data are left out: no name or date is better than a wrong one under which libraries file the book.
constexpr Option kEbrlOptions[] = {
    {.name = "creator", .type = Option::Type::words, .summary = "author or artist of the work that is drawn"},
    {.name = "producer", .type = Option::Type::words, .summary = "person or institution that made the tactile edition"},
    {.name = "date",
     .type = Option::Type::date,
     .summary = "day of publication and last change; also the date of the files "
                "inside"},
    {.name = "copyright",
     .type = Option::Type::whole,
     .max = 9999,
     .summary = "copyright year of the work that is drawn; 0 leaves it out"},
};

std::string untold(const Settings& settings) {
    std::vector<std::string_view> parts, wishes;
    const auto ask = [&](std::string_view option, std::string_view part, std::string_view wish) {
        if (!settings.is_default(option)) return;
        parts.push_back(part);
        wishes.push_back(wish);
    };
    ask("creator", "the creator", "ebrl.creator=NAME");
    ask("producer", "the producer", "ebrl.producer=NAME");
    ask("date", "the day of publication", "ebrl.date=2026-03-31");
    ask("copyright", "the year of copyright", "ebrl.copyright=2026");
    if (parts.empty()) return "";
    const std::string set = " " + spelled("set") + " ";
    return "eBraille wants to be told " + joined(parts, ", ", " and ") + ", and the file leaves out what it was not told; add" +
           set + joined(wishes, set, set);
}

constexpr std::string_view kEnglish = "en-ueb-g2.ctb";

using Cells = std::vector<std::uint8_t>;

// The script subtag follows the language and precedes the region: en-GB becomes en-Brai-GB (5.3.3.8, BCP 47).
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
        if (cell == 0)
            text += ' ';  // where a line may end; U+2800 is none (6.2.1 has both)
        else
            append_letter(text, kBlankCell + cell);
    }
    return text;
}

// What is said of one page.
struct Section {
    Cells title_cells;
    std::vector<std::string> lines;  // of the description
    std::vector<Cells> line_cells;
    std::string number;  // suffix of the names of its files: none, "-2", "-3" ...
};

// Everything that the package says in braille.
struct Words {
    std::string language;  // of the title and the package
    std::string title;
    std::vector<Section> sections;
    std::string lines_language;
    std::string own_language;  // of what the package says besides
    Cells note_cells;
    std::vector<std::string> tables;  // the one of the title first
    bool eight_dots = false;
};

// The table for words in that language: the page's own if it is for it, and English where there is none.
std::string table_of(const std::string& language, std::string_view own) {
    if (own.starts_with(language)) return std::string(own);
    const std::string table = language == "en" ? "" : table_for_tag(language, described_tables());
    return table.empty() ? std::string(kEnglish) : table;
}

Words words_of(std::span<const Page> pages) {
    // The first that is no key speaks for the package.
    const auto drawn = std::find_if(pages.begin(), pages.end(), [](const Page& each) { return !each.is_key; });
    const Page& page = drawn != pages.end() ? *drawn : pages.front();
    Words words;
    words.language = page.language;
    // A book of braille is in braille even if the page is not to have any.
    const std::string_view own = page.braille_table.empty() ? kEnglish : std::string_view(page.braille_table);
    words.title = page.title.empty() ? phrase("Tactile graphic").in(page.language) : page.title;
    words.own_language = spoken_language(page.language);
    const std::string ours = table_of(words.own_language, own);
    words.lines_language = alternative_language(page);
    for (const Page& each : pages) {
        Section& section = words.sections.emplace_back();
        if (words.sections.size() > 1) section.number = "-" + std::to_string(words.sections.size());
        section.title_cells = to_braille(each.title.empty() ? words.title : each.title, own);
        if (each.description.empty()) {
            Description description = describe(each);
            description.title.clear();
            section.lines = lines_of(description);
            for (const std::string& line : section.lines) section.line_cells.push_back(to_braille(line, ours, "the description"));
        } else {
            section.lines.push_back(each.description);
            section.line_cells.push_back(to_braille(each.description, own, spelled("describe")));
        }
    }
    words.note_cells = to_braille(
        phrase("To print this page at its own size: drawing.pdf in the folder ebraille of this package.").in(page.language),
        ours);
    words.tables.emplace_back(own);
    if (ours != own) words.tables.push_back(ours);
    const auto tall = [](const Cells& cells) {
        return std::any_of(cells.begin(), cells.end(), [](std::uint8_t cell) { return cell > 0x3F; });
    };
    words.eight_dots = std::any_of(words.sections.begin(), words.sections.end(), [&](const Section& section) {
        return tall(section.title_cells) || std::any_of(section.line_cells.begin(), section.line_cells.end(), tall);
    });
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

std::string told_by_user(const Settings& told) {
    std::string text;
    const std::string &creator = told.words("creator"), &producer = told.words("producer"), &date = told.words("date");
    if (!creator.empty()) text += "<dc:creator>" + escaped(creator) + "</dc:creator>\n";
    if (!date.empty()) text += "<dc:date>" + date + "</dc:date>\n" + meta("dcterms:modified", date + "T00:00:00Z");
    if (const std::string year = std::to_string(told.whole("copyright")); year != "0")
        text += meta("dcterms:dateCopyrighted", std::string(4 - year.size(), '0') + year);
    if (!producer.empty()) text += meta("a11y:producer", producer);
    return text;
}

std::string package_document(const Words& words, const std::string& plain, const std::string& id, const Settings& told) {
    std::string text =
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<package xmlns=\"http://www.idpf.org/2007/opf\" version=\"3.0\" "
        "unique-identifier=\"uid\" xml:lang=\"" +
        escaped(words.lines_language) +
        "\">\n"
        "<metadata xmlns:dc=\"http://purl.org/dc/elements/1.1/\">\n"
        "<dc:identifier id=\"uid\">" +
        id +
        "</dc:identifier>\n"
        "<dc:title xml:lang=\"" +
        escaped(words.language) + "\">" + escaped(words.title) +
        "</dc:title>\n"
        "<dc:format>eBraille 1.0</dc:format>\n"
        "<dc:language>" +
        escaped(braille_tag(words.language)) + "</dc:language>\n";
    if (words.language != words.own_language)  // of the note at least
        text += "<dc:language>" + escaped(braille_tag(words.own_language)) + "</dc:language>\n";
    text += "<dc:description>" + escaped(plain) + "</dc:description>\n" + told_by_user(told);
    text += meta("a11y:brailleCellType", words.eight_dots ? "8, 6" : "6");
    for (const std::string& table : words.tables) text += meta("a11y:brailleSystem", system_of(table));
    text += meta("a11y:completeTranscription", "false") + meta("a11y:tactileGraphics", "SVG, PDF");
    text += meta("schema:accessMode", "tactile") + meta("schema:accessModeSufficient", "tactile");
    for (const char* feature : {"braille", "tactileGraphic", "alternativeText", "tableOfContents"})
        text += meta("schema:accessibilityFeature", feature);
    text += meta("schema:accessibilityHazard", "none") +
            meta("schema:accessibilitySummary",
                 (words.sections.size() > 1 ? phrase("Tactile graphics with their descriptions in braille.")
                                            : phrase("One tactile graphic with its description in braille."))
                     .in(words.own_language));
    std::string drawings;
    for (const Section& section : words.sections)
        drawings += "<item id=\"drawing" + section.number + "\" href=\"ebraille/drawing" + section.number +
                    ".svg\" media-type=\"image/svg+xml\"/>\n";
    return text +
           "</metadata>\n<manifest>\n"
           "<item id=\"nav\" href=\"index.html\" media-type=\"application/xhtml+xml\" properties=\"nav\"/>\n"
           "<item id=\"page\" href=\"ebraille/page.html\" media-type=\"application/xhtml+xml\"/>\n" +
           drawings +
           "<item id=\"print\" href=\"ebraille/drawing.pdf\" media-type=\"application/pdf\"/>\n"
           "<item id=\"text\" href=\"ebraille/description.txt\" media-type=\"text/plain\"/>\n"
           "<item id=\"volume\" href=\"ebraille/description.brf\" media-type=\"text/plain\"/>\n"
           "</manifest>\n<spine>\n<itemref idref=\"page\"/>\n</spine>\n</package>\n";
}

std::string html_head(const Words& words, const std::string& more) {
    const std::string tag = escaped(braille_tag(words.language));
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!DOCTYPE html>\n<html xmlns=\"http://www.w3.org/1999/xhtml\" "
           "xmlns:epub=\"http://www.idpf.org/2007/ops\" xml:lang=\"" +
           tag + "\" lang=\"" + tag +
           "\">\n<head>\n<meta charset=\"utf-8\"/>\n"
           "<title>" +
           unicode_braille(words.sections.front().title_cells) + "</title>\n" + more + "</head>\n<body>\n";
}

std::string navigation(const Words& words) {
    const std::string title = unicode_braille(words.sections.front().title_cells);
    return html_head(words, "<link rel=\"publication\" href=\"package.opf\" type=\"application/oebps-package+xml\"/>\n") +
           "<nav epub:type=\"toc\" role=\"doc-toc\" aria-label=\"" + title +
           "\">\n<ol style=\"list-style-type: none\">\n<li><a href=\"ebraille/page.html\">" + title +
           "</a></li>\n</ol>\n</nav>\n</body>\n</html>\n";
}

// Text that is rendered is braille, alternative text too (6.2.1). The description stands below the drawing as text, so
// the drawing's own alternative text is its title, or it would be read twice.
std::string content_document(const Words& words) {
    const std::string tag = escaped(braille_tag(words.lines_language));
    std::string text = html_head(words, "") + "<section aria-labelledby=\"title\">\n<h1 id=\"title\">" +
                       unicode_braille(words.sections.front().title_cells) + "</h1>\n";
    for (const Section& section : words.sections) {
        if (!section.number.empty()) text += "<h2>" + unicode_braille(section.title_cells) + "</h2>\n";
        text += "<figure>\n<img src=\"drawing" + section.number + ".svg\" alt=\"" + unicode_braille(section.title_cells) +
                "\" aria-describedby=\"description" + section.number + "\"/>\n</figure>\n<div id=\"description" + section.number +
                "\" lang=\"" + tag + "\" xml:lang=\"" + tag + "\">\n";
        for (const Cells& cells : section.line_cells) text += "<p>" + unicode_braille(cells) + "</p>\n";
        text += "</div>\n";
    }
    const std::string own_tag = escaped(braille_tag(words.own_language));
    return text + "<p lang=\"" + own_tag + "\" xml:lang=\"" + own_tag + "\">" + unicode_braille(words.note_cells) +
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
    for (const Section& section : words.sections) {
        add(section.title_cells, 4);
        for (const Cells& cells : section.line_cells) add(cells, 2);
    }
    if (!text.ends_with('\f')) text += '\f';
    return text;
}

std::string encode_pages_ebrl(std::span<const Page> pages, const Settings& settings) {
    // The back of a drawing that is left blank is no page of a book without sheets.
    if (pages.size() > 1 && std::any_of(pages.begin(), pages.end(), is_blank)) {
        std::vector<Page> kept;
        std::copy_if(pages.begin(), pages.end(), std::back_inserter(kept), [](const Page& page) { return !is_blank(page); });
        if (!kept.empty()) return encode_pages_ebrl(kept, settings);
    }
    const Words words = words_of(pages);
    const auto in_format = [&](std::string_view name) {
        const Format& format = *find_format(name);
        return files_of(format, pages, Settings(format.options));
    };
    const std::vector<std::string> drawings = in_format("svg");
    std::string plain, all;
    for (const Section& section : words.sections)
        for (const std::string& line : section.lines) plain += (plain.empty() ? "" : " ") + line;
    for (const std::string& drawing : drawings) all += drawing;
    const std::string& day = settings.words("date");
    ZipFile zip = day.empty() ? ZipFile() : ZipFile(day);
    // First, uncompressed and without an extra field: it identifies the archive at a fixed place (EPUB 3.3, 4.3.2).
    zip.add("mimetype", "application/epub+zip", ZipFile::Packing::stored);
    const auto add = [&](std::string_view name, const std::string& bytes) { zip.add(name, bytes, ZipFile::Packing::deflated); };
    add("META-INF/container.xml",
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<container version=\"1.0\" "
        "xmlns=\"urn:oasis:names:tc:opendocument:xmlns:container\">\n<rootfiles>\n"
        "<rootfile full-path=\"package.opf\" media-type=\"application/oebps-package+xml\"/>\n</rootfiles>\n</container>\n");
    add("package.opf", package_document(words, plain, identifier(all + plain), settings));
    add("index.html", navigation(words));
    add("ebraille/page.html", content_document(words));
    for (std::size_t i = 0; i < drawings.size(); ++i) add("ebraille/drawing" + words.sections[i].number + ".svg", drawings[i]);
    add("ebraille/drawing.pdf", in_format("pdf").front());
    add("ebraille/description.txt", in_format("text").front());
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
    .options = kEbrlOptions,
    .encode_pages = encode_pages_ebrl,
    .untold = untold,
};

}  // namespace tactics
