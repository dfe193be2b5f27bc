// SPDX-License-Identifier: Apache-2.0
// Chooses a recipe for a picture, for `--recipe auto`.
#pragma once

#include <string>

#include "tactics/image.h"
#include "tactics/text/phrase.h"

namespace tactics {

struct Choice {
    std::string recipe;
    Phrase reason;  ///< "continuous tones: 31 % flat, 47 % soft, ...": for the user
};

Choice choose_recipe(const Image& picture);

}  // namespace tactics
