// SPDX-License-Identifier: Apache-2.0
// Many pictures at once: one a worker, and a bad one never stops the rest.
#pragma once

#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "tactics/job/made_record.h"
#include "tactics/job/make_pages.h"

namespace tactics {

struct Many {
    int workers = 0;            ///< 0: as many as there are cores
    bool update = false;        ///< what has no reasons_to_make (up_to_date.h) is left as it is
    WriteGate* gate = nullptr;  ///< as in Watch
    /// What differs between one call and another that may make other pages, for the records of made_record.h; nullptr: none are
    /// kept. They are kept where the outputs have a folder (Output::folder), with `update`, and where there are some already.
    const MadeWith* settings = nullptr;
};

/// The folders of the outputs must be there. `take` gets each outcome with the index of its item, in the order in which they are
/// done, by any thread, several at a time. Where an output is bound, all items are up to date or none is.
void make_many(std::span<const Item> items, const Wishes& wishes, const Many& many,
               const std::function<void(std::size_t index, Outcome& outcome)>& take);

/// With what each file will be made that all of these are bound into: to be asked before the pictures are read, and kept
/// (keep_record) when the file is written and none is missing. None without `settings`, or of pictures that cannot be looked at.
std::vector<std::pair<Output, MadeWith>> bound_made_with(std::span<const Item> items, const Many& many);

}  // namespace tactics
