// SPDX-License-Identifier: Apache-2.0
// The ink of a line of lettering, letter by letter, measured to parts of a pixel.
#pragma once

#include <algorithm>
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
    /// Pale ink ties each of those units to the next: a letter of thin strokes may have come apart there.
    bool tied(std::size_t first, std::size_t last) const;
    /// From all its pixels, with their darkness.
    double ink() const { return std::accumulate(dark_.begin(), dark_.end(), 0.0); }
    /// It is a straight stroke, such as a dash of a curve; so may be an l.
    bool is_stroke() const;
    bool has_veil() const { return !veil_.empty(); }
    std::size_t veiled_units() const { return static_cast<std::size_t>(std::count(veiled_.begin(), veiled_.end(), true)); }
    /// What is drawn touches one of those units and may hide parts of it.
    bool veiled(std::size_t first, std::size_t last) const;
    /// From the ink of those units and its fading edges only.
    InkBox measure(std::size_t first, std::size_t last) const;

private:
    friend class LetterInk;
    struct Part {
        std::size_t first, last;
    };
    double dark(int x, int y, const Part& part) const;
    bool is_veiled(int x, int y) const {
        return !veil_.empty() && x >= 0 && y >= 0 && x < width_ && y < height_ &&
               veil_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)];
    }
    void tie_units();
    void veil_units();

    int width_ = 0, height_ = 0;
    std::vector<float> dark_;
    std::vector<int> owner_;  // the unit that a pixel is of; -1: none
    std::vector<PixelBox> units_;
    std::vector<bool> tied_;           // to the next one
    std::vector<bool> veil_, veiled_;  // pixels, and units that touch them; empty: there is no veil
};

/// The ink of neighbouring units of a strip, ready to be held against one letter after the other.
class LetterInk {
public:
    /// `box` is what they measure.
    LetterInk(const InkStrip& strip, std::size_t first, std::size_t last, const InkBox& box);

    /// 1: it looks as the letter does when that fills the box; 0: nothing alike, or less alike than `least`, which most letters
    /// are, and which is known long before how much less.
    double likeness(const LetterForm& form, double least = 0);
    /// Of the ink of the letter that it was last held against, what is no part of a veil.
    double seen() const { return seen_; }

private:
    bool may_be(const LetterForm& form, double least);
    double wanted_apart(const LetterForm& form);
    double differing(double most) const;
    std::size_t at(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(x);
    }
    // In a grid with an empty frame around it.
    std::size_t framed(int x, int y) const {
        return static_cast<std::size_t>(y + 1) * static_cast<std::size_t>(columns_ + 2) + static_cast<std::size_t>(x + 1);
    }

    InkBox box_;
    int left_, top_, columns_, rows_;  // pixels around the box
    double area_, all_ink_ = 0, seen_ = 1;
    std::vector<double> is_, in_rows_, in_columns_;  // darkness of pixels, and weighed sums of it
    std::vector<bool> hidden_;                       // pixels that may be of the letter or not; empty: none
    std::vector<double> apart_, wants_;              // what is there more than wanted, in a frame; what is wanted
    std::vector<double> above_, below_;
    std::vector<LetterForm::Place> across_;
};

}  // namespace tactics
