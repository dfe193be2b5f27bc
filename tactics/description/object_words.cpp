// SPDX-License-Identifier: Apache-2.0
#include "tactics/description/object_words.h"

#include <algorithm>
#include <utility>

#include "tactics/description/place_words.h"
#include "tactics/geometry/box.h"
#include "tactics/geometry/shape.h"
#include "tactics/text/json.h"

namespace tactics {

namespace {

Phrase place_on(const Page& page, const Rect& box) { return Ninths({0, 0, page.width, page.height}).place_on_page(box); }

// Those without a place, by why they have none; the same name several times is counted.
void add_not_drawn(const Page& page, std::vector<Phrase>& sentences) {
    struct Named {
        Phrase name;
        std::size_t count = 0;
    };
    std::vector<std::pair<Phrase, std::vector<Named>>> reasons;
    for (const Region& region : page.regions) {
        if (!region.rings.empty()) continue;
        auto reason =
            std::find_if(reasons.begin(), reasons.end(), [&](const auto& one) { return one.first == region.description; });
        if (reason == reasons.end()) reason = reasons.insert(reason, {region.description, {}});
        auto& names = reason->second;
        auto same = std::find_if(names.begin(), names.end(), [&](const Named& one) { return one.name == region.name; });
        if (same == names.end()) same = names.insert(same, {region.name});
        ++same->count;
    }
    for (const auto& [reason, names] : reasons) {
        std::vector<Phrase> parts;
        for (const Named& one : names)
            parts.push_back(one.count > 1 ? phrase("{0} ({1} of them)", one.name, std::to_string(one.count)) : one.name);
        sentences.push_back(reason.empty() ? phrase("Not drawn: {0}.", listed(parts))
                                           : phrase("Not drawn, {0}: {1}.", reason, listed(parts)));
    }
}

}  // namespace

std::vector<Phrase> object_sentences(const Page& page) {
    std::vector<Phrase> sentences;
    for (const Region& region : page.regions) {
        if (region.rings.empty()) continue;
        const Rect box = rect_of(box_of(region));
        const Phrase place = place_on(page, box), size = spoken_size(box);
        sentences.push_back(region.description.empty()
                                ? phrase("{0}, {1}, {2}.", region.name, place, size)
                                : phrase("{0}, {1}, {2}: {3}.", region.name, place, size, region.description));
    }
    add_not_drawn(page, sentences);
    return sentences;
}

std::vector<std::string> objects_json(const Page& page) {
    std::vector<std::string> all;
    for (const Region& region : page.regions) {
        JsonObject json, counts;
        json.add("name", region.name.english());
        if (!region.path.empty()) json.add("path", region.path);
        if (!region.description.empty()) json.add("description", region.description.english());
        for (const auto& [what, count] : region.counts) counts.add(what, count);
        if (!region.counts.empty()) json.add_raw("counts", counts.text());
        json.add_raw("drawn", region.rings.empty() ? "false" : "true");
        if (!region.rings.empty()) {
            const Rect box = rect_of(box_of(region));
            json.add("place", place_on(page, box).english());
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
