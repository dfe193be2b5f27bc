// `tactics evaluate` as the user meets it: the real program on small pictures that are made up.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "print/one_bit_png.h"
#include "tests/cli/tool.h"

namespace tactics::tests {

/// A PNG of black and white.
inline std::string png(int width, int height, const std::function<bool(int, int)>& black) {
    OneBitPng file(width, height, 0, 0);
    std::vector<std::uint8_t> row((static_cast<std::size_t>(width) + 7) / 8);
    for (int y = 0; y < height; ++y) {
        std::fill(row.begin(), row.end(), std::uint8_t{0});
        for (int x = 0; x < width; ++x)
            if (black(x, y)) row[static_cast<std::size_t>(x / 8)] |= static_cast<std::uint8_t>(0x80 >> (x % 8));
        file.add_row(row.data());
    }
    return file.finish();
}

/// A recipe that only cuts, and more words behind it.
inline const Words kCut{"-f", "threshold method=fixed level=128"};
inline Words cut_and(Words words) {
    words.insert(words.begin(), kCut.begin(), kCut.end());
    return words;
}

}  // namespace tactics::tests
