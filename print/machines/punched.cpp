// SPDX-License-Identifier: Apache-2.0
#include "print/machines/punched.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "tactics/text/utf8.h"

namespace tactics {

Page page_of(const PunchedSheet& sheet, double width, double height, double dot) {
    Page page;
    page.width = width;
    page.height = height;
    page.live = {0, 0, width, height};
    for (std::size_t i = 0; i < sheet.dots.size(); ++i)
        page.strokes.push_back(
            {{sheet.dots[i], sheet.dots[i]}, false, dot * std::sqrt(std::clamp(sheet.height_of(i), 0.1, 1.0))});
    return page;
}

std::string unicode_of(std::span<const std::uint8_t> cells) {
    std::size_t end = cells.size();
    while (end > 0 && cells[end - 1] == 0) --end;
    std::string letters;
    for (const std::uint8_t cell : cells.first(end)) append_letter(letters, 0x2800u + cell);
    return letters;
}

std::vector<std::string> unicode_of(const PunchedSheet& sheet, double pitch) {
    constexpr int kMost = 10'000;  // cells across and lines down
    std::vector<std::vector<std::uint8_t>> lines = sheet.lines;
    if (lines.empty()) {
        constexpr std::uint8_t kBits[4][2] = {{1, 8}, {2, 16}, {4, 32}, {64, 128}};
        std::map<std::pair<int, int>, std::uint8_t> cells;
        for (const Point& dot : sheet.dots) {
            const int column = static_cast<int>(std::clamp(std::round(dot.x / pitch), 0.0, 2.0 * kMost - 1));
            const int row = static_cast<int>(std::clamp(std::round(dot.y / pitch), 0.0, 4.0 * kMost - 1));
            cells[{row / 4, column / 2}] |= kBits[row % 4][column % 2];
        }
        for (const auto& [place, cell] : cells) {
            lines.resize(std::max(lines.size(), static_cast<std::size_t>(place.first) + 1));
            auto& line = lines[static_cast<std::size_t>(place.first)];
            line.resize(std::max(line.size(), static_cast<std::size_t>(place.second) + 1));
            line[static_cast<std::size_t>(place.second)] = cell;
        }
    }
    std::vector<std::string> text;
    std::size_t used = 0;
    for (const auto& line : lines) {
        text.push_back(unicode_of(line));
        if (!text.back().empty()) used = text.size();
    }
    text.resize(used);
    return text;
}

}  // namespace tactics
