// SPDX-License-Identifier: Apache-2.0
// `evaluate --study subject`: whether what a person points at is found as a whole.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "studies/study.h"
#include "studies/told_table.h"
#include "tactics/image.h"
#include "tactics/recipe.h"

namespace tactics {

/// A person's hint about the subject: a box or a point, in pixels of the picture as the annotators saw it.
struct SubjectHint {
    std::optional<std::array<int, 4>> box;    ///< around it: left, top, right, bottom, the last two exclusive
    std::optional<std::array<int, 2>> point;  ///< in it
};

/// The subject found, as a mask of the picture's size.
using SubjectFinder = std::function<std::vector<std::uint8_t>(const SubjectHint& hint)>;
/// Looks at a picture with a recipe, once for all hints; width and height are those of the masks.
using SubjectSearch = std::function<SubjectFinder(Recipe recipe, Image image, int width, int height)>;

/// The region that the point is in, or those that lie in the box for the greater part, of all that the recipe's lines enclose.
SubjectFinder find_among_regions(Recipe recipe, Image image, int width, int height);

/// The subject in the region tree that the recipe makes; for a recipe without one, as in find_among_regions.
SubjectFinder find_subjects(Recipe recipe, Image image, int width, int height);

/// The overlaps with the agreed objects of one picture.
struct SubjectTrial {
    bool tried = false;
    std::vector<double> box, point;  ///< by object
};

struct SubjectRow {
    Phrase name;
    std::vector<SubjectTrial> trials;  ///< by picture
};

struct SubjectStudy {
    std::vector<std::string> pictures;
    std::size_t bare = 0;          ///< of these, without an agreed object
    std::vector<SubjectRow> rows;  ///< the recipes, the simplest person, and the box alone
    std::vector<Phrase> problems;
};

std::vector<ToldRow> subject_rows(const SubjectStudy& study);
/// One object a line: each row with its pictures, and last what the whole was.
std::string subject_json(const SubjectStudy& study);

/// Whatever search is asked.
StudyFindings study_subject(const StudyRequest& request, const StudyWatch& watch, const SubjectSearch& search);

}  // namespace tactics
