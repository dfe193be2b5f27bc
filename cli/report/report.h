// SPDX-License-Identifier: Apache-2.0
// What became of a picture, in words for a person and in JSON for a script.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tactics/job/make_pages.h"

namespace tactics {

/// "photo.jpg: photo.pdf, photo.svg: 12 lines of 830 mm together; 0.12 s"
std::string result_line(const Outcome& outcome);
/// "photo.jpg: recipe photo (continuous tones: 31 % flat, 47 % soft, ...); change with --recipe", or empty if nothing was chosen.
std::string choice_line(const Outcome& outcome);
/// "photo.jpg: kmeans k=3: 3 colours explain 94 % of its variance; change with --set kmeans.k=NUMBER", for each filter that
/// chose.
std::vector<std::string> chosen_lines(const Outcome& outcome);
/// "dot.png: nothing was drawn: ...", or empty if there is something to feel on every page.
std::string nothing_line(const Outcome& outcome);
/// What else the user should know: "chart.png: print at 12 %, 40 % was read as ...".
std::vector<std::string> note_lines(const Outcome& outcome);
/// "photo.jpg: photo-2.png is no page of it any more; ...", or empty.
std::string left_over_line(const Outcome& outcome);
/// What was changed in the drawings for the rules, if `all` is asked for; and in any case what cannot be made fit to be
/// felt, and what people would hardly agree with.
std::vector<std::string> mending_lines(const Outcome& outcome, bool all);
/// One of its pages is not fit to be felt or to be handed out, and was told so.
bool needs_a_look(const Outcome& outcome);
/// One object, one line.
std::string result_json(const Outcome& outcome);

/// "37 of 200 done, about 40 s left"
std::string progress_line(std::size_t done, std::size_t all, double seconds);

}  // namespace tactics
