// SPDX-License-Identifier: Apache-2.0
// Plain text (UTF-8): the page said in words, for who reads with a screen reader before or instead of with the hands.
#include "print/format.h"
#include "tactics/description/description.h"

namespace tactics {

namespace {

std::string said(const Page& page) {
    std::string text;
    if (!page.description.empty()) text += page.description + "\n";
    for (const std::string& line : lines_of(describe(page))) text += line + "\n";
    return text;
}

std::string encode_pages_text(std::span<const Page> pages, const Settings&) {
    std::string text;
    for (const Page& page : pages) text += (text.empty() ? "" : "\f") + said(page);
    return text;
}

}  // namespace

extern const Format text_format;
const Format text_format{
    .name = "text",
    .summary = "what is on the page and where, in plain words",
    .extensions = "txt",
    .medium = "swell",
    .paper = "a4",
    .encode_pages = encode_pages_text,
};

}  // namespace tactics
