// Plain text (UTF-8): the page said in words, for who reads with a screen reader before or instead of with the hands.
#include "print/format.h"
#include "tactics/description.h"

namespace tactics {

namespace {

std::string encode(const Page& page, const Settings&) {
    std::string text;
    if (!page.description.empty()) text += page.description + "\n";
    for (const std::string& line : lines_of(describe(page))) text += line + "\n";
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
    .options = {},
    .encode = encode,
};

}  // namespace tactics
