// SPDX-License-Identifier: Apache-2.0
// Words of a figure that are letters drawn as shapes and that no font has: looked at as print in a picture is.
#pragma once

#include <string>
#include <string_view>

#include "tactics/readers/svg/found_page.h"

namespace tactics {

/// Fills in the text of such words, with its sureness, where it is sure and is that of all their letters. Gives why nothing could
/// be read and how to mend it; empty: all is well, or there was nothing to read. `program` is for tests.
Phrase read_letter_picture(FoundPage& figure, std::string_view language, const std::string& program = "tesseract");

}  // namespace tactics
