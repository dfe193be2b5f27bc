// SPDX-License-Identifier: Apache-2.0
// The installed fonts, as who reads print in pictures wants them.
#pragma once

#include "tactics/lettering/letter_form.h"

namespace tactics {

/// Those that drawing and plotting programs take, some dozens.
void each_print_font(const std::vector<char32_t>& codes, const std::function<bool(FontShapes)>& goes_on);

}  // namespace tactics
