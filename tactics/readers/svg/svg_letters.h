// SPDX-License-Identifier: Apache-2.0
// Letters that a file has as shapes, to be used where they stand: so do cairo (and with it R and graphviz), poppler, dvisvgm,
// MuPDF and MathJax write them. They are words and no lines.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "tactics/readers/svg/found_page.h"
#include "tactics/readers/svg/transform.h"
#include "tactics/readers/xml.h"

namespace tactics {

/// What these makers call the shape of a letter: "glyph0-3", "glyph-0-3", "g2-117", "font_1_25", "MJX-1-TEX-I-1D465".
bool names_letter(std::string_view id);

/// The letters of a figure, gathered as they are used.
class DrawnLetters {
public:
    /// `shape` is used at `place`, which gives mm. `group` is what letters of one line have in common. `code` is what `use` says
    /// of it in hexadecimal digits, as MathJax does; empty: nothing.
    void add(const Element& shape, std::string_view name, std::string_view code, const Transform& place, const Element* group);

    /// Lines of letters become words that say nothing yet. Letters of a formula that are not on one line are one piece.
    void settle(FoundPage& figure) const;

private:
    struct Use {
        std::size_t shape;
        Transform place;
        const Element* group;
    };
    std::size_t end_of_group(std::size_t from) const;
    std::size_t end_of_line(std::size_t from) const;
    std::map<std::string, Point> turn_upright(std::vector<LetterShape>& shapes) const;

    std::map<const Element*, std::size_t> known_;
    std::vector<LetterShape> shapes_;
    std::vector<Use> uses_;
};

}  // namespace tactics
