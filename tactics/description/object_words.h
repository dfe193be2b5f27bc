// SPDX-License-Identifier: Apache-2.0
// The named things of a page: what each is called, where it lies and what became of it.
#pragma once

#include <string>
#include <vector>

#include "tactics/page.h"
#include "tactics/text/phrase.h"

namespace tactics {

/// "Top, in the middle of the page, 12 cm wide and 8 cm high: seen from above." One for each that is drawn, then one for each
/// reason why others are not.
std::vector<Phrase> object_sentences(const Page& page);

/// A JSON object for each: name, path, description, counts, drawn; of what is drawn also place, x_mm and y_mm of a place well
/// within, and left_mm, top_mm, width_mm and height_mm of its box. In English.
std::vector<std::string> objects_json(const Page& page);

}  // namespace tactics
