// SPDX-License-Identifier: Apache-2.0
// Opens the input of convert: a picture, an SVG figure, or a PDF page as one of these.
#pragma once

#include <string>
#include <vector>

#include "tactics/job/wishes.h"
#include "tactics/readers/read.h"
#include "tactics/text/phrase.h"

namespace tactics {

/// How to read a PDF page.
struct PdfPageWish {
    int page = 0;             ///< from 1; 0: the first, with a note in `notes` if there are others
    bool as_picture = false;  ///< as pixels, for filters; else its lines stay lines and its text stays text, unless it has pixels
};

/// The way for these wishes: filters need pixels.
PdfPageWish page_wish(const Wishes& wishes);

/// A file or, for "-", standard input; of a PDF, that page. Throws Error.
Source open_input(const std::string& path, const PdfPageWish& wish, std::vector<Phrase>& notes);

/// The same for an opened file.
Source page_of_input(Source source, const std::string& path, const PdfPageWish& wish, std::vector<Phrase>& notes);

/// How many pages page_of_input can give. Throws as pages_of_pdf.
int pages_of_any_pdf(const Source& pdf);

/// Whether it is a PDF of ours as it was written (own_pdf.h): its pages are then read as those of our own SVG.
bool is_own_pdf(Source& source);

}  // namespace tactics
