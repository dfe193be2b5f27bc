// SPDX-License-Identifier: Apache-2.0
// The letters that cairo drew into an SVG, by where they stand, and which of them somebody has words for.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tactics/page.h"

namespace tactics {

enum class LineRuns { across, upwards, downwards };

/// Of a page on which too much lies in one row, what is looked at last is left as it is drawn. Lengths are the SVG's own, which
/// in that of a PDF are points. What is no letter in the way that cairo writes it is passed over.
class CairoGlyphs {
public:
    /// `svg` must outlive it.
    explicit CairoGlyphs(std::string_view svg);

    /// Letters that begin in that box and belong to nobody yet are those of a word: smaller words are to be asked for first, as
    /// boxes of exponents lie within those of what they stand behind. Gives the letters.
    std::vector<std::size_t> claim(const Rect& word);
    /// Where the line is on which they stand: its y, or its x if it runs up or down. Of at least one.
    double base_of(const std::vector<std::size_t>& letters, LineRuns runs = LineRuns::across) const;
    /// Whether one of them belongs to a line that runs neither across nor up nor down, of which boxes tell little.
    bool are_slanted(const std::vector<std::size_t>& letters) const;
    /// They go, as words stand for them.
    void take(const std::vector<std::size_t>& letters);

    /// Takes the black bar before a number that is its minus: some programs draw it, as their fonts have none. `size` is that of
    /// the letters, `base` the line on which they stand.
    bool take_minus(const Rect& number, double size, double base);

    /// Shapes that stand on the line of these letters as one of them would, within `line` or hard beside it: letters that a
    /// program drew, as its font has none. They become letters among the others, for who reads shapes; gives whether there are
    /// any.
    bool adopt_shapes(const std::vector<std::size_t>& letters, const Rect& line, LineRuns runs, double size);

    /// Whether such a shape stands between two words on that line.
    bool has_shape_between(const Rect& word, const Rect& next, const std::vector<std::size_t>& letters, LineRuns runs,
                           double size);

    /// The SVG without what was taken, with letters where shapes were adopted, and with `more` at its end.
    std::string without_taken(std::string_view more) const;

private:
    struct Piece {
        std::size_t begin = 0, end = 0;  // in the SVG
        Rect box;                        // of a letter the place where it stands
        std::string_view font = {};      // of a letter
        bool slanted = false, claimed = false, taken = false;
    };
    void find_letters();
    void find_shapes();
    bool is_bar(const Piece& shape, double size) const;
    template <typename Visit>
    bool any_from(std::vector<Piece>& pieces, double least, double most, const Visit& visit);
    void adopt(Piece& shape, const std::vector<std::size_t>& letters, LineRuns runs, double base);

    std::string_view svg_;
    std::vector<Piece> letters_, shapes_;  // from the top downwards
    std::map<std::pair<std::size_t, double>, std::string>
        behind_;           // what is put in there: by place in the SVG, then along the line
    std::string symbols_;  // of adopted shapes
    std::size_t adopted_ = 0;
    std::size_t looked_ = 0;  // at pieces
};

/// Whether that is the number of a letter that was a shape.
bool is_adopted(std::string_view number);

/// How many lines and surfaces such an SVG has that are neither letters nor white: those of its ground.
std::size_t drawn_in(std::string_view svg);

}  // namespace tactics
