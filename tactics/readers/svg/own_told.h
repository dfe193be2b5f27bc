// SPDX-License-Identifier: Apache-2.0
// What an SVG of ours tells of its page besides what is drawn (own_marks.h), read back. A file may say anything: what it says is
// within limits here, or it is none of ours.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "tactics/page.h"
#include "tactics/readers/xml.h"

namespace tactics {

/// So many numbers, each a decimal one between -1e12 and 1e12, with blanks between them; nothing: it is not that.
std::optional<std::vector<double>> numbers_told(const Element& element, std::string_view name, std::size_t count);
std::optional<Point> point_told(const Element& element, std::string_view name);
/// A whole number from 0 to a million.
std::optional<std::size_t> number_told(const Element& element, std::string_view name);

/// The page without what is on it, and without words and names; nothing: the file is of another maker or another version.
std::optional<Page> page_told(const Element& root);

/// Its words, names, names that were left out, regions that are not drawn (each with its number among all of them), and remarks.
struct RestTold {
    std::vector<PageWords> words;
    std::vector<PageName> names;
    std::vector<Name> left_out;
    std::vector<std::pair<std::size_t, Region>> undrawn;
    std::vector<std::string> remarks;
};
RestTold rest_told(const Element& root);

/// "folded=3 shared=1"
std::vector<std::pair<std::string, int>> counts_told(std::string_view text);

}  // namespace tactics
