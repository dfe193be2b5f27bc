// SPDX-License-Identifier: Apache-2.0
// A print job as the bytes of an embosser, sheet after sheet: for the CUPS filter and for the printer application.
#pragma once

#include <string_view>

#include "cli/verbs/print_options.h"
#include "tactics/readers/read.h"

namespace tactics {

struct PrintJob {
    int copies = 1;
    int first_page = 1, last_page = kAllPages;  ///< of a PDF
    bool is_text = false;                       ///< the document is plain text, for braille

    static constexpr int kAllPages = 1'000'000;
};

/// The number in that word, from 1 to 1000; 1 if it is none.
int copies_of(std::string_view word);

/// Clears the environment, so that nothing about a print job decides which programs run and where files are kept.
void fix_print_surroundings();

/// Writes the bytes to standard output, and to standard error lines in the format of CUPS (filter(7)): INFO with each step and
/// note, PAGE after each sheet. Throws Error, also if the PDF has none of these pages.
void emboss_print_job(Source source, const Queue& queue, const PrintJob& wish);

}  // namespace tactics
