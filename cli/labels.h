// SPDX-License-Identifier: Apache-2.0
// Names of things, as the user gives them: --label on the command line, files of labels beside the pictures.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cli/command.h"
#include "cli/disk.h"
#include "cli/named_subject.h"
#include "tactics/drawing.h"

namespace tactics {

/// "30%,40%" or "12mm,50mm" before the words: where on the drawing, from its left and its top.
struct PlacedWords {
    double x = 0, y = 0;
    bool share = false;  ///< of the drawing's width and height, 0 to 1; else mm on the drawing
    std::string text;
    std::string origin;
};

/// One label a line, "30%,40% City Park"; empty lines and what follows # at a line's beginning are left out. Throws
/// Error(usage) with the line's number. Lines about the subject are left out, too.
std::vector<PlacedWords> parse_labels(std::string_view text, const std::string& file);

/// What such a file says of the subject, added to `wish`. Throws Error(usage) with the line's number.
SubjectWish parse_subject(std::string_view text, const std::string& file, SubjectWish wish);

struct Job;

/// The labels of each picture and what matters in it: those of --label, then those of the file --labels or, if that is a folder,
/// of the file in it that is named like the picture, "map.labels" for "pictures/map.png"; there may be none. Throws Error.
void plan_labels(std::vector<Job>& jobs, const Given& given, const Disk& disk);

/// On a drawing of that size. Throws Error(usage) for what is outside.
std::vector<Name> names_on(const Drawing& drawing, const std::vector<PlacedWords>& labels);

}  // namespace tactics
