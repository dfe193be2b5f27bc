// SPDX-License-Identifier: Apache-2.0
// Portable Document Format 1.6 (ISO 32000-1): vectors, one bit for pictures, print as text with its letters embedded.
// Tagged (14.8), so that a screen reader finds the words: the title is a heading, other lines of print are paragraphs, the
// drawing is a Figure with its alternative text. A page with a title says that it keeps PDF/UA-1 (ISO 14289-1:2014), whose rules,
// as veraPDF has them in its profile, tests/print/pdf_ua_test.cpp checks; one without a title lacks what 7.1 wants, and says
// nothing.
//
// Each page carries its SVG (tactics/readers/own_pdf.h), so that it can be converted again as exactly as that.
//
// Written by hand: cairo took 40 ms for 500 strokes of 40 points where this takes a few, put the clock into the file and
// dates into it that checkers refuse.
#include <algorithm>
#include <memory>
#include <vector>

#include "print/fax.h"
#include "print/format.h"
#include "print/ink.h"
#include "print/page_book.h"
#include "print/pdf_file.h"
#include "print/xml.h"
#include "tactics/braille/braille.h"
#include "tactics/description/description.h"
#include "tactics/text/utf8.h"
#include "tactics/units.h"

namespace tactics {

extern const Format svg_format;

namespace {

// A BCP 47 tag is letters, digits and hyphens; nothing else goes into the file.
std::string language_tag(std::string_view tag) {
    std::string out;
    for (const char c : tag)
        if ((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-') out += c;
    return out;
}

std::string language_entry(std::string_view tag) {
    const std::string clean = language_tag(tag);
    return clean.empty() ? "" : "/Lang (" + clean + ") ";
}

// The structure elements of the pages, each with the one piece of content that bears its number on its page.
class Tags {
public:
    void begin_page() { pages_.emplace_back(); }
    /// Opens marked content; the caller closes it with EMC. `entries` are those of the element.
    void open(std::string& content, const std::string& type, const std::string& entries) {
        content += "/" + type + " << /MCID " + std::to_string(pages_.back().size()) + " >> BDC\n";
        pages_.back().push_back("/S /" + type + " " + entries);
    }
    /// Adds the tree below its root, which is the next object. The pages are objects from `sheet` on.
    int add_to(PdfFile& file, int sheet) const {
        const int root = file.next(), document = root + 1;
        int next = root + 2;
        std::string kids, numbers;
        for (std::size_t page = 0; page < pages_.size(); ++page) {
            std::string own;
            for (std::size_t i = 0; i < pages_[page].size(); ++i) own += " " + PdfFile::reference(next++);
            kids += own;
            numbers += (page > 0 ? " " : "") + std::to_string(page) + " [" + own + " ]";
        }
        file.add("<< /Type /StructTreeRoot /K " + PdfFile::reference(document) + " /ParentTree << /Nums [" + numbers +
                 "] >> /ParentTreeNextKey " + std::to_string(pages_.size()) + " >>");
        file.add("<< /Type /StructElem /S /Document /P " + PdfFile::reference(root) + " /K [" + kids + " ] >>");
        for (const auto& elements : pages_) {
            for (std::size_t i = 0; i < elements.size(); ++i)
                file.add("<< /Type /StructElem /P " + PdfFile::reference(document) + " /Pg " + PdfFile::reference(sheet) +
                         " /K " + std::to_string(i) + " " + elements[i] + ">>");
            ++sheet;
        }
        return root;
    }

private:
    std::vector<std::vector<std::string>> pages_;
};

// The page's letters as a font of drawn shapes (Type 3), with codes 1 to 255 in the order of the alphabet.
class PdfFont {
public:
    explicit PdfFont(const Page& page) : letters_(letters_of(page)) {
        constexpr unsigned kMostCodes = 255;
        for (const auto& [letter, shape] : letters_)
            if (codes_.size() < kMostCodes) codes_[letter] = static_cast<unsigned>(codes_.size() + 1);
    }
    bool empty() const { return codes_.empty(); }

    int add_to(PdfFile& file) const {
        std::string widths, names, shapes, unicode;
        unsigned in_block = 0;
        for (const auto& [letter, code] : codes_) {
            const Letter& shape = letters_.at(letter);
            // d0 and not d1: shapes of d1 may be kept as pixels by a viewer and set down up to a pixel off.
            const std::string outline = outline_of(shape);
            const int drawn =
                file.add_deflated(std::to_string(shape.advance) + " 0 d0\n" + outline + (outline.empty() ? "" : "f\n"));
            const std::string name = "/l" + std::to_string(code);
            widths += " " + std::to_string(shape.advance);
            names += " " + name;
            shapes += " " + name + " " + PdfFile::reference(drawn);
            // At most 100 entries to a block (Adobe technical note 5014).
            if (in_block == 0) unicode += std::to_string(std::min<std::size_t>(100, codes_.size() + 1 - code)) + " beginbfchar\n";
            unicode += '<';
            append_hex(unicode, code, 2);
            unicode += "> <";
            append_utf16(unicode, letter);
            unicode += ">\n";
            if (++in_block == 100 || code == codes_.size()) {
                unicode += "endbfchar\n";
                in_block = 0;
            }
        }
        const int meaning = file.add_deflated(
            "/CIDInit /ProcSet findresource begin\n12 dict begin\nbegincmap\n"
            "/CIDSystemInfo << /Registry (Adobe) /Ordering (UCS) /Supplement 0 >> def\n/CMapName /Adobe-Identity-UCS def\n"
            "/CMapType 2 def\n1 begincodespacerange\n<00> <FF>\nendcodespacerange\n" +
            unicode + "endcmap\nCMapName currentdict /CMap defineresource pop\nend\nend\n");
        return file.add(
            "<< /Type /Font /Subtype /Type3 /FontBBox [-1000 -1000 3000 2000] /FontMatrix [0.001 0 0 0.001 0 0]\n"
            "/FirstChar 1 /LastChar " +
            std::to_string(codes_.size()) + " /Widths [" + widths +
            " ]\n"
            "/Encoding << /Type /Encoding /Differences [1" +
            names + " ] >>\n/CharProcs <<" + shapes + " >> /Resources << >> /ToUnicode " + PdfFile::reference(meaning) + " >>");
    }

    void append_print(std::string& text, const Page& page, Tags& tags) const {
        text += "BT\n";
        for (const PrintLine& line : page.print) {
            tags.open(text, &line == &page.print.front() && line.text == page.title ? "H1" : "P", "");
            text += "/F ";
            append_whole(text, to_steps(line.size));
            text += " Tf 1 0 0 -1 ";
            append_whole(text, to_steps(line.baseline.x));
            text += ' ';
            append_whole(text, to_steps(line.baseline.y));
            text += " Tm <";
            for (std::string_view rest = line.text; !rest.empty();)
                if (const auto found = codes_.find(take_letter(rest)); found != codes_.end()) append_hex(text, found->second, 2);
            text += "> Tj\nEMC\n";
        }
        text += "ET\n";
    }

private:
    std::map<char32_t, Letter> letters_;
    std::map<char32_t, unsigned> codes_;
};

void append_picture_pdf(std::string& text, const Rect& place) {
    // A picture fills the unit square with its top at 1, and y runs down here.
    text += "q ";
    append_whole(text, to_steps(place.width));
    text += " 0 0 ";
    append_whole(text, -to_steps(place.height));
    text += ' ';
    append_whole(text, to_steps(place.left));
    text += ' ';
    append_whole(text, to_steps(place.top) + to_steps(place.height));
    text += " cm /P Do Q\n";
}

void append_points(std::string& text, double mm) {
    append_number(text, mm / kMmPerPoint, 4);
    text += ' ';
}

std::string figure_entries(const Page& page) {
    std::string entries = "/Alt " + text_string(alternative_text(page, describe(page))) + " " +
                          language_entry(alternative_language(page)) + "\n/A << /O /Layout /Placement /Block /BBox [";
    append_points(entries, page.live.left);
    append_points(entries, page.height - page.live.top - page.live.height);
    append_points(entries, page.live.left + page.live.width);
    append_points(entries, page.height - page.live.top);
    return entries + "] >> ";
}

std::size_t dotted(const std::vector<std::uint8_t>& cells) {
    return cells.size() - static_cast<std::size_t>(std::count(cells.begin(), cells.end(), 0));
}

// The title stands at the top of the braille, in as many lines as its cells need.
std::size_t title_lines(const Page& page) {
    if (page.title.empty() || page.braille.empty() || page.braille_table.empty()) return 0;
    const std::size_t all = dotted(to_braille(page.title, page.braille_table));
    std::size_t lines = 0;
    for (std::size_t cells = 0; cells < all && lines < page.braille.size(); ++lines) cells += dotted(page.braille[lines].cells);
    return lines;
}

// Braille that repeats the print is left out of the structure; otherwise it would be read twice. Without print it is included as
// braille, because nothing else on the page has its words.
void append_braille_pdf(std::string& content, const Page& page, Tags& tags) {
    const std::size_t headings = page.print.empty() ? title_lines(page) : 0;
    for (std::size_t i = 0; i < page.braille.size(); ++i) {
        const BrailleLine& line = page.braille[i];
        if (page.print.empty()) {
            std::string cells;
            constexpr char32_t kBlankCell = 0x2800;  // the dots are its lowest bits (Unicode, Braille Patterns)
            for (const std::uint8_t cell : line.cells) append_letter(cells, kBlankCell + cell);
            tags.open(content, i < headings ? "H1" : "P", "/ActualText " + text_string(cells) + " ");
        } else {
            content += "/Artifact BMC\n";
        }
        content += ink_of(line, page) + "EMC\n";
    }
}

// Writes the page's contents to the file and returns the entries of the page that point to them.
std::string add_content(const Page& page, PdfFile& file, Tags& tags) {
    tags.begin_page();
    const PdfFont font(page);
    std::string resources, content = page_matrix(page) + " cm\n";
    // The writing stands at the top and is read first.
    append_braille_pdf(content, page, tags);
    if (!font.empty()) {
        resources += "/Font << /F " + PdfFile::reference(font.add_to(file)) + " >> ";
        font.append_print(content, page, tags);
    }
    tags.open(content, "Figure", figure_entries(page));
    if (page.picture) {
        const Bitmap& picture = *page.picture;
        const std::string columns = std::to_string(picture.width), rows = std::to_string(picture.height);
        const int image = file.add_stream("/Type /XObject /Subtype /Image /ImageMask true /BitsPerComponent 1 /Width " + columns +
                                              " /Height " + rows + " /Filter /CCITTFaxDecode /DecodeParms << /K -1 /Columns " +
                                              columns + " /Rows " + rows + " >>\n",
                                          group4_of(picture));
        resources += "/XObject << /P " + PdfFile::reference(image) + " >> ";
        append_picture_pdf(content, picture.place);
    }
    content += ink_of(page) + "EMC\n";
    const int drawn = file.add_deflated(content);
    std::string box = "[0 0 ";
    append_number(box, page.width / kMmPerPoint, 4);
    box += ' ';
    append_number(box, page.height / kMmPerPoint, 4);
    const int own = file.add_own_page(svg_format.encode_page(page, Settings(svg_format.options)));
    return "/MediaBox " + box + "] /Contents " + PdfFile::reference(drawn) + " /Resources << " + resources + ">> /AF [" +
           PdfFile::reference(own) + "]";
}

// Metadata for cataloguing and checking programs (ISO 16684-1), in the language of xml:lang or of the file.
std::string described_by(const Page& page) {
    const std::string language = language_tag(page.language), other = language_tag(alternative_language(page));
    const auto alternative = [](const std::string& name, const std::string& tag, const std::string& text) {
        return "<dc:" + name + "><rdf:Alt><rdf:li xml:lang=\"" + tag + "\">" + escaped(text) + "</rdf:li></rdf:Alt></dc:" + name +
               ">\n";
    };
    std::string text =
        "<?xpacket begin=\"\xEF\xBB\xBF\" id=\"W5M0MpCehiHzreSzNTczkc9d\"?>\n<x:xmpmeta xmlns:x=\"adobe:ns:meta/\">\n"
        "<rdf:RDF xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\">\n<rdf:Description rdf:about=\"\" "
        "xmlns:dc=\"http://purl.org/dc/elements/1.1/\" xmlns:pdf=\"http://ns.adobe.com/pdf/1.3/\" "
        "xmlns:pdfuaid=\"http://www.aiim.org/pdfua/ns/id/\">\n<dc:format>application/pdf</dc:format>\n";
    if (!page.title.empty()) text += alternative("title", "x-default", page.title);
    text += alternative("description", other == language || other.empty() ? "x-default" : other,
                        alternative_text(page, describe(page)));
    if (!language.empty()) text += "<dc:language><rdf:Bag><rdf:li>" + language + "</rdf:li></rdf:Bag></dc:language>\n";
    text += "<pdf:Producer>TACTICS</pdf:Producer>\n";
    if (!page.title.empty() && !language.empty()) text += "<pdfuaid:part>1</pdfuaid:part>\n";
    return text + "</rdf:Description>\n</rdf:RDF>\n</x:xmpmeta>\n<?xpacket end=\"r\"?>";
}

// What stands in the outline, and which page it opens.
struct OutlineEntry {
    std::string name;
    std::size_t page = 0;
};

// Adds the outline, whose root is the next object. The pages are objects from `sheet` on.
int add_outline(PdfFile& file, const std::vector<OutlineEntry>& entries, int sheet) {
    const int root = file.next(), first = root + 1, last = root + static_cast<int>(entries.size());
    file.add("<< /Type /Outlines /First " + PdfFile::reference(first) + " /Last " + PdfFile::reference(last) + " /Count " +
             std::to_string(entries.size()) + " >>");
    for (const OutlineEntry& entry : entries) {
        const int own = file.next();
        file.add("<< /Title " + text_string(entry.name) + " /Parent " + PdfFile::reference(root) +
                 (own > first ? " /Prev " + PdfFile::reference(own - 1) : "") +
                 (own < last ? " /Next " + PdfFile::reference(own + 1) : "") + " /Dest [" +
                 PdfFile::reference(sheet + static_cast<int>(entry.page)) + " /Fit] >>");
    }
    return root;
}

// The pages in order of arrival, then the objects that describe them.
class PdfPages : public PageBook {
public:
    void add(std::span<const Page> pages, const std::string& name) override {
        if (!name.empty()) outline_.push_back({name, entries_.size()});
        add_pages(pages);
    }

    // For programs that catalogue and check files: of many pictures nothing but the title describes all.
    std::string finish(const std::string& title) override {
        Page whole;
        whole.title = title;
        whole.language = language_;
        whole.description = title;
        return finish_as(whole);
    }

    void add_pages(std::span<const Page> pages) {
        if (entries_.empty()) language_ = pages.front().language;
        for (const Page& page : pages) entries_.push_back(add_content(page, file_, tags_));
    }

    // `page` speaks for the document.
    std::string finish_as(const Page& page) {
        const int sheet = file_.next(), pages = sheet + static_cast<int>(entries_.size());
        std::string kids;
        for (std::size_t i = 0; i < entries_.size(); ++i)
            kids += (i > 0 ? " " : "") +
                    PdfFile::reference(file_.add("<< /Type /Page /Parent " + PdfFile::reference(pages) + " " + entries_[i] +
                                                 " /StructParents " + std::to_string(i) + " /Tabs /S >>"));
        file_.add("<< /Type /Pages /Count " + std::to_string(entries_.size()) + " /Kids [" + kids + "] >>");
        const int tree = tags_.add_to(file_, sheet);
        const int metadata = file_.add_stream("/Type /Metadata /Subtype /XML ", described_by(page));
        const std::string outline = outline_.empty() ? ""
                                                     : " /Outlines " + PdfFile::reference(add_outline(file_, outline_, sheet)) +
                                                           " /PageMode /UseOutlines";
        // A page shrunk to fit would have lines too thin to swell, so viewers are asked to print it unscaled.
        const int root = file_.add(
            "<< /Type /Catalog /Pages " + PdfFile::reference(pages) + " " + language_entry(page.language) + "/Metadata " +
            PdfFile::reference(metadata) + " /MarkInfo << /Marked true >> /StructTreeRoot " + PdfFile::reference(tree) + outline +
            " /ViewerPreferences << /PrintScaling /None" + (page.title.empty() ? "" : " /DisplayDocTitle true") + " >> >>");
        const std::string title = page.title.empty() ? "" : "/Title " + text_string(page.title) + " ";
        const int info = file_.add("<< " + title + "/Producer (TACTICS) >>");
        return file_.finish(root, info);
    }

private:
    PdfFile file_;
    Tags tags_;
    std::vector<std::string> entries_;
    std::vector<OutlineEntry> outline_;
    std::string language_;
};

std::string encode_pages_pdf(std::span<const Page> all, const Settings&) {
    PdfPages file;
    file.add_pages(all);
    return file.finish_as(all.front());
}

std::unique_ptr<PageBook> open_book() { return std::make_unique<PdfPages>(); }

}  // namespace

extern const Format pdf_format;
const Format pdf_format{
    .name = "pdf",
    .summary = "Portable Document Format, for any printer",
    .extensions = "pdf",
    .medium = "swell",
    .paper = "a4",
    .encode_pages = encode_pages_pdf,
    .open_book = open_book,
};

}  // namespace tactics
