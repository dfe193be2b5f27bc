// SPDX-License-Identifier: Apache-2.0
// JSON (RFC 8259): the page said in words and places, an object for each page, for programs that guide a hand over it.
#include "print/format.h"
#include "tactics/description/description_json.h"

namespace tactics {

namespace {

std::string encode_pages_json(std::span<const Page> pages, const Settings&) {
    std::vector<std::string> all;
    for (const Page& page : pages) {
        JsonObject json;
        if (!page.description.empty()) json.add("description", page.description);
        json.add("language", page.language);
        add_description(json, {&page, 1});
        all.push_back(json.text());
    }
    return "{\"pages\":" + json_array(all) + "}\n";
}

}  // namespace

extern const Format json_format;
const Format json_format{
    .name = "json",
    .summary = "what is on the page and where, as JSON for programs",
    .extensions = "json",
    .medium = "swell",
    .paper = "a4",
    .encode_pages = encode_pages_json,
};

}  // namespace tactics
