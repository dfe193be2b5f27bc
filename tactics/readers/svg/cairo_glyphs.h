// SPDX-License-Identifier: Apache-2.0
// The letters that cairo drew into an SVG, by where they stand, and which of them somebody has words for.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tactics/page.h"

namespace tactics {

/// Lengths are the SVG's own, which in that of a PDF are points. What is no letter in the way that cairo writes it is passed
/// over.
class CairoGlyphs {
public:
    /// `svg` must outlive it.
    explicit CairoGlyphs(std::string_view svg);

    /// Takes the letters of a word; gives the line on which they stand, if it has any.
    std::optional<double> take(const Rect& word);
    /// Whether a letter in it belongs to a line that runs neither across nor up nor down, of which boxes tell little.
    bool are_slanted(const Rect& word) const;
    /// Takes the black bar before a number that is its minus: some programs draw it, as their fonts have none. `size` is that of
    /// the letters, `base` the line on which they stand.
    bool take_minus(const Rect& number, double size, std::optional<double> base);

    /// The SVG without what was taken, and with `more` at its end.
    std::string without_taken(std::string_view more) const;

private:
    struct Piece {
        std::size_t begin = 0, end = 0;  // in the SVG
        Rect box;                        // of a letter the place where it stands
        bool slanted = false, taken = false;
    };
    void find_letters();
    void find_bars();
    template <typename Use>
    void each_in(const Rect& word, const Use& use) const;

    std::string_view svg_;
    std::vector<Piece> letters_, bars_;  // from the top downwards
};

/// How many lines and surfaces such an SVG has that are neither letters nor white: those of its ground.
std::size_t drawn_in(std::string_view svg);

}  // namespace tactics
