// SPDX-License-Identifier: Apache-2.0
// The part that all readers share: takes the rows of a file and makes the requested picture.
#pragma once

#include <cstdint>
#include <vector>

#include "tactics/readers/read.h"
#include "tactics/readers/shrink.h"

namespace tactics {

enum class Alpha { none, straight, premultiplied };

/// The form of a file's rows: 1 (grey) or 3 (red green blue) samples per pixel, then alpha if there is one.
struct RowShape {
    Size size;
    int colours = 1;
    Alpha alpha = Alpha::none;
    int orientation = 1;  ///< EXIF, see upright.h

    int channels() const { return colours + (alpha == Alpha::none ? 0 : 1); }
};

/// Lays alpha over white, makes grey, shrinks, turns upright; all but the last while the rows come.
///
/// Samples of 8 bits are sRGB-coded, and so is all arithmetic on them. Float samples are linear light: they are averaged
/// as such and coded at the end (see `white_of`); what is not finite counts as 0.
template <class Sample>
class RowReceiver {
public:
    RowReceiver(const RowShape& shape, const ReadRequest& request)
        : RowReceiver(shape, request, shrunk_size(shape.size, request.longest), {8 * shape.size.width, 8 * shape.size.height}) {}

    /// For rows that are already reduced to N/8: the result is `to`; `eighths` as RowShrinker has it.
    RowReceiver(const RowShape& shape, const ReadRequest& request, Size to, Size eighths);

    void add(const Sample* row);  ///< size.width * channels() samples
    Image finish();               ///< after size.height rows

private:
    RowShape shape_;
    int channels_;  ///< that the shrinker gets
    bool colour_;
    Size to_;
    RowShrinker<Sample> shrinker_;
    std::vector<Sample> row_;
};

extern template class RowReceiver<std::uint8_t>;
extern template class RowReceiver<float>;

/// The linear value that is shown as white. It is 1 as the formats define it, unless that would make the picture nearly
/// black or blow it out: when in 99 % of the pixels the brightest colour is below 1/4, or in over 1 % it is above 2, it is
/// that 99th percentile. `samples` has `channels` a pixel, the first 1 or 3 of which are colours.
float white_of(const std::vector<float>& samples, int channels, int colours);

/// A linear value as an 8-bit sRGB sample (IEC 61966-2-1), clamped and rounded.
std::uint8_t srgb_coded(float linear);

}  // namespace tactics
