// SPDX-License-Identifier: Apache-2.0
// Many pictures at once: one a worker, and a bad one never stops the rest.
#pragma once

#include <functional>
#include <span>

#include "tactics/job/make_pages.h"

namespace tactics {

struct Many {
    int workers = 0;            ///< 0: as many as there are cores
    bool update = false;        ///< what is_up_to_date (up_to_date.h) is left as it is
    WriteGate* gate = nullptr;  ///< as in Watch
};

/// The folders of the outputs must be there. `take` gets each outcome with the index of its item, in the order in which they are
/// done, by any thread, several at a time. Where an output is bound, all items are up to date or none is.
void make_many(std::span<const Item> items, const Wishes& wishes, const Many& many,
               const std::function<void(std::size_t index, Outcome& outcome)>& take);

}  // namespace tactics
