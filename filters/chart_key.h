// SPDX-License-Identifier: Apache-2.0
// The key of a chart, which explains its lines, symbols and letters.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "filters/cell_places.h"
#include "filters/chart_letters.h"
#include "tactics/plot.h"

namespace tactics {

/// A line of the key: a sample of a line or a texture, a symbol, or neither, as the words begin with a letter; then words.
struct ChartKeyEntry {
    std::string text;
    std::optional<std::size_t> style = {};  ///< of line_styles.h
    std::optional<PlotSymbol> symbol = {};
    int texture = 0;  ///< of a sample of what bars are filled with; 0: none
};

/// The words in as many lines as they need, by blanks; a word that alone is wider keeps a line to itself.
std::vector<std::string> lines_within(const std::string& text, double width, const Sheet& sheet);

/// Samples of textures and lines come first, then symbols, then letters (BANA: textures, lines, points). It stands at the bottom
/// of the drawing, in as many columns as fit; words wider than the drawing continue on the next line.
class ChartKey {
public:
    ChartKey(std::vector<ChartKeyEntry> entries, const Sheet& sheet, const CellPlaces& cells, const Clearance& clear,
             double width);

    double height() const;  ///< mm, including the clear space above it
    void draw(Drawing& drawing) const;

private:
    struct Set {
        ChartKeyEntry entry;
        std::vector<LabelBlock> blocks;
        std::vector<std::string> lines;
        double sample = 0;  ///< width of the part before the words
        double height = 0;  ///< its height, if greater than a line of words
    };
    double words_from(const Set& set) const;

    std::vector<Set> sets_;
    const Sheet& sheet_;
    const CellPlaces& cells_;
    Clearance clear_;
    double column_ = 0, between_ = 0, columns_ = 1, rows_ = 0, line_ = 0, pitch_ = 0;
};

}  // namespace tactics
