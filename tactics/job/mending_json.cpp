// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/mending_json.h"

#include <vector>

namespace tactics {

namespace {

std::string_view name_of(Mend::Kind kind) {
    switch (kind) {
        case Mend::Kind::joined: return "joined";
        case Mend::Kind::moved: return "moved";
        case Mend::Kind::shifted: return "shifted";
        case Mend::Kind::shrunk: return "shrunk";
        case Mend::Kind::enlarged: return "enlarged";
        case Mend::Kind::outlined: return "outlined";
        case Mend::Kind::broken: return "broken";
        case Mend::Kind::shortened: return "shortened";
        case Mend::Kind::merged: return "merged";
        case Mend::Kind::left_out:
        case Mend::Kind::crowded: return "left out";
    }
    return "";
}

}  // namespace

std::string trust_json(const Trust& trust) {
    JsonObject json;
    json.add("line", trust.line);
    json.add("found", trust.found);
    return json.text();
}

void add_mending(JsonObject& json, const MendingTold& told, const Rect& drawing) {
    if (told.trust) json.add_raw("trust", trust_json(*told.trust));
    if (!told.doubt.empty()) json.add("doubt", told.doubt.english());
    if (!told.measured) return;
    json.add("hard_before", static_cast<double>(told.broken_before));
    json.add("hard_after", static_cast<double>(told.broken_after));
    json.add("kept", told.kept);
    if (!told.advice.empty()) json.add("advice", told.advice.english());
    std::vector<std::string> changes;
    for (const Mend& change : told.changes) {
        JsonObject one;
        one.add("what", name_of(change.kind));
        one.add("x_mm", drawing.left + change.at.x);
        one.add("y_mm", drawing.top + change.at.y);
        if (change.mm > 0) one.add("mm", change.mm);
        changes.push_back(one.text());
    }
    json.add_raw("changes", json_array(changes));
}

}  // namespace tactics
