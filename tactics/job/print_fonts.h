// SPDX-License-Identifier: Apache-2.0
// The installed fonts, for reading print in pictures.
#pragma once

#include "tactics/lettering/letter_form.h"

namespace tactics {

/// The fonts that drawing and plotting programs use, some dozens.
void each_print_font(const std::vector<char32_t>& codes, const std::function<bool(PrintFont)>& goes_on);

}  // namespace tactics
