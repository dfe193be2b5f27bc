// A page read from an SVG file, whoever drew it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tactics/page.h"

namespace tactics {

/// A page that was not laid out here: positions may lie off the paper, lines may be thinner than any medium's.
struct FoundPage {
    Page page;
    /// What the file has and the page has not, or has in another way: "2 texts are letters, which no rule looks at".
    std::vector<std::string> notes;
};

/// Lines, curves and shapes in what is darker than half grey become strokes and areas, with their transforms, widths and
/// simple style sheets; small discs that stand as cells do become braille; one picture within the file stays a picture.
/// White drawn over black is not taken as erasing. `paper` is for a file that tells no size. Throws Error(failed).
FoundPage read_svg(std::string_view bytes, const std::string& file, double margin, const std::optional<Paper>& paper);

}  // namespace tactics
