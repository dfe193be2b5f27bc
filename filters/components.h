// SPDX-License-Identifier: Apache-2.0
// Connected pieces of a picture: specks, holes, ridges. Found in two passes, without a picture of labels.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace tactics {

/// Set pixels [begin, end) of one row.
struct Run {
    int row = 0;
    int begin = 0;
    int end = 0;
    std::uint32_t component = 0;

    std::size_t length() const { return static_cast<std::size_t>(end - begin); }
};

/// Connectivity of pixels: ink also by corners, its holes only by sides, so that a line separates its two sides.
enum class Joined { by_sides, by_corners };

struct Components {
    std::vector<Run> runs;  ///< row by row, left to right
    std::uint32_t count = 0;

    std::vector<std::size_t> areas() const;    ///< pixels of each component
    std::vector<std::size_t> extents() const;  ///< longer side of each component's rectangle, in pixels
};

/// Gives every run the number of its component, numbered in the order of their first runs. Linear in the runs, nearly.
Components join_runs(std::vector<Run> runs, Joined joined);

/// `is_set(index)` for index = y * width + x.
template <typename IsSet>
Components find_components(int width, int height, Joined joined, IsSet is_set) {
    std::vector<Run> runs;
    std::size_t index = 0;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width;) {
            while (x < width && !is_set(index)) ++x, ++index;
            const int begin = x;
            while (x < width && is_set(index)) ++x, ++index;
            if (x > begin) runs.push_back({y, begin, x, 0});
        }
    }
    return join_runs(std::move(runs), joined);
}

/// Hysteresis (J. Canny 1986): the runs of pixels that `may_be` set and hang together, by corners too, with one that `is_sure`.
template <typename IsSure, typename MayBe>
std::vector<Run> connected_to(int width, int height, IsSure is_sure, MayBe may_be) {
    Components pieces = find_components(width, height, Joined::by_corners, may_be);
    std::vector<bool> sure(pieces.count, false);
    for (const Run& run : pieces.runs)
        for (int x = run.begin; x < run.end && !sure[run.component]; ++x)
            sure[run.component] =
                is_sure(static_cast<std::size_t>(run.row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x));
    std::erase_if(pieces.runs, [&](const Run& run) { return !sure[run.component]; });
    return std::move(pieces.runs);
}

}  // namespace tactics
