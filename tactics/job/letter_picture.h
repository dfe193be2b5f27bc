// SPDX-License-Identifier: Apache-2.0
// Words whose letters are drawn as shapes and occur in no font: read like print in a picture.
#pragma once

#include <string>
#include <string_view>

#include "tactics/readers/svg/found_page.h"

namespace tactics {

/// Fills in the text and confidence of such words, if the reading is certain and covers all of their letters. Returns why nothing
/// could be read and the remedy; empty: all is well, or there was nothing to read. `program` is for tests.
Phrase read_letter_picture(FoundPage& figure, std::string_view language, const std::string& program = "tesseract");

}  // namespace tactics
