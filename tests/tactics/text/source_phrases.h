// SPDX-License-Identifier: Apache-2.0
// The phrases that stand in the source, as tactics/text/phrase.h has them.
#pragma once

#include <string>
#include <vector>

#include "tests/tree.h"

namespace tactics::tests {

struct SourcePhrase {
    std::string english;
    std::string plural;  ///< empty: it has none
    std::string path;    ///< where it stands first
};

/// What is given to phrase, phrases and SourceWords in that text, and the names of textures; in order, each time.
std::vector<SourcePhrase> phrases_in(const SourceFile& file);

/// Words of a sentence that are given as they are: the strings in the message of an Error and, in cli/, in what is given to say,
/// which are not within a call (such as that of phrase) and not compared with. Blanks and marks alone do not count.
std::vector<std::string> plain_words_in(const SourceFile& file);

/// Each of the whole program once, by the files' names.
std::vector<SourcePhrase> phrases_of_the_program();

}  // namespace tactics::tests
