// SPDX-License-Identifier: Apache-2.0
// Names of things at places in a picture, and files of them.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "tactics/drawing.h"
#include "tactics/job/subject_wish.h"

namespace tactics {

inline constexpr std::size_t kMostLabels = 1000;  ///< of a picture; far more than a page has room for

/// "30%,40%" or "12mm,50mm" before the words: where on the drawing, from its left and its top.
struct PlacedWords {
    double x = 0, y = 0;
    bool share = false;  ///< of the drawing's width and height, 0 to 1; else mm on the drawing
    std::string text;
    std::string origin;
};

/// One label a line, "30%,40% City Park"; empty lines and what follows # at a line's beginning are left out. Throws
/// Error(usage) with the line's number. Lines about the subject are left out, too.
std::vector<PlacedWords> parse_labels(std::string_view text, const std::string& file);

/// What such a file says of the subject, added to `wish`. Throws Error(usage) with the line's number.
SubjectWish parse_subject(std::string_view text, const std::string& file, SubjectWish wish);

/// A label of such a place and such words. Throws Error(usage) at `origin`.
PlacedWords label_of(std::string_view place, std::string_view words, const std::string& origin);

/// On a drawing of that size. Throws Error(usage) for what is outside.
std::vector<Name> names_on(const Drawing& drawing, const std::vector<PlacedWords>& labels);

}  // namespace tactics
