// SPDX-License-Identifier: Apache-2.0
#include "tactics/description/object_words.h"

#include <algorithm>
#include <map>

#include "tactics/description/place_words.h"
#include "tactics/geometry/box.h"
#include "tactics/geometry/shape.h"
#include "tactics/text/json.h"

namespace tactics {

namespace {

std::string place_on(const Page& page, const Region& region) {
    const Ninths ninths({0, 0, page.width, page.height}, "page");
    return ninths.place(rect_of(box_of(region)));
}

// Those without a place, by why they have none; the same name several times is counted.
void add_not_drawn(const Page& page, std::vector<std::string>& sentences) {
    std::vector<std::string> reasons;
    std::map<std::string, std::vector<std::pair<std::string, std::size_t>>> names;
    for (const Region& region : page.regions) {
        if (!region.rings.empty()) continue;
        auto& all = names[region.description];
        if (all.empty()) reasons.push_back(region.description);
        const auto same = std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.first == region.name; });
        if (same == all.end())
            all.emplace_back(region.name, 1);
        else
            ++same->second;
    }
    for (const std::string& reason : reasons) {
        std::vector<std::string> parts;
        for (const auto& [name, count] : names[reason])
            parts.push_back(name + (count > 1 ? " (" + std::to_string(count) + " of them)" : ""));
        sentences.push_back("Not drawn" + (reason.empty() ? "" : ", " + reason) + ": " + listed(parts) + ".");
    }
}

}  // namespace

std::vector<std::string> object_sentences(const Page& page) {
    std::vector<std::string> sentences;
    for (const Region& region : page.regions) {
        if (region.rings.empty()) continue;
        const std::string place = place_on(page, region);
        sentences.push_back(region.name + ", " + place + (place.ends_with("page") ? "" : " of the page") + ", " +
                            spoken_size(rect_of(box_of(region))) + (region.description.empty() ? "" : ": " + region.description) +
                            ".");
    }
    add_not_drawn(page, sentences);
    return sentences;
}

std::vector<std::string> objects_json(const Page& page) {
    std::vector<std::string> all;
    for (const Region& region : page.regions) {
        JsonObject json, counts;
        json.add("name", region.name);
        if (!region.path.empty()) json.add("path", region.path);
        if (!region.description.empty()) json.add("description", region.description);
        for (const auto& [what, count] : region.counts) counts.add(what, count);
        if (!region.counts.empty()) json.add_raw("counts", counts.text());
        json.add_raw("drawn", region.rings.empty() ? "false" : "true");
        if (!region.rings.empty()) {
            const Rect box = rect_of(box_of(region));
            json.add("place", place_on(page, region));
            json.add("x_mm", region.at.x);
            json.add("y_mm", region.at.y);
            json.add("left_mm", box.left);
            json.add("top_mm", box.top);
            json.add("width_mm", box.width);
            json.add("height_mm", box.height);
        }
        all.push_back(json.text());
    }
    return all;
}

}  // namespace tactics
