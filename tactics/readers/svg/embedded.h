// SPDX-License-Identifier: Apache-2.0
// A picture that stands within another file.
#pragma once

#include <optional>
#include <string_view>

#include "tactics/page.h"
#include "tactics/readers/svg/found_page.h"

namespace tactics {

/// "data:image/png;base64,..." as black and white, at most 4,000 pixels a side. Nothing if it is not that, cannot be read, or is
/// neither PNG nor JPEG nor WebP, whatever it calls itself: browsers show no more, and each other library is one to be attacked.
std::optional<Bitmap> embedded_picture(std::string_view address, const Rect& place);

/// The same, for a page that has none yet, which is told. Nothing besides where it is mirrored.
bool take_page_picture(FoundPage& page, std::string_view address, const Rect& place);

/// The same as it stands in the file, for a figure that shows it at `place` as far as `clip` lets it; negative sizes mirror it.
/// Nothing besides where its head cannot be read, or less of it is seen than a finger could tell, or the figure has as many as
/// are taken (20).
bool take_figure_picture(FoundPage& figure, std::string_view address, const Rect& place, const Rect& clip);

}  // namespace tactics
