// SPDX-License-Identifier: Apache-2.0
// What convert is given: a picture, a figure in SVG, or a page of a PDF.
#pragma once

#include <string>
#include <vector>

#include "tactics/readers/read.h"

namespace tactics {

/// A file or, for "-", standard input. Of a PDF that page, from 1, is drawn as a picture; 0 is its first, and `notes` is told of
/// others. Throws Error.
Source open_input(const std::string& path, int page, std::vector<std::string>& notes);

/// The same of a file that is open already.
Source page_of_input(Source source, const std::string& path, int page, std::vector<std::string>& notes);

}  // namespace tactics
