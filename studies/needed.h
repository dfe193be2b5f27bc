// SPDX-License-Identifier: Apache-2.0
// `evaluate --study needed`: how few grey levels, how low a resolution, how few strokes are enough.
#pragma once

#include <string>
#include <vector>

#include "studies/study.h"
#include "tactics/measure/needed.h"

namespace tactics {

struct NeededDial {
    std::string name;            ///< "grey levels"
    Phrase told;                 ///< the same, in any language
    std::string word;            ///< for the name of a file: "levels"
    std::vector<double> values;  ///< ascending; the last may be infinite: all
};

struct NeededRecipe {
    std::string name;
    std::vector<std::vector<NeededCurve>> curves;    ///< by dial, then by picture as in `pictures` below
    std::vector<std::vector<std::string>> pictures;  ///< by dial: those that have it; without strokes there is no such dial
    std::vector<std::string> chosen;                 ///< by auto, one name a picture
};

struct NeededStudy {
    std::vector<NeededDial> dials;
    std::vector<NeededRecipe> recipes;
    std::size_t tried = 0;  ///< pictures
    std::vector<Phrase> problems;
};

std::string needed_text(const NeededStudy& study, std::string_view language);
/// One object a line: each recipe with its dials and their pictures, and last what the whole was.
std::string needed_json(const NeededStudy& study);

}  // namespace tactics
