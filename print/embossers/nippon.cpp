// SPDX-License-Identifier: Apache-2.0
// Nippon Telesoft, as counted lines of text.
#include <algorithm>

#include "print/cell_rows.h"
#include "print/embosser.h"
#include "print/format.h"
#include "print/machines/machines.h"
#include "print/text_job.h"

namespace tactics {

namespace {

constexpr ProtocolFact kFacts[] = {
    {"a page is 02h 01h and the number of its lines; a line is its length, its letters, CR LF", "libembosser Nippon driver",
     Confidence::uncertain},
    {"letters are North American Braille Computer Code", "libembosser", Confidence::uncertain},
    {"cells are 6 mm wide, lines 10 mm high", "this project: Marburg Medium", Confidence::uncertain},
};

DotSetting dots(const Settings&) { return {kMarburgMedium, DotBed{{6.8, 6.8}, 0, 3}}; }

std::string encode_pages(std::span<const Page> pages, const Settings&) {
    std::string bytes;
    for (const Page& page : pages) {
        const CellRows rows = cell_rows(page);
        const std::size_t lines = std::min<std::size_t>(255, lines_used(rows));
        bytes += std::string("\x02\x01") + static_cast<char>(lines);
        for (std::size_t i = 0; i < lines; ++i) {
            const auto cells = without_end(rows.line(i)).first(std::min<std::size_t>(255, without_end(rows.line(i)).size()));
            bytes += static_cast<char>(cells.size());
            for (const std::uint8_t cell : cells) bytes += nabcc_letter(cell);
            bytes += "\r\n";
        }
    }
    return bytes;
}

constexpr Embosser kEmbosser{
    .models = "Nippon Telesoft Gemini, ESA",
    .known_by = "nippon gemini",
    .punch = punch_nippon,
    .facts = kFacts,
};

}  // namespace

extern const Format nippon_format;
const Format nippon_format{
    .name = "nippon",
    .summary = "Nippon Telesoft, in cells",
    .medium = "embosser",
    .paper = "a4",
    .encode_pages = encode_pages,
    .embosser = &kEmbosser,
    .dots = dots,
};

}  // namespace tactics
