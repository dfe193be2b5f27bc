// SPDX-License-Identifier: Apache-2.0
// Nippon Telesoft, as counted lines of text.
#include <algorithm>

#include "print/cell_rows.h"
#include "print/embosser.h"
#include "print/format.h"
#include "print/machines/machines.h"
#include "print/sides.h"
#include "print/text_job.h"

namespace tactics {

namespace {

using namespace std::string_view_literals;

constexpr ProtocolFact kNipponFacts[] = {
    {"a job is 01h 00h 00h, its pages with 0Ch between them, and 03h; a page is 02h 01h, the number of its lines, and the "
     "lines; a line is a byte that counts its letters and the CR LF after them, then the letters, then CR LF",
     "libembosser 1.4.3 PEF2Nippon and its tests; no second source was found, and libembosser itself offers no machine for it",
     Confidence::uncertain},
    {"letters are North American Braille Computer Code", "libembosser 1.4.3 PEF2Nippon", Confidence::uncertain},
    {"on both sides, a last front gets an empty back; no command selects both sides: set the machine by hand",
     "libembosser 1.4.3 PEF2Nippon, duplexPagesJoiner", Confidence::uncertain},
    {"cells are 6 mm wide, lines 10 mm high", "this project: Marburg Medium", Confidence::uncertain},
};

constexpr Option kNipponOptions[] = {kSides};

DotSetting nippon_dots(const Settings&) { return {kMarburgMedium, DotBed{{6.8, 6.8}, 0, 3}}; }

constexpr std::size_t kMost = 255;  // that a byte counts

std::string bytes_of(const Page& page) {
    const CellRows rows = cell_rows(page);
    const std::size_t lines = std::min(kMost, lines_used(rows));
    std::string bytes = "\x02\x01";
    bytes += static_cast<char>(lines);
    for (std::size_t i = 0; i < lines; ++i) {
        const auto cells = without_end(rows.line(i));
        const std::size_t letters = std::min(kMost - 2, cells.size());
        bytes += static_cast<char>(letters + 2);
        for (const std::uint8_t cell : cells.first(letters)) bytes += nabcc_letter(cell);
        bytes += "\r\n";
    }
    return bytes;
}

std::string encode_pages_nippon(std::span<const Page> pages, const Settings& settings) {
    std::string bytes("\x01\0\0"sv);
    for (const Page& page : pages) bytes += (&page == pages.data() ? "" : "\f") + bytes_of(page);
    if (on_both(settings) && pages.size() % 2 != 0) bytes += "\f\x02\x01\0"sv;
    return bytes + "\x03";
}

constexpr Embosser kNipponEmbosser{
    .models = "Nippon Telesoft",
    .called = "nippon-telesoft",
    .known_by = "nippon",
    .punch = punch_nippon,
    .facts = kNipponFacts,
};

}  // namespace

extern const Format nippon_format;
const Format nippon_format{
    .name = "nippon",
    .summary = "Nippon Telesoft, in cells",
    .medium = "embosser",
    .paper = "a4",
    .options = kNipponOptions,
    .encode_pages = encode_pages_nippon,
    .embosser = &kNipponEmbosser,
    .dots = nippon_dots,
};

}  // namespace tactics
