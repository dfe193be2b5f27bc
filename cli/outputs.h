// Which files come out of which pictures: worked out, and refused where something would be lost, before any work starts.
#pragma once

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
    std::string label_file = {};  ///< that was read; empty: none
};

/// `outs` are the values of -o: FILE, FORMAT:FILE, FOLDER/, FORMAT:FOLDER/; `to` the format names for folders.
/// Throws Error(usage): no or unknown format, a file for many pictures, two outputs of one name, an output over an input.
std::vector<Job> plan_outputs(const std::vector<std::string>& inputs, const std::vector<std::string>& outs,
                              const std::vector<std::string>& to, const Disk& disk);

/// The name without folders and without its last ending: "pictures/heart.v2.jpg" is "heart.v2"; "-" is "standard-input".
std::string stem_of(std::string_view path);

}  // namespace tactics
