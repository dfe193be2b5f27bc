// SPDX-License-Identifier: Apache-2.0
// The shape of a letter in a font, to hold what a picture shows against it.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <vector>

#include "tactics/drawing.h"

namespace tactics {

/// A letter as its font has it: closed rings in em, y up from the line that letters stand on, filled by the non-zero rule.
struct FontShape {
    double advance = 0;  ///< em, to the next letter
    std::vector<std::vector<Point>> rings;
};
using FontShapes = std::map<char32_t, FontShape>;

/// A font, of which those letters that were asked for have been read. The others are empty where they are not known.
struct PrintFont {
    FontShapes shapes;
    std::function<FontShapes(const std::vector<char32_t>& codes)> more = {};  ///< further letters
    std::function<FontShapes(const std::vector<char32_t>& codes, double em)> bent =
        {};  ///< as programs bend them to a grid of so many pixels for an em
    std::function<FontShapes(const std::vector<char32_t>& codes)> formula =
        {};  ///< as formulas in that font have them: most are slanted
};

/// Looks at one font after the other, the likely ones first, until `goes_on` says no. The fonts outlive the visit.
using PrintFonts = std::function<void(const std::vector<char32_t>& codes, const std::function<bool(PrintFont)>& goes_on)>;

/// A shape in its original size and, after drawing, as a grid of squares from which the ink in any part can be read at once.
class LetterForm {
public:
    LetterForm() = default;
    explicit LetterForm(const FontShape& shape);
    void draw(const FontShape& shape);  ///< the same one

    bool empty() const { return rows_ == 0; }
    bool drawn() const { return !sums_.empty(); }
    double advance() const { return advance_; }  ///< em, as all of these
    double left() const { return left_; }
    double right() const { return right_; }
    double bottom() const { return bottom_; }  ///< y up
    double top() const { return top_; }
    double width() const { return right_ - left_; }
    double height() const { return top_ - bottom_; }

    /// A place along one side of the grid, for many questions about the same row or column.
    struct Place {
        int square;   ///< the one that it is in
        double part;  ///< of it, that is before it
    };
    Place across(double x) const { return place_of(x, columns_); }  ///< 0 to 1 across its box
    Place down(double y) const { return place_of(y, rows_); }

    /// How much ink is left of x and above y, 0 to 1 across and down its box, as a share of the box. It must have been drawn.
    double ink_before(double x, double y) const { return ink_before(across(x), down(y)); }
    double ink_before(const Place& across, const Place& down) const;

private:
    static Place place_of(double part, int squares);

    double advance_ = 0, left_ = 0, right_ = 0, bottom_ = 0, top_ = 0;
    int columns_ = 0, rows_ = 0;
    std::vector<std::uint32_t> sums_;  // squares of ink left of and above each corner
};

}  // namespace tactics
