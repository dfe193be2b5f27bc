// SPDX-License-Identifier: Apache-2.0
// Which files come out of which pictures: worked out, and refused where something would be lost, before any work starts.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "cli/disk.h"
#include "cli/labels.h"
#include "print/format.h"

namespace tactics {

struct Output {
    const Format* format = nullptr;
    std::string path;    ///< "-" is standard output; empty: nothing is written, the page is described
    std::string folder;  ///< the folder that is made if it is missing; empty: it must be there
};

/// One picture and the files to make of it.
struct Job {
    std::string input;  ///< "-" is standard input
    std::vector<Output> outputs;
    std::vector<PlacedWords> labels = {};
    SubjectWish wish = {};        ///< what of the picture matters
    std::string label_file = {};  ///< that was read; empty: none
};

/// `outs` are the values of -o: FILE, FORMAT:FILE, FOLDER/, FORMAT:FOLDER/; `to` the format names for folders.
/// Throws Error(usage): no or unknown format, a file for many pictures, two outputs of one name, an output over an input.
std::vector<Job> plan_outputs(const std::vector<std::string>& inputs, const std::vector<std::string>& outs,
                              const std::vector<std::string>& to, const Disk& disk);

/// Where page `number`, from 1, of an output goes whose format holds one page a file: the first to its path, others beside
/// it, "page-2.png".
std::string path_of_page(const Output& output, std::size_t number);

/// What further pages must not be written to: all pictures and outputs, in words of its own. Folders must be there.
std::set<std::string> taken_by(const std::vector<Job>& jobs, const Disk& disk);
bool is_taken(const std::set<std::string>& taken, const std::string& path, const Disk& disk);

/// The name without folders and without its last ending: "pictures/heart.v2.jpg" is "heart.v2"; "-" is "standard-input".
std::string stem_of(std::string_view path);

}  // namespace tactics
