// SPDX-License-Identifier: Apache-2.0
// A record of how a page was made, kept beside it: pages/.tactics/heart.pdf describes pages/heart.pdf. It lets --update see what
// has changed, and keeps such data out of the page, so that equal pages are equal files.
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

/// Names and values in the user's terms: "--margin" and "15mm".
using MadeWith = std::vector<std::pair<std::string, std::string>>;

/// The folder of records beside an output.
inline constexpr std::string_view kRecordFolder = ".tactics";

/// `settings`, which all pictures share, and the facts of this picture and output: the picture's size and time, the contents of
/// the label file, the format. Nothing: the picture cannot be accessed.
std::optional<MadeWith> made_with(const MadeWith& settings, const Item& item, const Output& output);

/// The same for an output that binds all of these pictures, in their order.
std::optional<MadeWith> made_with(const MadeWith& settings, std::span<const Item> items, const Output& output);

/// A fingerprint of a file's contents: its length and 64-bit FNV-1a; "missing" if it cannot be read.
std::string mark_of_file(const std::string& path);

/// The facts when the output was made, its files, and a fingerprint of each: a file with another fingerprint now was made by
/// somebody else, or is damaged.
struct Record {
    MadeWith with;
    std::size_t files = 0;
    std::vector<std::string> marks = {};  ///< fingerprints of `files`, filled in by keep_record
    bool keeps_rules = false;             ///< checked, and no hard rule was broken; else that is not known, or one was
};
std::optional<Record> record_of(const Output& output);

/// Writes the record. A folder that cannot be written gets no records, so its pages are made anew each time; there is no message,
/// since the page itself exists. `new_folder`: create the folder of records if it is missing; otherwise write a record only if
/// that folder exists.
void keep_record(const Output& output, const Record& record, bool new_folder);

/// The differences in words: "--margin is 15mm, was 20mm".
std::vector<Phrase> differences(const MadeWith& before, const MadeWith& now);

}  // namespace tactics
