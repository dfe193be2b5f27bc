// SPDX-License-Identifier: Apache-2.0
// CIDAT Impacto 600 and Texto, as cells in their transparent mode.
#include <algorithm>
#include <cmath>

#include "print/embosser.h"
#include "print/format.h"
#include "print/machines/machines.h"
#include "print/sides.h"
#include "print/text_job.h"
#include "tactics/error.h"

namespace tactics {

namespace {

constexpr Option kCidatOptions[] = {kSides};

constexpr ProtocolFact kCidatFacts[] = {
    {"ESC ) is transparent mode: each byte is a cell, with dot 1 as its lowest bit; 1Bh is sent twice; ESC LF ends a line, ESC "
     "FF a page",
     "dotify 1.0.9 CidatTableProvider, CidatLineBreaks, CidatPageBreaks", Confidence::medium},
    {"ESC * 6 dots, ESC . inches, ESC / line distance in tenths, ESC 0 cells, ESC 1 lines (a number n is the byte 30h + n), ESC "
     "3 cuts words, ESC P one side, ESC Q both; ESC XXn LF sets GU, IN, MB, ML, MR, MT, NC, SC, PM, PN, PI; ESC T ends a job, "
     "even on a front",
     "dotify 1.0.9 ImpactoEmbosser", Confidence::medium},
};

constexpr CellSize kCidatCell{2.5, 6.35, 10.16, 1.6};

DotSetting cidat_dots(const Settings&) { return {kCidatCell, DotBed{{6.8, 6.8}, 0, 3}}; }

std::string cidat_letter(std::uint8_t cell) { return cell == 0x1b ? "\x1b\x1b" : std::string(1, static_cast<char>(cell)); }

std::string encode_pages_cidat(std::span<const Page> pages, const Settings& settings) {
    const Page& page = pages.front();
    const int inches = static_cast<int>(std::ceil(page.height / 25.4 - 0.05));
    const int cells = cells_across(page), lines = lines_down(page);
    if (inches < 6 || inches > 13 || cells < 12 || cells > 42 || lines < 12 || lines > 43)
        throw Error(Fault::usage, "cidat",
                    phrase("this machine takes sheets of 6 to 13 inches with 12 to 42 cells in a line and 12 to 43 lines; choose "
                           "another {0} or {1}",
                           spelled("paper"), spelled("orientation")));
    const auto number = [](int n) { return std::string(1, static_cast<char>(0x30 + n)); };
    TextJob job;
    for (const std::string& command :
         {std::string(")"), std::string("*"), "." + number(inches), std::string("/1"), "0" + number(cells), "1" + number(lines),
          std::string("3"), std::string(on_both(settings) ? "Q" : "P"), std::string("GU0\n"), std::string("IN0\n"),
          std::string("MB0\n"), std::string("ML0\n"), std::string("MR0\n"), std::string("MT0\n"), std::string("NC1\n"),
          std::string("SC1\n"), std::string("PM0\n"), std::string("PN0\n"), std::string("PI0\n")})
        job.begin += "\x1b" + command;
    job.line_end = "\x1b\n";
    job.page_end = job.blank_page_end = "\x1b\f";
    job.end = "\x1bT";
    job.letter = cidat_letter;
    return text_job(pages, job);
}

constexpr Embosser kCidatEmbosser{
    .models = "CIDAT Impacto 600, Impacto Texto",
    .called = "impacto-600 impacto-texto impacto",
    .known_by = "cidat impacto",
    .punch = punch_cidat,
    .widest = 281,  // 42 cells
    .longest = 330,
    .facts = kCidatFacts,
};

}  // namespace

extern const Format cidat_format;
const Format cidat_format{
    .name = "cidat",
    .summary = "CIDAT Impacto, in cells",
    .medium = "embosser",
    .paper = "11x11.5",
    .options = kCidatOptions,
    .encode_pages = encode_pages_cidat,
    .embosser = &kCidatEmbosser,
    .dots = cidat_dots,
};

}  // namespace tactics
