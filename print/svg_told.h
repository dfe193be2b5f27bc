// SPDX-License-Identifier: Apache-2.0
// What an SVG of ours tells of its page besides what is drawn, so that it can be read back (layout/own_marks.h).
#pragma once

#include <string>
#include <string_view>

#include "tactics/page.h"

namespace tactics {

/// ` name="value"`, escaped.
void append_told(std::string& text, std::string_view name, std::string_view value);
void append_told(std::string& text, std::string_view name, std::size_t number);
/// ` name="1.5 2"`: numbers that are read as the same ones.
void append_exact(std::string& text, std::string_view name, std::initializer_list<double> numbers);

/// The attributes of the root.
std::string page_told(const Page& page);

/// A group that is not shown, with words, names and what is not drawn; empty: there are none.
std::string rest_told(const Page& page);

/// Of a region that is drawn or not, the number of which is given.
std::string region_told(const Region& region, std::size_t number);

}  // namespace tactics
