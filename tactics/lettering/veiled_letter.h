// SPDX-License-Identifier: Apache-2.0
// A letter of which a line that is drawn may hide a part.
#pragma once

#include "tactics/lettering/form_reader.h"

namespace tactics {

/// The letter of that font and size (pixels for an em, and where its line stands in the strip) which looks like what is seen of
/// those neighbouring units. Its code is 0 if none does, if too little is seen of it, or if another may be hidden as well: a c
/// that a line touches on its right may be a d.
FormLetter veiled_letter(const InkStrip& strip, std::size_t first, std::size_t last, FormFont& font, double em, double foot);

}  // namespace tactics
