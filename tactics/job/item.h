// SPDX-License-Identifier: Apache-2.0
// One picture and the files to make of it.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "print/format.h"
#include "tactics/job/placed_words.h"
#include "tactics/job/subject_wish.h"

namespace tactics {

struct Output {
    const Format* format = nullptr;
    std::string path;    ///< "-" is standard output; empty: nothing is written, the page is described
    std::string folder;  ///< a folder to create if it is missing; empty: the folder must exist
    bool bound = false;  ///< one file for all items, written at the end (binding.h)
};

/// One picture, or a page of a PDF, and the files to make of it.
struct Item {
    std::string input;  ///< "-" is standard input
    std::vector<Output> outputs;
    std::vector<PlacedWords> labels = {};
    SubjectWish wish = {};         ///< which part of the picture matters
    std::string label_file = {};   ///< the label file that was read; empty: none
    int pdf_page = 0;              ///< page of a PDF; 0: that of the wishes
    int last_page = 0;             ///< last page of a PDF text; 0: only pdf_page
    std::size_t first_number = 1;  ///< number of its first braille page, if it is text
};

/// The output for a file name such as "photo.pdf". Throws Error(usage) if no format has its ending.
Output output_to(const std::string& path);

/// The name without folders and without its last ending: "pictures/heart.v2.jpg" is "heart.v2"; "-" is "standard-input".
std::string stem_of(std::string_view path);

}  // namespace tactics
