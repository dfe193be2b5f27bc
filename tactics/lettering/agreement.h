// SPDX-License-Identifier: Apache-2.0
// Two readers of a line, one that knows words and one that knows the letters of fonts: what is believed.
#pragma once

#include <string>

#include "tactics/lettering/form_words.h"

namespace tactics {

/// What the reader of words says of a line.
struct ReadWords {
    std::string text;
    double sureness = 0;  ///< 0 to 100
    bool alike = false;   ///< read the same at two sizes, with as many words as there are gaps
    bool sure = false;    ///< sure enough to be believed where fonts have nothing to say
};

struct Belief {
    std::string text;
    double sureness = 0;
    bool sure = false;  ///< it may stand in braille
    bool tell = false;  ///< or a person should look at it
};

Belief believe(const FormWords& words, const ReadWords& other);

}  // namespace tactics
