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

/// Each of the whole program once, by the files' names.
std::vector<SourcePhrase> phrases_of_the_program();

}  // namespace tactics::tests
