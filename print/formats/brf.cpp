// BRF, the text format that every embosser and braille display takes: one letter a cell (North American Braille
// Computer Code), CR LF after a line, form feed after a page.
//
// The page has as many cells and lines as its live area holds: 45 x 28 on 11 x 11.5 in paper with margins of 6 mm. The
// embosser must be set to at least as many cells and lines, and to single-sided and uncontracted (no translation).
#include <cmath>

#include "print/dots.h"
#include "print/format.h"
#include "tactics/braille.h"

namespace tactics {

namespace {

std::string encode(const Page& page, const Settings&) {
    const DotGrid grid = cell_grid(page.live, page.cell);
    const Dots dots = raise_dots(page, grid);
    const std::size_t width = grid.columns.size() / 2, height = grid.rows.size() / 3;

    std::vector<std::uint8_t> cells(width * height);
    for (int row = 0; row < dots.rows; ++row)
        for (int column = 0; column < dots.columns; ++column)
            if (dots.at(column, row) != 0)
                cells[static_cast<std::size_t>(row / 3) * width + static_cast<std::size_t>(column / 2)] |=
                    static_cast<std::uint8_t>(1u << (row % 3 + column % 2 * 3));

    // Text is set as whole cells, not by its dots, and in place of the drawing: a cell of both would say something else.
    for (const BrailleLine& line : page.braille) {
        const double row = std::round((line.first_dot.y - grid.rows[0]) / page.cell.line_pitch);
        if (!(row >= 0) || row >= static_cast<double>(height)) continue;
        const double first = std::round((line.first_dot.x - grid.columns[0]) / page.cell.cell_pitch);
        for (std::size_t i = 0; i < line.cells.size(); ++i) {
            const double column = first + static_cast<double>(i);
            if (column >= 0 && column < static_cast<double>(width))
                cells[static_cast<std::size_t>(row) * width + static_cast<std::size_t>(column)] = line.cells[i] & 0x3Fu;
        }
    }

    std::string text;
    std::size_t end = 0;  // after the last line that has a dot
    for (std::size_t y = 0; y < height; ++y) {
        std::string line;
        for (std::size_t x = 0; x < width; ++x) line += brf_letter(cells[y * width + x]);
        line.erase(line.find_last_not_of(' ') + 1);
        text += line + "\r\n";
        if (!line.empty()) end = text.size();
    }
    text.resize(end);
    return text + '\f';
}

std::string encode_pages(std::span<const Page> pages, const Settings& settings) {
    std::string text;
    for (const Page& page : pages) text += encode(page, settings);
    return text;
}

}  // namespace

extern const Format brf_format;
const Format brf_format{
    .name = "brf",
    .summary = "braille text with a drawing of 6-dot cells, for any embosser",
    .extensions = "brf",
    .medium = "embosser",
    .paper = "11x11.5",
    .options = {},
    .encode = encode,
    .encode_pages = encode_pages,
};

}  // namespace tactics
