// SPDX-License-Identifier: Apache-2.0
// Braillo 200, 270 and 400, as text.
#include <algorithm>
#include <cmath>

#include "print/embosser.h"
#include "print/format.h"
#include "print/machines/machines.h"
#include "print/text_job.h"
#include "tactics/error.h"

namespace tactics {

namespace {

constexpr ProtocolFact kFacts[] = {
    {"ESC S1 form feeds, ESC C0 single-sided, ESC J0 6 dots, ESC A nn half inches of the sheet (08 to 28), ESC B nn cells of a "
     "line (10 to 42), "
     "ESC H0 no z-fold, ESC N0 single lines, ESC R0 no adjustment",
     "dotify Braillo200", Confidence::medium},
    {"a cell is 6.03 mm wide, a line 10 mm high", "dotify; libembosser", Confidence::medium},
};

constexpr CellSize kCell{2.5, 6.03, 10.0, 1.6};

DotSetting dots(const Settings&) { return {kCell, DotBed{{6.8, 6.8}, 0, 3}}; }

std::string two_digits(int number) { return std::string(number < 10 ? "0" : "") + std::to_string(number); }

std::string encode_pages(std::span<const Page> pages, const Settings&) {
    const Page& page = pages.front();
    const int half_inches = static_cast<int>(std::ceil(page.height / 12.7 - 0.05));
    const int cells = cells_across(page);
    if (half_inches < 8 || half_inches > 28 || cells < 10 || cells > 42)
        throw Error(Fault::usage, "braillo",
                    "this machine takes sheets of 4 to 14 inches with 10 to 42 cells in a line; choose another " +
                        spelled("paper") + " or " + spelled("orientation"));
    TextJob job;
    job.begin =
        "\x1bS1\x1b"
        "C0\x1bJ0\x1b"
        "A" +
        two_digits(half_inches) +
        "\x1b"
        "B" +
        two_digits(cells) + "\x1bH0\x1bN0\x1bR0";
    job.letter = nabcc_letter;
    return text_job(pages, job);
}

constexpr Embosser kEmbosser{
    .models = "Braillo 200, 270, 400 S and 400 SR",
    .known_by = "braillo",
    .punch = punch_braillo,
    .widest = 267,
    .longest = 356,
    .facts = kFacts,
};

}  // namespace

extern const Format braillo_format;
const Format braillo_format{
    .name = "braillo",
    .summary = "Braillo 200, 270 and 400, in cells",
    .medium = "embosser",
    .paper = "a4",
    .encode_pages = encode_pages,
    .embosser = &kEmbosser,
    .dots = dots,
};

}  // namespace tactics
