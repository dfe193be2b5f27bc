// SPDX-License-Identifier: Apache-2.0
// A picture that stands within another file.
#pragma once

#include <optional>
#include <string_view>

#include "tactics/page.h"

namespace tactics {

/// "data:image/png;base64,..." as black and white, at most 4,000 pixels a side. Nothing if it is not that, cannot be read, or is
/// neither PNG nor JPEG nor WebP, whatever it calls itself: browsers show no more, and each other library is one to be attacked.
std::optional<Bitmap> embedded_picture(std::string_view address, const Rect& place);

}  // namespace tactics
