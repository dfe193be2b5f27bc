// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/make_many.h"

#include <algorithm>

#include "tactics/job/page_files.h"
#include "tactics/job/up_to_date.h"
#include "tactics/job/workers.h"

namespace tactics {

namespace {

std::size_t files_of(const Output& output, const Outcome& outcome) {
    const auto made = [&](const std::string& path) {
        return std::any_of(outcome.made.begin(), outcome.made.end(), [&](const Made& one) { return one.output.path == path; });
    };
    std::size_t files = 0;
    while (made(path_of_page(output, files + 1))) ++files;
    return files;
}

// With its records, which tell of the picture as it was before it was read.
Outcome make_one(const Item& item, const Wishes& wishes, const Many& many, const std::set<std::string>& taken) {
    std::vector<std::optional<MadeWith>> with;
    if (many.settings != nullptr)
        for (const Output& output : item.outputs) with.push_back(made_with(*many.settings, item, output));
    Outcome outcome = make_pages(Job{item, wishes}, {{}, many.gate, &taken});
    if (!outcome.error.empty()) return outcome;
    const bool kept = !breaks_a_rule(outcome);
    for (std::size_t i = 0; i < with.size(); ++i)
        if (const std::size_t files = files_of(item.outputs[i], outcome); with[i] && files > 0 && !item.outputs[i].bound)
            keep_record(item.outputs[i], {std::move(*with[i]), files, {}, kept}, many.update || !item.outputs[i].folder.empty());
    return outcome;
}

bool binds(const Item& item) {
    return std::any_of(item.outputs.begin(), item.outputs.end(), [](const Output& output) { return output.bound; });
}

}  // namespace

void make_many(std::span<const Item> items, const Wishes& wishes, const Many& many,
               const std::function<void(std::size_t index, Outcome& outcome)>& take) {
    const std::set<std::string> taken = taken_by(items, real_disk());
    const bool together = !items.empty() && binds(items.front());
    const MadeWith settings = many.settings == nullptr ? MadeWith{} : *many.settings;
    // All of them are made if one has to be: what a file of many holds is not taken out of it.
    std::optional<std::vector<Phrase>> reasons_for_all;
    if (many.update && together) reasons_for_all = reasons_to_bind(settings, items, many.strict);
    share_out(items.size(), many.workers, [&](std::size_t i) {
        std::optional<std::vector<Phrase>> reasons;
        if (many.update) reasons = together ? reasons_for_all : reasons_to_make(settings, items[i], many.strict);
        Outcome outcome;
        if (many.update && !reasons) {
            outcome.input = items[i].input;
            outcome.up_to_date = true;
        } else {
            outcome = make_one(items[i], wishes, many, taken);
            if (reasons && (!together || i == 0)) outcome.made_anew = *reasons;
        }
        take(i, outcome);
    });
}

std::vector<std::pair<Output, MadeWith>> bound_made_with(std::span<const Item> items, const Many& many) {
    std::vector<std::pair<Output, MadeWith>> all;
    if (many.settings == nullptr || items.empty()) return all;
    for (const Output& output : items.front().outputs)
        if (output.bound)
            if (auto with = made_with(*many.settings, items, output)) all.emplace_back(output, std::move(*with));
    return all;
}

}  // namespace tactics
