// SPDX-License-Identifier: Apache-2.0
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

/// A dark rectangle on a background, whose outline that many people drew, as in the benchmark: on the pixels that differ from the
/// next to the right or below.
class OutlinedRectangle {
public:
    static constexpr int kWidth = 400, kHeight = 300, kLeft = 100, kTop = 80, kRight = 300, kBottom = 220;

    explicit OutlinedRectangle(int people) {
        std::filesystem::create_directories(folder / "set/images");
        std::filesystem::create_directories(folder / "set/gt");
        write_bytes(folder / "set/images/a.png", png(kWidth, kHeight, inside));
        for (int i = 1; i <= people; ++i) add_person(i, outline);
    }

    /// `drawn` says which pixels.
    void add_person(int number, const std::function<bool(int, int)>& drawn) {
        write_bytes(folder / ("set/gt/a_gt" + std::to_string(number) + ".png"),
                    png(kWidth, kHeight, [&](int x, int y) { return !drawn(x, y); }));
    }

    static bool inside(int x, int y) { return x >= kLeft && x < kRight && y >= kTop && y < kBottom; }
    static bool outline(int x, int y) {
        const bool here = inside(x, y);
        return inside(x + 1, y) != here || inside(x, y + 1) != here || inside(x + 1, y + 1) != here;
    }

    Ending study(const std::string& name, Words words) {
        words.insert(words.begin(), {"evaluate", "set", "--study", name});
        return run_tactics(folder, words);
    }

    Folder folder;
};

}  // namespace tactics::tests
