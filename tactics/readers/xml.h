// SPDX-License-Identifier: Apache-2.0
// XML as a tree, within limits that bound the cost of a hostile file.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tactics {

struct Element {
    std::string name;  ///< without its prefix: "path" for "svg:path"
    std::vector<std::pair<std::string, std::string>> attributes;
    std::vector<Element> children;
    std::string text;       ///< all of its own, without that of its children
    std::string comment;    ///< those within it, outside of its children, a line each
    std::size_t after = 0;  ///< how much of the text of the element around it stands before it
    long line = 0;          ///< of the file, from 1

    /// Empty if it has none.
    std::string_view attribute(std::string_view attribute_name) const;
};

inline constexpr std::size_t kMostXmlBytes = 64u << 20;
inline constexpr std::size_t kMostElements = 1'000'000;
inline constexpr std::size_t kMostDepth = 200;

/// Nothing outside the file is ever opened; entities that would grow the text are refused. Throws Error(failed) at FILE:LINE.
Element parse_xml(std::string_view bytes, const std::string& file);

}  // namespace tactics
