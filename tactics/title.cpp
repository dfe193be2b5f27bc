#include "tactics/title.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "tactics/braille.h"
#include "tactics/error.h"
#include "tactics/utf8.h"

namespace tactics {

namespace {

// Longer than any title; it keeps the translation bounded.
constexpr std::size_t kLongestTitle = 10'000;  // bytes

// 14 pt is read at arm's length over the shoulder of the reader; below 8 pt print is not read any more.
constexpr double kPrintSize = 4.94;   // mm
constexpr double kSmallPrint = 2.82;  // mm
// Lines closer than 6 mm are hard to tell apart (BRI, APH guide); the same keeps braille clear of what stands near it.
constexpr double kClear = 6.0;  // mm

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
    PrintLine line{{live.left, 0}, kPrintSize, text};
    const double width = print_width(text);
    if (width * kPrintSize > live.width) line.size = std::max(kSmallPrint, live.width / width);
    if (width * line.size > live.width) {
        constexpr char32_t kEllipsis = 0x2026;
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

double print_width(std::string_view text) {
    double width = 0;
    while (!text.empty()) width += widest(take_letter(text));
    return width;
}

std::vector<std::vector<std::uint8_t>> wrapped(const std::vector<std::uint8_t>& cells, std::size_t most) {
    std::vector<std::vector<std::uint8_t>> lines;
    std::size_t at = 0;
    while (true) {
        while (at < cells.size() && cells[at] == 0) ++at;
        if (at == cells.size()) return lines;
        std::size_t end = std::min(cells.size(), at + most);
        if (end < cells.size() && cells[end] != 0) {
            std::size_t blank = end;
            while (blank > at && cells[blank - 1] != 0) --blank;
            if (blank > at) end = blank;
        }
        const std::size_t next = end;
        while (end > at && cells[end - 1] == 0) --end;
        lines.emplace_back(cells.begin() + static_cast<std::ptrdiff_t>(at), cells.begin() + static_cast<std::ptrdiff_t>(end));
        at = next;
    }
}

Title title_of(const Sheet& sheet) {
    if (sheet.title.size() > kLongestTitle)
        throw Error(Fault::usage, sheet.title_origin, "the title is over 10000 bytes long; give a short one");
    Title title{to_line(sheet.title), {}};
    if (!title.text.empty() && !sheet.bare && !sheet.braille_table.empty())
        title.cells = to_braille(title.text, sheet.braille_table, sheet.title_origin);
    return title;
}

TitleBand set_title(const Title& title, const Sheet& sheet, const Rect& live) {
    TitleBand band;
    if (title.text.empty() || sheet.bare) return band;
    const double clear = std::max(kClear, sheet.medium->gap);
    double y = live.top;
    if (sheet.print_title) {
        band.print.push_back(print_line(title.text, live));
        y += (kAscent + kDescent) * band.print.front().size + clear;
    }
    if (!title.cells.empty()) {
        // At the left edge, runover too: the reading hand looks for the title in the corner, however wide the sheet.
        const double dot = sheet.cell.dot;
        const double room = (live.width - dot - sheet.cell.dot_pitch) / sheet.cell.cell_pitch;
        const auto most = static_cast<std::size_t>(std::max(0.0, std::floor(room + 1e-9))) + 1;
        const bool eight_dots = *std::max_element(title.cells.begin(), title.cells.end()) > 0x3F;
        const double cell_height = (eight_dots ? 3 : 2) * sheet.cell.dot_pitch + dot;
        auto lines = wrapped(title.cells, most);
        for (std::size_t i = 0; i < lines.size(); ++i) {
            const double top = y + static_cast<double>(i) * sheet.cell.line_pitch;
            band.braille.push_back({{live.left + dot / 2, top + dot / 2}, std::move(lines[i])});
        }
        if (!lines.empty()) y += static_cast<double>(lines.size() - 1) * sheet.cell.line_pitch + cell_height + clear;
    }
    // Half of the widest line stands above the drawing's own edge.
    if (y > live.top) band.height = y - live.top + sheet.medium->thick_line / 2;
    return band;
}

}  // namespace tactics
