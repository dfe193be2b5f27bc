// SPDX-License-Identifier: Apache-2.0
#include "tactics/description/description_json.h"

#include "tactics/description/description.h"
#include "tactics/description/object_words.h"
#include "tactics/text/catalogue.h"

namespace tactics {

namespace {

std::string thing_json(const Thing& thing) {
    JsonObject json;
    json.add("kind", thing.area ? "area" : "line");
    json.add("what", thing.what.english());
    json.add("place", thing.place.english());
    if (!thing.relations.empty()) json.add("relations", thing.relations.english());
    json.add("left_mm", thing.box.left);
    json.add("top_mm", thing.box.top);
    json.add("width_mm", thing.box.width);
    json.add("height_mm", thing.box.height);
    json.add("length_mm", thing.length);
    return json.text();
}

}  // namespace

void add_description(JsonObject& json, std::span<const Page> pages) {
    const Page& page = pages.front();
    const Description description = describe(page);
    if (!description.title.empty()) json.add("title", description.title);
    json.add("page", description.sheet.english());
    json.add("page_width_mm", page.width);
    json.add("page_height_mm", page.height);
    if (!page.regions.empty()) json.add_raw("objects", json_array(objects_json(page)));
    std::vector<std::string> things, lines;
    for (const Thing& thing : description.things) things.push_back(thing_json(thing));
    json.add_raw("things", json_array(things));
    for (const Page& each : pages)
        for (std::string& line : lines_of(describe(each))) lines.push_back(std::move(line));
    json.add("lines_language", std::string(spoken_language(page.language)));
    json.add_raw("lines", json_text_array(lines));
}

}  // namespace tactics
