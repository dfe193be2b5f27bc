// SPDX-License-Identifier: Apache-2.0
// Many pictures at once: one per worker; a bad picture never stops the rest.
#pragma once

#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "tactics/job/made_record.h"
#include "tactics/job/make_pages.h"

namespace tactics {

struct Many {
    int workers = 0;            ///< 0: the number of cores
    bool update = false;        ///< skip items without reasons_to_make (up_to_date.h)
    bool strict = false;        ///< as there; the wishes then check rules
    WriteGate* gate = nullptr;  ///< as in Watch
    /// The settings that can change pages between calls, for the records of made_record.h; nullptr: no records. Records are kept
    /// if the outputs have a folder (Output::folder), with `update`, and where some exist already.
    const MadeWith* settings = nullptr;
};

/// The folders of the outputs must exist. `take` receives each outcome with the index of its item, as they finish, from any
/// thread, several at a time. If an output is bound, either all items are up to date or none is.
void make_many(std::span<const Item> items, const Wishes& wishes, const Many& many,
               const std::function<void(std::size_t index, Outcome& outcome)>& take);

/// The records for the files that bind all of these items. Call it before the pictures are read, and keep the records
/// (keep_record) once the file is written and no page is missing. Empty without `settings`, or if a picture cannot be accessed.
std::vector<std::pair<Output, MadeWith>> bound_made_with(std::span<const Item> items, const Many& many);

}  // namespace tactics
