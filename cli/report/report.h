// SPDX-License-Identifier: Apache-2.0
// The result of a picture, in words for a person and in JSON for a script.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tactics/job/make_pages.h"

namespace tactics {

/// "photo.jpg: photo.pdf, photo.svg: 12 lines of 830 mm together; 0.12 s"
Phrase result_line(const Outcome& outcome);
/// The same, and behind it what a person must act on.
Phrase result_with_warnings(const Outcome& outcome);
/// The choices made from the picture, the reasons, and how to change them: "photo.jpg: recipe photo (continuous tones: 31 % flat,
/// 47 % soft, ...); change with --recipe", "photo.jpg: kmeans k=3: 3 colours explain 94 % of its variance; change with --set
/// kmeans.k=NUMBER".
std::vector<Phrase> choice_lines(const Outcome& outcome);
/// Further notes, and everything that a person must act on: changes to the drawing for the rules, pages that are empty or not fit
/// to be felt, words left out, broken rules, files left from an earlier run.
Notes further_lines(const Outcome& outcome);
/// Whether one of its pages was reported as not fit to be felt or to be handed out.
bool needs_a_look(const Outcome& outcome);
/// One object, one line.
std::string result_json(const Outcome& outcome);
/// The member "heights" of an output.
std::string heights_json(const KindHeights& heights);

/// "37 of 200 done, about 40 s left"
Phrase progress_line(std::size_t done, std::size_t all, double seconds);

}  // namespace tactics
