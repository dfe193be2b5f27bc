// SPDX-License-Identifier: Apache-2.0
// One-to-one matching of the pixels of two line maps, none farther apart than a finger's or an eye's tolerance.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace tactics {

/// Some pixels of a map, each as y * width + x, ascending.
struct PixelSet {
    int width = 0;
    int height = 0;
    std::vector<std::uint32_t> pixels;
};

/// The maximum number of pairs of a pixel of `truth` and a pixel of the lines at most `reach` pixels away, with each pixel in at
/// most one pair. If the lines change, the search continues from the pairs that are still possible, so that growing lines cost
/// little more than their last state alone.
class Matching {
public:
    Matching(const PixelSet& truth, double reach);

    /// From now on these are the lines, on a map of the truth's size.
    void match(const PixelSet& lines);

    std::size_t pairs() const { return pairs_; }
    bool has_pair(std::uint32_t line_pixel) const;

private:
    static constexpr std::int32_t kNone = -1;

    struct Line {
        std::uint32_t pixel = 0;
        std::int32_t partner = kNone;  // index of a truth pixel
        bool present = false;
        std::uint32_t first = 0, end = 0;  // its truth pixels within reach, in near_
    };
    struct Near {
        std::int32_t truth = kNone;
        int square = 0;  // of the distance
    };
    struct Offset {
        int x = 0, y = 0, square = 0;
    };

    std::int32_t line_of(std::uint32_t pixel);
    bool leave(const PixelSet& lines);
    void pair_nearest(std::vector<std::int32_t> waiting);
    void pair(std::int32_t line, std::int32_t truth);
    void find_partner(std::int32_t line);
    void lead_back(std::int32_t truth, std::int32_t start);

    int width_ = 0, height_ = 0;
    std::vector<Offset> offsets_;         // nearest first
    std::vector<std::int32_t> truth_at_;  // index of the truth pixel at each pixel of the map
    std::vector<std::int32_t> line_at_;   // the same for the line pixels
    std::vector<Line> lines_;             // all that ever were
    std::vector<std::int32_t> present_;   // those that are
    std::vector<Near> near_;
    // Of each truth pixel:
    std::vector<std::int32_t> owner_;         // the line pixel that it is paired with
    std::vector<std::uint8_t> closed_;        // no search from here finds a truth pixel without a pair
    std::vector<std::int32_t> reached_from_;  // in the search at hand: the line pixel before it
    std::size_t pairs_ = 0;
};

}  // namespace tactics
