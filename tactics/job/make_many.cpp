// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/make_many.h"

#include <algorithm>

#include "tactics/job/page_files.h"
#include "tactics/job/up_to_date.h"
#include "tactics/job/workers.h"

namespace tactics {

namespace {

bool all_are_up_to_date(std::span<const Item> items, const Wishes& wishes) {
    return std::all_of(items.begin(), items.end(), [&](const Item& item) { return is_up_to_date(wishes, item); });
}

bool binds(const Item& item) {
    return std::any_of(item.outputs.begin(), item.outputs.end(), [](const Output& output) { return output.bound; });
}

}  // namespace

void make_many(std::span<const Item> items, const Wishes& wishes, const Many& many,
               const std::function<void(std::size_t index, Outcome& outcome)>& take) {
    const std::set<std::string> taken = taken_by(items, real_disk());
    const bool together = !items.empty() && binds(items.front());
    const bool none_to_do = many.update && together && all_are_up_to_date(items, wishes);
    share_out(items.size(), many.workers, [&](std::size_t i) {
        Outcome outcome;
        if (many.update && (together ? none_to_do : is_up_to_date(wishes, items[i]))) {
            outcome.input = items[i].input;
            outcome.up_to_date = true;
        } else {
            outcome = make_pages(Job{items[i], wishes}, {{}, many.gate, &taken});
        }
        take(i, outcome);
    });
}

}  // namespace tactics
