// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/svg/pdf.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <vector>

#include "tactics/error.h"
#include "tactics/readers/svg/cairo_glyphs.h"
#include "tactics/readers/xml.h"
#include "tactics/text/number.h"
#include "tactics/text/utf8.h"
#include "tactics/text/words.h"
#include "tactics/transport/child.h"

namespace tactics {

namespace {

constexpr const char* kInstead = "convert a page of it to PNG";
constexpr const char* kFile = "/dev/fd/0";  // whatever it is called: no name looks like an option

// A person's own fonts: a PDF need not bring its letters.
std::vector<std::string> own_fonts() {
    const char* home = std::getenv("HOME");
    if (home == nullptr || *home != '/') return {};
    return {std::string(home) + "/.fonts", std::string(home) + "/.local/share/fonts"};
}

// Its trailer says so, which is at its end, or near its beginning.
bool is_locked(const Source& pdf) {
    constexpr std::string_view kMark = "/Encrypt";
    constexpr std::size_t kBlock = 1 << 16;
    std::string text;
    std::FILE* file = pdf.file.get();
    std::rewind(file);
    std::string block(kBlock, '\0');
    for (std::size_t count = 1; count > 0;) {
        count = std::fread(block.data(), 1, block.size(), file);
        text = text.substr(text.size() - std::min(text.size(), kMark.size())) + block.substr(0, count);
        if (text.find(kMark) != std::string::npos) return true;
    }
    return false;
}

// What a program of poppler-utils says of that file; `instead` is what a user could do without it.
std::string said_of(const Source& pdf, std::vector<std::string> words, const std::string& instead) {
    const std::string program = words[0];
    CagedChild child;
    child.words = std::move(words);
    child.file = fileno(pdf.file.get());
    child.limits = {std::chrono::seconds(60), kMostXmlBytes};
    child.readable = own_fonts();
    const ChildAnswer answer = run_caged(child);
    using End = ChildAnswer::End;
    if (answer.end == End::missing)
        throw Error(
            Fault::failed, pdf.name,
            phrase("to look at a PDF the program {0} is needed and missing; install poppler-utils, or {1}", program, instead));
    if (!answer.fault.empty())
        throw Error(Fault::failed, pdf.name, phrase("{0} cannot be started: {1}; {2} instead", program, answer.fault, instead));
    if (answer.end == End::too_long || answer.end == End::too_much || answer.crashed)
        throw Error(Fault::failed, pdf.name,
                    phrase("this PDF takes over a minute, 1 GiB of memory or 64 MB to be looked at; simplify its drawing"));
    if (answer.end != End::done || answer.out.empty())
        throw Error(Fault::failed, pdf.name,
                    is_locked(pdf) ? phrase("this PDF is locked with a password; take that off first, for example with qpdf")
                                   : phrase("{0} cannot read this PDF; open it in a viewer to see what is wrong", program));
    return answer.out;
}

// A range of pages whose answer is too large is asked for in halves; one page that is too large is a fault.
template <typename Answer, typename Ask>
std::vector<Answer> in_halves(int first, int last, const Ask& ask) {
    try {
        return ask(first, last);
    } catch (const Error&) {
        if (first >= last) throw;
    }
    const int middle = first + (last - first) / 2;
    std::vector<Answer> answers = in_halves<Answer>(first, middle, ask);
    const std::vector<Answer> more = in_halves<Answer>(middle + 1, last, ask);
    answers.insert(answers.end(), more.begin(), more.end());
    return answers;
}

// Each element of that name, whole.
std::vector<std::string_view> elements(std::string_view text, std::string_view begin, std::string_view end) {
    std::vector<std::string_view> found;
    for (auto at = text.find(begin); at != std::string_view::npos; at = text.find(begin, at)) {
        const auto close = text.find(end, at);
        const auto to = close == std::string_view::npos ? text.size() : close + end.size();
        found.push_back(text.substr(at, to - at));
        at = to;
    }
    return found;
}

constexpr std::string_view kPixels = "<image";  // more of them than the page has where cairo itself gave up lines

std::size_t count_of(std::string_view text, std::string_view part) {
    std::size_t count = 0;
    for (auto at = text.find(part); at != std::string_view::npos; at = text.find(part, at + part.size())) ++count;
    return count;
}

std::string svg_of_pages(const Source& pdf, int first, int last) {
    return said_of(
        pdf,
        {"pdftocairo", "-svg", "-noshrink", "-nocenter", "-f", std::to_string(first), "-l", std::to_string(last), kFile, "-"},
        kInstead);
}

bool is_drawn_on(const Source& pdf, int page) {
    const std::string svg = svg_of_pages(pdf, page, page);
    return svg.find(kPixels) != std::string::npos || drawn_in(svg) > 0;
}

}  // namespace

// The second page, too, only to know that there is one. Without -noshrink and -nocenter it fits the page to a paper of
// whole points, 0.1 % smaller.
std::string pdf_as_svg(const Source& pdf, int page) {
    const std::string first = std::to_string(std::max(1, page)), last = page > 0 ? first : "2";
    return said_of(pdf, {"pdftocairo", "-svg", "-noshrink", "-nocenter", "-f", first, "-l", last, kFile, "-"}, "check the SVG");
}

PdfText pdf_text(const Source& pdf, int page) {
    const std::string number = std::to_string(page);
    const auto told = [&](const std::vector<std::string>& how) {
        std::vector<std::string> command{"pdftotext", "-cropbox", "-f", number, "-l", number};
        command.insert(command.end(), how.begin(), how.end());
        command.insert(command.end(), {std::string(kFile), "-"});
        return said_of(pdf, command, kInstead);
    };
    PdfText text = pdf_text_of(told({"-bbox-layout"}), pdf.name);
    part_words(text, told({"-raw", "-bbox"}), pdf.name);
    return text;
}

std::optional<std::string> pdf_page_as_svg(const Source& pdf, int page, const PdfText& text) {
    const std::string number = std::to_string(page);
    const PdfPictures pictures = pictures_told(said_of(pdf, {"pdfimages", "-list", "-f", number, "-l", number, kFile}, kInstead));
    constexpr std::size_t kMost = 20;    // more are tiles of one
    constexpr double kMostOfPage = 0.6;  // more is a scan, or a page that was made pixels
    if (pictures.count > kMost || pictures.largest > kMostOfPage * text.width * text.height) return std::nullopt;
    const std::string svg = svg_of_pages(pdf, page, page);
    if (count_of(svg, kPixels) > pictures.listed) return std::nullopt;
    return with_words(svg, text);
}

std::vector<PdfText> pdf_texts(const Source& pdf, int first, int last) {
    constexpr std::string_view kSoft = "\u00AD</word>", kHyphen = "\u2010</word>";
    return in_halves<PdfText>(first, last, [&](int from, int to) {
        std::string told = said_of(
            pdf, {"pdftotext", "-bbox-layout", "-cropbox", "-f", std::to_string(from), "-l", std::to_string(to), kFile, "-"},
            kInstead);
        // A soft hyphen is seen where a line ends with it.
        for (auto at = told.find(kSoft); at != std::string::npos; at = told.find(kSoft, at))
            told.replace(at, kSoft.size(), kHyphen);
        const auto body = std::min(told.find("<doc>"), told.size());
        std::vector<PdfText> texts;
        for (const std::string_view page : elements(std::string_view(told).substr(body), "<page ", "</page>"))
            texts.push_back(pdf_text_of("<doc>" + std::string(page) + "</doc>", pdf.name));
        texts.resize(static_cast<std::size_t>(to - from + 1));
        return texts;
    });
}

std::vector<bool> pdf_pages_drawn(const Source& pdf, int first, int last) {
    constexpr std::string_view kUse = "<use xlink:href=\"#", kGlyph = "glyph";
    return in_halves<bool>(first, last, [&](int from, int to) {
        const std::string svg = svg_of_pages(pdf, from, to);
        const auto pages = elements(svg, "<page>", "</page>");
        std::vector<bool> drawn;
        for (int page = from; page <= to; ++page) {
            const auto at = static_cast<std::size_t>(page - from);
            const std::string_view own = at < pages.size() ? pages[at] : std::string_view();
            bool looked_at = at < pages.size();  // what a page uses besides letters stands before all pages
            for (auto use = own.find(kUse); use != own.npos; use = own.find(kUse, use + 1))
                looked_at = looked_at && own.substr(use + kUse.size()).starts_with(kGlyph);
            drawn.push_back(looked_at ? drawn_in(own) > 0 : is_drawn_on(pdf, page));
        }
        return drawn;
    });
}

std::string pdf_page_as_png(const Source& pdf, int page) {
    const std::string number = std::to_string(page);
    return said_of(pdf, {"pdftocairo", "-png", "-r", "150", "-singlefile", "-f", number, "-l", number, kFile, "-"}, kInstead);
}

// Columns between blanks: page num type width height color comp bpc enc interp object ID x-ppi y-ppi size ratio. Of a picture in
// the page's own stream the object is one word, so the last four are counted from the end.
PdfPictures pictures_told(std::string_view pdfimages) {
    PdfPictures told;
    for (std::size_t line = 0; !pdfimages.empty(); ++line) {
        const auto end = std::min(pdfimages.find('\n'), pdfimages.size());
        const std::vector<std::string_view> words = words_of(pdfimages.substr(0, end));
        pdfimages.remove_prefix(std::min(end + 1, pdfimages.size()));
        constexpr std::size_t kHead = 2, kFewest = 14;
        if (line < kHead || words.size() < kFewest) continue;
        ++told.listed;
        if (words[2] != "image" && words[2] != "stencil") continue;
        ++told.count;
        const auto number = [&](std::size_t column) { return parse_number(words[column]).value_or(0); };
        const double across = number(words.size() - 4), down = number(words.size() - 3);
        if (across > 0 && down > 0) told.largest = std::max(told.largest, number(3) / across * number(4) / down * 72 * 72);
    }
    return told;
}

// The words of the file's author come first, whatever lines they pretend to be. Behind the number of pages there are words of
// pdfinfo's own only, and the first of them is whether the file is encrypted.
std::optional<int> pages_told(std::string_view pdfinfo) {
    constexpr std::string_view kPages = "\nPages:", kNext = "\nEncrypted:";
    const auto at = pdfinfo.rfind(kPages);
    if (at == std::string_view::npos) return {};
    std::string_view number = pdfinfo.substr(at + kPages.size());
    number.remove_prefix(std::min(number.find_first_not_of(' '), number.size()));
    int pages = 0;
    const auto [end, fault] = std::from_chars(number.data(), number.data() + number.size(), pages);
    if (fault != std::errc() || pages < 1 || pages > kMostPdfPages) return {};
    return number.substr(static_cast<std::size_t>(end - number.data())).starts_with(kNext) ? std::optional(pages) : std::nullopt;
}

int pages_of_pdf(const Source& pdf) {
    const auto pages = pages_told(said_of(pdf, {"pdfinfo", kFile}, kInstead));
    if (pages) return *pages;
    throw Error(Fault::failed, pdf.name,
                phrase("pdfinfo tells no pages of it, or over a million; open it in a viewer to see what is wrong"));
}

}  // namespace tactics
