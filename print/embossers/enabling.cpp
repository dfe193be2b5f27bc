// SPDX-License-Identifier: Apache-2.0
// Enabling Technologies: Romeo, Juliet, ET, Phoenix, Cyclone and others, as text.
#include <algorithm>
#include <cmath>

#include "print/embosser.h"
#include "print/format.h"
#include "print/machines/machines.h"
#include "print/text_job.h"
#include "tactics/error.h"

namespace tactics {

namespace {

constexpr Option kOptions[] = {
    {.name = "cell",
     .type = Option::Type::choice,
     .fallback = 0,
     .min = 0,
     .max = 1,
     .summary = "size of its braille: Marburg Medium, or NLS for machines that know no other",
     .choices = "marburg nls"},
    {.name = "cells",
     .type = Option::Type::whole,
     .fallback = 45,
     .min = 20,
     .max = 45,
     .summary = "most in a line: 32 (Romeo Attache), 40 (ET, Thomas, Romeo Pro), 45 (Phoenix, Cyclone, Trident, Juliet)"},
    {.name = "end",
     .type = Option::Type::choice,
     .fallback = 0,
     .min = 0,
     .max = 1,
     .summary = "byte 1Ah behind the job: yes for Phoenix, Cyclone and Trident",
     .choices = "no yes"},
};

constexpr ProtocolFact kFacts[] = {
    {"ESC A, K, W, i, s, L, R, T, Q set tables, 6 dots, wrapping, side, size of the cell, margin, cells, inches and lines; a "
     "number n is the "
     "letter 40h + n",
     "libembosser EnablingTechnologiesDocumentHandler (dotify has another spelling, of control bytes)", Confidence::medium},
    {"ESC s @ is NLS braille, ESC s H Marburg Medium", "libembosser", Confidence::medium},
    {"most cells in a line by model, and 1Ah behind jobs of Phoenix, Cyclone and Trident", "libembosser Model",
     Confidence::medium},
    {"a graphic mode is known to its makers' programs only", "no public source found", Confidence::good},
};

DotSetting dots(const Settings& settings) {
    const CellSize cell = settings.choice("cell") == "nls" ? CellSize{2.34, 6.096, 10.16, 1.44} : kMarburgMedium;
    return {cell, DotBed{{cell.dot / 2 + 6, cell.dot / 2 + 6}, 0, 3}};
}

std::string encode_pages(std::span<const Page> pages, const Settings& settings) {
    const Page& page = pages.front();
    if (const int cells = cells_across(page); cells > settings.whole("cells"))
        throw Error(Fault::usage, "enabling",
                    "a line of this sheet has " + std::to_string(cells) + " cells, and the machine " +
                        std::to_string(settings.whole("cells")) + "; choose a narrower " + spelled("paper") + ", or " +
                        spelled("set") + " enabling.cells=NUMBER if it has more");
    const auto number = [](double n) { return static_cast<char>(0x40 + std::clamp(static_cast<int>(n), 0, 59)); };
    TextJob job;
    job.letter = nabcc_letter;
    const auto set = [&](char command, std::string_view value) {
        job.begin += std::string("\x1b") + command + std::string(value);
    };
    set('A', "@@");
    set('K', "@");
    set('W', "@");
    set('i', "A");
    set('s', settings.choice("cell") == "nls" ? "@" : "H");
    set('L', "A");
    set('R', std::string(1, number(cells_across(page))));
    set('T', std::string(1, number(std::ceil(page.height / 25.4 - 0.05))));
    set('Q', std::string(1, number(lines_down(page))));
    if (settings.choice("end") == "yes") job.end = "\x1a";
    return text_job(pages, job);
}

constexpr Embosser kEmbosser{
    .models = "Enabling Technologies Romeo, Juliet, Thomas, Marathon, ET, Phoenix, Cyclone",
    .known_by = "enabling romeo juliet",
    .punch = punch_enabling,
    .widest = 286,  // 45 cells of 6 mm; a Juliet has 56, which its wide paper would need
    .longest = 381,
    .facts = kFacts,
};

}  // namespace

extern const Format enabling_format;
const Format enabling_format{
    .name = "enabling",
    .summary = "Enabling Technologies: Romeo, Juliet, ET, Phoenix and others, in cells",
    .medium = "embosser",
    .paper = "11x11.5",
    .options = kOptions,
    .encode_pages = encode_pages,
    .embosser = &kEmbosser,
    .dots = dots,
};

}  // namespace tactics
