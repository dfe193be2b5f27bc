// SPDX-License-Identifier: Apache-2.0
#include "print/display_parts.h"

#include <algorithm>
#include <cmath>

namespace tactics {

std::vector<Page> parts_of(std::span<const Page> pages, double width, double height) {
    const auto count = [](double whole, double part) { return std::max(1, static_cast<int>(std::ceil(whole / part - 1e-6))); };
    std::vector<Page> parts;
    for (const Page& page : pages)
        for (int row = 0; row < count(page.height, height); ++row)
            for (int column = 0; column < count(page.width, width); ++column) {
                Page& part = parts.emplace_back(page);
                move_by(part, -column * width, -row * height);
                part.width = width;
                part.height = height;
            }
    return parts;
}

}  // namespace tactics
