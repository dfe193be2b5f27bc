// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/make_many.h"

#include "tactics/job/page_files.h"
#include "tactics/job/up_to_date.h"
#include "tactics/job/workers.h"

namespace tactics {

void make_many(std::span<const Item> items, const Wishes& wishes, const Many& many,
               const std::function<void(std::size_t index, const Outcome& outcome)>& take) {
    const std::set<std::string> taken = taken_by(items, real_disk());
    share_out(items.size(), many.workers, [&](std::size_t i) {
        if (!many.update || !is_up_to_date(wishes, items[i]))
            return take(i, make_pages(Job{items[i], wishes}, {{}, many.gate, &taken}));
        Outcome outcome;
        outcome.input = items[i].input;
        outcome.up_to_date = true;
        take(i, outcome);
    });
}

}  // namespace tactics
