// SPDX-License-Identifier: Apache-2.0
// What convert is given: a picture, a figure in SVG, or a page of a PDF as one of these.
#pragma once

#include <string>
#include <vector>

#include "tactics/job/wishes.h"
#include "tactics/readers/read.h"
#include "tactics/text/phrase.h"

namespace tactics {

/// How a page of a PDF is looked at.
struct PdfPageWish {
    int page = 0;  ///< from 1; 0: its first, and `notes` is told of others
    bool as_picture =
        false;  ///< in pixels, as filters want it; else its lines stay lines and its text stays text, unless it has pixels
};

/// As such pages are made: who asks for filters wants pixels.
PdfPageWish page_wish(const Wishes& wishes);

/// A file or, for "-", standard input; of a PDF that page. Throws Error.
Source open_input(const std::string& path, const PdfPageWish& wish, std::vector<Phrase>& notes);

/// The same of a file that is open already.
Source page_of_input(Source source, const std::string& path, const PdfPageWish& wish, std::vector<Phrase>& notes);

}  // namespace tactics
