// SPDX-License-Identifier: Apache-2.0
// What became of a picture, in words for a person and in JSON for a script.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tactics/job/make_pages.h"

namespace tactics {

/// "photo.jpg: photo.pdf, photo.svg: 12 lines of 830 mm together; 0.12 s"
Phrase result_line(const Outcome& outcome);
/// What was chosen from the picture and why, and how to change it: "photo.jpg: recipe photo (continuous tones: 31 % flat, 47 %
/// soft,
/// ...); change with --recipe", "photo.jpg: kmeans k=3: 3 colours explain 94 % of its variance; change with --set
/// kmeans.k=NUMBER".
std::vector<Phrase> choice_lines(const Outcome& outcome);
/// What else there is to know, and what a person must act on: what was changed in the drawing for the rules, a page that is not
/// fit to be felt or has nothing on it, words that are left out, rules that are broken, files that are left of an earlier run.
Notes further_lines(const Outcome& outcome);
/// One of its pages is not fit to be felt or to be handed out, and was told so.
bool needs_a_look(const Outcome& outcome);
/// A page breaks a hard rule; known only if the wishes asked for it.
bool breaks_a_rule(const Outcome& outcome);
/// One object, one line.
std::string result_json(const Outcome& outcome);

/// "37 of 200 done, about 40 s left"
Phrase progress_line(std::size_t done, std::size_t all, double seconds);

}  // namespace tactics
