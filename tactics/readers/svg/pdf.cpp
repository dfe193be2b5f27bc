// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/svg/pdf.h"

#include "tactics/error.h"
#include "tactics/readers/svg/xml.h"
#include "tactics/transport/child.h"
#include "tactics/units.h"

namespace tactics {

namespace {

// What a program of poppler-utils says of that file; `instead` is what a user could do without it.
std::string said_of(const std::string& path, std::vector<std::string> words, const std::string& instead) {
    // A name must not look like an option.
    words.insert(words.begin() + static_cast<std::ptrdiff_t>(words.size() - (words.back() == "-" ? 1 : 0)),
                 path.starts_with('-') ? "./" + path : path);
    const ChildAnswer answer = run_child(words, "", {std::chrono::seconds(60), kMostXmlBytes});
    using End = ChildAnswer::End;
    if (answer.end == End::missing)
        throw Error(Fault::failed, path,
                    "to look at a PDF the program " + words[0] + " is needed and missing; install poppler-utils, or " + instead);
    if (!answer.fault.empty())
        throw Error(Fault::failed, path, words[0] + " cannot be started: " + answer.fault + "; " + instead + " instead");
    if (answer.end == End::too_long || answer.end == End::too_much)
        throw Error(Fault::failed, path, "this PDF takes over a minute or 64 MB to be looked at; simplify its drawing");
    if (answer.end != End::done || answer.out.empty())
        throw Error(Fault::failed, path, words[0] + " cannot read this PDF; open it in a viewer to see what is wrong");
    return answer.out;
}

}  // namespace

// The second page, too, only to know that there is one. Without -noshrink and -nocenter it fits the page to a paper of
// whole points, 0.1 % smaller.
std::string pdf_as_svg(const std::string& path) {
    return said_of(path, {"pdftocairo", "-svg", "-noshrink", "-nocenter", "-l", "2", "-"}, "check the SVG");
}

std::string pdf_page_as_png(const std::string& path, int page) {
    const std::string number = std::to_string(page);
    return said_of(path, {"pdftocairo", "-png", "-r", "150", "-singlefile", "-f", number, "-l", number, "-"},
                   "convert a page of it to PNG");
}

int pages_of_pdf(const std::string& path) {
    const std::string text = said_of(path, {"pdfinfo"}, "convert a page of it to PNG");
    constexpr std::string_view kPages = "\nPages:";
    const auto at = text.find(kPages);
    const auto begin = text.find_first_not_of(' ', at == std::string::npos ? text.size() : at + kPages.size());
    const auto count = begin == std::string::npos
                           ? std::nullopt
                           : parse_number(std::string_view(text).substr(begin, text.find_first_of("\r\n", begin) - begin));
    if (!count || *count < 1)
        throw Error(Fault::failed, path, "pdfinfo tells no pages of it; open it in a viewer to see what is wrong");
    return static_cast<int>(*count);
}

}  // namespace tactics
