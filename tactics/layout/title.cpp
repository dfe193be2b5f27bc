// SPDX-License-Identifier: Apache-2.0
#include "tactics/layout/title.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "tactics/braille/braille.h"
#include "tactics/error.h"
#include "tactics/layout/sheet.h"
#include "tactics/text/utf8.h"

namespace tactics {

namespace {

// Longer than any title; it keeps the translation bounded.
constexpr std::size_t kLongestTitle = 10'000;  // bytes

// 14 pt is read at arm's length over the shoulder of the reader; below 8 pt print is not read any more.
constexpr double kTitlePrintSize = 4.94;  // mm
constexpr double kSmallPrint = 2.82;      // mm
// Lines closer than 6 mm are hard to tell apart (BRI, APH guide); the same keeps braille clear of what stands near it.
constexpr double kClearOfTitle = 6.0;  // mm

constexpr char32_t kEllipsis = 0x2026;  // where a line is cut

// No letter of DejaVu Sans is wider than this, in em.
double widest(char32_t letter) {
    constexpr std::string_view kNarrow = "fijlrtI .,:;'!|()[]-/\\`";
    constexpr std::string_view kWide = "mwMWOQ@%&+<>=~^_#\"";
    if (letter >= 0x2000) return letter < 0x2070 ? 1.0 : 1.4;
    if (letter >= 0x80) return 1.15;
    const char c = static_cast<char>(letter);
    if (kNarrow.find(c) != std::string_view::npos) return 0.42;
    if (kWide.find(c) != std::string_view::npos) return 1.0;
    return c >= 'A' && c <= 'Z' ? 0.8 : 0.66;
}

// One line: smaller print if it must be, and if that does not do, the rest is left out.
PrintLine print_line(const std::string& text, const Rect& live) {
    PrintLine line{{live.left, 0}, kTitlePrintSize, text};
    const double width = print_width(text);
    if (width * kTitlePrintSize > live.width) line.size = std::max(kSmallPrint, live.width / width);
    if (width * line.size > live.width) {
        const double room = live.width / line.size - widest(kEllipsis);
        line.text.clear();
        double used = 0;
        for (std::string_view rest = text; !rest.empty();) {
            const char32_t letter = take_letter(rest);
            used += widest(letter);
            if (used > room) break;
            append_letter(line.text, letter);
        }
        append_letter(line.text, kEllipsis);
    }
    line.baseline.y = live.top + kAscent * line.size;
    return line;
}

}  // namespace

bool shows(const PrintLine& line, std::string_view text) {
    std::string cut;
    append_letter(cut, kEllipsis);
    std::string_view shown = line.text;
    if (shown.ends_with(cut)) shown.remove_suffix(cut.size());
    return !shown.empty() && text.starts_with(shown);
}

double print_width(std::string_view text) {
    double width = 0;
    while (!text.empty()) width += widest(take_letter(text));
    return width;
}

Title title_of(const Sheet& sheet) {
    if (sheet.title.size() > kLongestTitle)
        throw Error(Fault::usage, sheet.title_origin, phrase("the title is over 10000 bytes long; give a short one"));
    Title title{to_line(sheet.title), {}};
    if (!title.text.empty() && !sheet.bare && sheet.title_cells == 0 && !sheet.braille_table.empty())
        title.cells = to_braille(title.text, sheet.braille_table, sheet.title_origin);
    if (sheet.caption.size() > kLongestTitle)
        throw Error(Fault::usage, spelled("caption"), phrase("the caption is over 10000 bytes long; shorten it"));
    title.caption = to_line(sheet.caption);
    if (!title.caption.empty() && !sheet.bare && !sheet.braille_table.empty())
        title.caption_cells = to_braille(title.caption, sheet.braille_table, spelled("caption"));
    if (!title.cells.empty()) title.division = division_in(sheet, title.text);
    if (!title.caption_cells.empty()) title.caption_division = division_in(sheet, title.caption);
    return title;
}

namespace {

using Cells = std::vector<std::uint8_t>;

// Lines of braille, the first with `first` blank cells before it, the others with `runover`.
std::vector<Cells> indented(const Cells& cells, std::size_t most, std::size_t first, std::size_t runover,
                            const WordDivision& division) {
    if (most <= first) return wrapped(cells, most, division);  // no room to set it in
    std::vector<Cells> lines;
    for (const Cells& part : wrapped(cells, most - runover, division, first - runover)) {
        Cells line(lines.empty() ? first : runover, 0);
        line.insert(line.end(), part.begin(), part.end());
        lines.push_back(std::move(line));
    }
    return lines;
}

}  // namespace

TitleBand set_title(const Title& title, const Sheet& sheet, const Rect& live) {
    // Captions begin in cell 7, before what they are about (PreFigure has "per BANA": medium confidence) and run over to
    // cell 5, as braille formats have it ("7-5").
    constexpr std::size_t kCaptionFrom = 6, kCaptionRunover = 4;
    TitleBand band;
    if (sheet.bare) return band;
    const double clear = std::max(kClearOfTitle, sheet.medium->gap), dot = sheet.cell.dot;
    const double cells = (live.width - dot - sheet.cell.dot_pitch) / sheet.cell.cell_pitch;
    const auto most = static_cast<std::size_t>(std::max(0.0, std::floor(cells + 1e-9))) + 1;
    double y = live.top;
    int words = -1;
    const auto add = [&](const std::string& text, std::vector<Cells> lines) {
        if (text.empty()) return;
        ++words;
        if (sheet.print_title) {
            PrintLine line = print_line(text, live);
            line.words = words;
            line.baseline.y += y - live.top;
            y += (kAscent + kDescent) * line.size + clear;
            band.print.push_back(std::move(line));
        }
        bool eight_dots = false;
        for (std::size_t i = 0; i < lines.size(); ++i) {
            eight_dots = eight_dots || *std::max_element(lines[i].begin(), lines[i].end()) > 0x3F;
            const double top = y + static_cast<double>(i) * sheet.cell.line_pitch;
            band.braille.push_back({{live.left + dot / 2, top + dot / 2}, std::move(lines[i]), words});
        }
        if (!lines.empty())
            y += static_cast<double>(lines.size() - 1) * sheet.cell.line_pitch + (eight_dots ? 3 : 2) * sheet.cell.dot_pitch +
                 dot + clear;
    };
    // At the left edge, runover too: the reading hand looks for the title in the corner, however wide the sheet.
    add(title.text, wrapped(title.cells, most, title.division));
    add(title.caption, title.caption_cells.empty()
                           ? std::vector<Cells>()
                           : indented(title.caption_cells, most, kCaptionFrom, kCaptionRunover, title.caption_division));
    // Half of the widest line stands above the drawing's own edge.
    if (y > live.top) band.height = y - live.top + sheet.medium->thick_line / 2;
    return band;
}

}  // namespace tactics
