// SPDX-License-Identifier: Apache-2.0
// Where something lies, in words, and the small words of lists.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "tactics/page.h"

namespace tactics {

inline constexpr std::array<const char*, 9> kNinths{"upper left",   "upper middle", "upper right",  "middle left", "middle",
                                                    "middle right", "lower left",   "lower middle", "lower right"};

/// Which ninth of the page, or of its drawing.
class Ninths {
public:
    Ninths(const Rect& frame, std::string_view name) : frame_(frame), name_(name) {}

    std::size_t of(Point p) const;
    std::size_t of(const Rect& box) const { return of(Point{box.left + box.width / 2, box.top + box.height / 2}); }

    std::string place(const Rect& box) const;  ///< "in the upper left"
    /// Of a line from end to end, told in reading order: "from the upper left to the middle".
    std::string course(Point a, Point b) const;

private:
    Rect frame_;
    std::string name_;
};

std::string counted(std::size_t count, const std::string& thing);  ///< "3 lines"
std::string listed(const std::vector<std::string>& parts);         ///< "one, two and three"

}  // namespace tactics
