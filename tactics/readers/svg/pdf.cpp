// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/svg/pdf.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <vector>

#include "tactics/error.h"
#include "tactics/readers/xml.h"
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
        throw Error(Fault::failed, pdf.name,
                    "to look at a PDF the program " + program + " is needed and missing; install poppler-utils, or " + instead);
    if (!answer.fault.empty())
        throw Error(Fault::failed, pdf.name, program + " cannot be started: " + answer.fault + "; " + instead + " instead");
    if (answer.end == End::too_long || answer.end == End::too_much || answer.crashed)
        throw Error(Fault::failed, pdf.name,
                    "this PDF takes over a minute, 1 GiB of memory or 64 MB to be looked at; simplify its drawing");
    if (answer.end != End::done || answer.out.empty())
        throw Error(Fault::failed, pdf.name,
                    is_locked(pdf) ? "this PDF is locked with a password; take that off first, for example with qpdf"
                                   : program + " cannot read this PDF; open it in a viewer to see what is wrong");
    return answer.out;
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
    return pdf_text_of(said_of(pdf, {"pdftotext", "-bbox-layout", "-cropbox", "-f", number, "-l", number, kFile, "-"}, kInstead),
                       pdf.name);
}

std::optional<std::string> pdf_page_as_svg(const Source& pdf, int page, const PdfText& text) {
    constexpr std::string_view kPixels = "<image";  // also where cairo itself gave up lines
    const std::string number = std::to_string(page);
    // Two lines of head and a line for each picture.
    const std::string pictures = said_of(pdf, {"pdfimages", "-list", "-f", number, "-l", number, kFile}, kInstead);
    if (std::count(pictures.begin(), pictures.end(), '\n') > 2) return std::nullopt;
    const std::string svg =
        said_of(pdf, {"pdftocairo", "-svg", "-noshrink", "-nocenter", "-f", number, "-l", number, kFile, "-"}, kInstead);
    if (svg.find(kPixels) != std::string::npos) return std::nullopt;
    return with_words(svg, text);
}

std::string pdf_page_as_png(const Source& pdf, int page) {
    const std::string number = std::to_string(page);
    return said_of(pdf, {"pdftocairo", "-png", "-r", "150", "-singlefile", "-f", number, "-l", number, kFile, "-"}, kInstead);
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
                "pdfinfo tells no pages of it, or over a million; open it in a viewer to see what is wrong");
}

}  // namespace tactics
