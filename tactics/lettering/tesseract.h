// SPDX-License-Identifier: Apache-2.0
// Print read by the program Tesseract, which is looked for at run time; nothing else depends on it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tactics/image.h"
#include "tactics/text/phrase.h"

namespace tactics {

/// The reading of a strip of lettering.
struct Guess {
    std::string text;     ///< UTF-8, words with one space between them; empty: nothing was read
    double sureness = 0;  ///< of its least sure word, 0 to 100, as Tesseract says it
};

struct Guesses {
    std::vector<Guess> guesses;  ///< one for each strip; none if there is trouble
    Phrase trouble;              ///< why nothing could be read and how to mend it, one line; empty: all is well
};

/// Each strip holds one line of black letters on white. `language` is a tag of BCP 47. `program` is for tests.
Guesses read_strips(const std::vector<Image>& strips, std::string_view language, const std::string& program = "tesseract");

/// Tesseract's table of words, page by page; ignores lines of another form.
std::vector<Guess> parse_guesses(std::string_view table, std::size_t pages);

/// Its name for a language: "deu" for "de-AT". Empty: not known here.
std::string_view tesseract_language(std::string_view tag);

}  // namespace tactics
