// SPDX-License-Identifier: Apache-2.0
// With what a page was made, kept beside it: pages/.tactics/heart.pdf tells of pages/heart.pdf. So that --update sees what has
// changed since, and the page itself holds nothing that differs where pages are the same.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tactics/job/item.h"
#include "tactics/text/phrase.h"

namespace tactics {

/// Names and values, as a user knows them: "--margin" and "15mm".
using MadeWith = std::vector<std::pair<std::string, std::string>>;

/// The folder beside an output in which such files are.
inline constexpr std::string_view kRecordFolder = ".tactics";

/// `settings`, which are the same for all pictures, and what is of this picture and output: the picture by its size and time, the
/// file of labels by what is in it, the format. Nothing: the picture cannot be looked at.
std::optional<MadeWith> made_with(const MadeWith& settings, const Item& item, const Output& output);

/// The same of an output into which all of these pictures are bound, in their order.
std::optional<MadeWith> made_with(const MadeWith& settings, std::span<const Item> items, const Output& output);

/// A mark of what a file holds that changes with it: its length and FNV-1a of 64 bits; "missing" if it cannot be read.
std::string mark_of_file(const std::string& path);

/// What there was when the output was made, in how many files, and a mark of each of these: one that is another now was made by
/// somebody else, or is damaged.
struct Record {
    MadeWith with;
    std::size_t files = 0;
    std::vector<std::string> marks = {};  ///< of `files`; keep_record looks at them
};
std::optional<Record> record_of(const Output& output);

/// Keeps it. A folder that cannot be written has no records, and what is in it is made anew each time; nobody is told, since the
/// page is there. `new_folder`: the folder of records is made if it is missing; else there is none without it.
void keep_record(const Output& output, const Record& record, bool new_folder);

/// How they differ, in words: "--margin is 15mm, was 20mm".
std::vector<Phrase> differences(const MadeWith& before, const MadeWith& now);

}  // namespace tactics
