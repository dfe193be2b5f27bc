// SPDX-License-Identifier: Apache-2.0
// Shrinks a picture while it is read, with only one row in memory.
#pragma once

#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace tactics {

struct Size {
    int width = 0;
    int height = 0;
};

/// The size with the longer side at most `longest` (0 = any) and the shape kept to within half a pixel; at least 1 x 1.
Size shrunk_size(Size size, int longest);

/// Area averaging: an output pixel is the mean of the input that it covers, a pixel on its border counting by its share.
/// For 8-bit samples the mean is exact and rounded to nearest, half up; float samples are summed in double precision.
template <class Sample>
class RowShrinker {
public:
    /// Rows of from.width pixels, from.height of them; samples are interleaved, `channels` a pixel. `to` is not larger.
    RowShrinker(Size from, Size to, int channels) : RowShrinker(from, to, channels, {8 * from.width, 8 * from.height}) {}

    /// The same when the picture fills only a part of the last column and row, as after a reduction to N/8: it is
    /// `eighths` of a pixel large, which is more than 8 * (from - 1) and at least 8 * to.
    RowShrinker(Size from, Size to, int channels, Size eighths);

    /// The next row, from the top.
    void add(const Sample* row);

    /// The rows that are complete. Grows as rows are added, so a file that claims to be large and is not costs little.
    std::vector<Sample> take() { return std::move(pixels_); }

private:
    using Sum = std::conditional_t<std::is_same_v<Sample, float>, double, std::uint32_t>;

    /// The part of a row that makes an output pixel: a part of `first`, then whole pixels, then a part of the next one.
    struct Cover {
        std::uint32_t first, whole;
        std::uint32_t first_parts, last_parts;
    };

    void find_covers();
    void emit();

    Size from_, to_;
    int channels_;
    std::uint32_t width_parts_, pixel_parts_x_;   // an output pixel is width_parts_ wide, an input pixel pixel_parts_x_
    std::uint32_t height_parts_, pixel_parts_y_;  // the same downwards
    std::uint32_t filled_ = 0;                    // how much of the current output row is summed, in parts
    std::vector<Cover> covers_;                   // of each output pixel of a row
    std::vector<Sum> sums_;
    std::vector<Sample> pixels_;
};

extern template class RowShrinker<std::uint8_t>;
extern template class RowShrinker<float>;

}  // namespace tactics
