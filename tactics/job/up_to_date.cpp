// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/up_to_date.h"

#include <algorithm>
#include <filesystem>

#include "tactics/job/page_files.h"

namespace tactics {

namespace {

bool is_there(const std::string& path) {
    std::error_code fault;
    return std::filesystem::is_regular_file(path, fault);
}

std::vector<Phrase> reasons_of(const Output& output, const std::optional<MadeWith>& now, bool strict) {
    if (!is_there(output.path)) return {phrase("{0} is not there", output.path)};
    if (!now) return {phrase("the picture cannot be looked at")};  // converting it will say why
    const auto record = record_of(output);
    if (!record) return {phrase("there is no record of how {0} was made", output.path)};
    for (std::size_t file = 1; file <= record->files; ++file) {
        const std::string path = path_of_page(output, file);
        if (!is_there(path)) return {phrase("{0} is not there", path)};
        if (mark_of_file(path) != record->marks[file - 1]) return {phrase("{0} is not what was written there", path)};
    }
    std::vector<Phrase> reasons = differences(record->with, *now);
    if (reasons.empty() && strict && !record->keeps_rules)
        reasons.push_back(phrase("{0} breaks a hard rule, or was not checked", output.path));
    return reasons;
}

/// Why outputs are made anew, each reason once; no words if none of them is there.
struct Reasons {
    bool strict = false;
    std::vector<Phrase> all = {};
    bool any_there = false;

    void add(const Output& output, const std::optional<MadeWith>& now) {
        any_there = any_there || is_there(output.path);
        for (Phrase& reason : reasons_of(output, now, strict))
            if (std::find(all.begin(), all.end(), reason) == all.end()) all.push_back(std::move(reason));
    }
    std::optional<std::vector<Phrase>> told() const {
        if (all.empty()) return std::nullopt;
        return any_there ? all : std::vector<Phrase>{};
    }
};

}  // namespace

std::optional<std::vector<Phrase>> reasons_to_make(const MadeWith& settings, const Item& item, bool strict) {
    Reasons reasons{strict};
    for (const Output& output : item.outputs) reasons.add(output, made_with(settings, item, output));
    return reasons.told();
}

std::optional<std::vector<Phrase>> reasons_to_bind(const MadeWith& settings, std::span<const Item> items, bool strict) {
    Reasons reasons{strict};
    for (const Item& item : items)
        for (const Output& output : item.outputs)
            if (!output.bound)
                reasons.add(output, made_with(settings, item, output));
            else if (&item == &items.front())
                reasons.add(output, made_with(settings, items, output));
    return reasons.told();
}

}  // namespace tactics
