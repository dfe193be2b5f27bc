// SPDX-License-Identifier: Apache-2.0
// The ink of a line of lettering, letter by letter, measured to parts of a pixel.
#pragma once

#include <numeric>
#include <vector>

#include "tactics/lettering/letter_form.h"
#include "tactics/lettering/lines.h"

namespace tactics {

/// Where ink is, in pixels of its strip, y down. Edges that are grey lie within their pixel.
struct InkBox {
    double left = 0, top = 0, right = 0, bottom = 0;
    double width() const { return right - left; }
    double height() const { return bottom - top; }
};

/// Upright, nothing but the line's own ink: 0 for the ground, 1 for the darkest of its ink.
class InkStrip {
public:
    InkStrip(const Image& grey, const LetteringLine& line);

    /// From the left to the right: pieces of ink, those above each other as one, as the dot of an i is.
    std::size_t units() const { return units_.size(); }
    /// From all its pixels, with their darkness.
    double ink() const { return std::accumulate(dark_.begin(), dark_.end(), 0.0); }
    /// From the ink of those units and its fading edges only.
    InkBox measure(std::size_t first, std::size_t last) const;
    /// 1: the ink of those units looks as the letter does when it fills that box; 0: nothing alike.
    double likeness(std::size_t first, std::size_t last, const InkBox& box, const LetterForm& form) const;

private:
    struct Part {
        std::size_t first, last;
    };
    double dark(int x, int y, const Part& part) const;

    int width_ = 0, height_ = 0;
    std::vector<float> dark_;
    std::vector<int> owner_;  // the unit that a pixel is of; -1: none
    std::vector<PixelBox> units_;
};

}  // namespace tactics
