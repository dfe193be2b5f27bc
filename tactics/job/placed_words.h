// SPDX-License-Identifier: Apache-2.0
// Names of things at places in a picture, and label files.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "tactics/drawing.h"
#include "tactics/job/subject_wish.h"
#include "tactics/job/trimmed.h"
#include "tactics/page.h"

namespace tactics {

inline constexpr std::size_t kMostLabels = 1000;  ///< per picture; far more than a page has room for

/// "30%,40%" or "12mm,50mm" before the words: the place from the left and top, in percent of the whole picture, also where white
/// around it is not drawn, or as lengths on the drawing, which is then of the whole picture.
struct PlacedWords {
    double x = 0, y = 0;
    bool share = false;  ///< of the picture's width and height, 0 to 1; else mm on the drawing
    std::string text;
    std::string origin;
};

/// One label per line, "30%,40% City Park"; skips empty lines, lines that begin with #, and lines about the subject. Throws
/// Error(usage) with the line number.
std::vector<PlacedWords> parse_labels(std::string_view text, const std::string& file);

/// Adds such a file's lines about the subject to `wish`. Throws Error(usage) with the line number.
SubjectWish parse_subject(std::string_view text, const std::string& file, SubjectWish wish);

/// A label from text with a place and words. Throws Error(usage) at `origin`.
PlacedWords label_of(std::string_view place, std::string_view words, const std::string& origin);

/// The names on a drawing of that size. Shares are of the whole picture, of which that part is drawn, and mm are on the drawing.
std::vector<Name> names_on(const Drawing& drawing, const std::vector<PlacedWords>& labels, const Rect& part = kWhole);
/// Whether one names what is in the picture, but not in that part.
bool any_outside(const std::vector<PlacedWords>& labels, const Rect& part);
/// Throws Error(usage) for a place in mm outside a drawing of that size.
void check_places(const std::vector<PlacedWords>& labels, double width, double height);

}  // namespace tactics
