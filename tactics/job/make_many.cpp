// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/make_many.h"

#include "tactics/job/up_to_date.h"
#include "tactics/job/workers.h"

namespace tactics {

void make_many(std::span<const Job> jobs, const Wishes& wishes, const Many& many,
               const std::function<void(std::size_t index, const Outcome& outcome)>& take) {
    share_out(jobs.size(), many.workers, [&](std::size_t i) {
        if (!many.update || !is_up_to_date(wishes, jobs[i])) return take(i, make_pages(jobs[i], wishes, {{}, many.gate}));
        Outcome outcome;
        outcome.input = jobs[i].input;
        outcome.up_to_date = true;
        take(i, outcome);
    });
}

}  // namespace tactics
