// SPDX-License-Identifier: Apache-2.0
// Where something lies, in words.
#pragma once

#include <cstddef>

#include "tactics/page.h"
#include "tactics/text/phrase.h"

namespace tactics {

/// Which ninth of the page, or of its drawing.
class Ninths {
public:
    enum class Frame { page, drawing };
    Ninths(const Rect& frame, Frame of_what = Frame::page) : frame_(frame), of_what_(of_what) {}

    std::size_t of(Point p) const;
    std::size_t of(const Rect& box) const { return of(Point{box.left + box.width / 2, box.top + box.height / 2}); }

    Phrase place(const Rect& box) const;          ///< "in the upper left"
    Phrase place(Point p) const;                  ///< the same
    Phrase place_on_page(const Rect& box) const;  ///< "in the upper left of the page"
    /// It reaches over so much of a line of ninths that a straight line along it needs no other words.
    bool spans(const Rect& box) const;
    /// Of a line from end to end, told in reading order: "from the upper left to the middle".
    Phrase course(Point a, Point b) const;

private:
    bool wide(const Rect& box) const;
    bool high(const Rect& box) const;

    Rect frame_;
    Frame of_what_;
};

/// A ninth by its name: "the upper left".
Phrase name_of_ninth(std::size_t ninth);

}  // namespace tactics
