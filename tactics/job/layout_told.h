// SPDX-License-Identifier: Apache-2.0
// Facts about laid-out pages.
#pragma once

#include "tactics/job/make_pages.h"
#include "tactics/layout/pages.h"

namespace tactics {

/// Writes sizes, counts and names of these pages into their layout.
void tell_layout(Layout& layout, const Pages& pages);

/// What is said of words without room. `more_room`: what the user can take, such as larger paper.
Phrase left_out_words(const std::vector<Name>& left_out, const Phrase& more_room);
Phrase thinned_words(std::size_t numbers, const Phrase& more_room);
/// Of a drawing that was `before` wide, mm, and has no room for that on this sheet; empty if it has.
Phrase note_of_smaller(const Layout& layout, double before, const Phrase& more_room);
Phrase no_room_for_words(bool print_is_left, const Phrase& more_room);  ///< not for any
Phrase note_of_long_title(const Sheet& sheet);                          ///< for a display whose line it does not fit; else empty

}  // namespace tactics
