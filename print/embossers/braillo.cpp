// SPDX-License-Identifier: Apache-2.0
// Braillo 200, 270 and 400, as text, in the commands of each age of their firmware.
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

constexpr Option kBrailloOptions[] = {
    {.name = "firmware",
     .type = Option::Type::choice,
     .fallback = 0,
     .min = 0,
     .max = 2,
     .summary = "the machine's firmware: 17 or newer (Braillo 200, 400 S and SR, 600), 12 to 16 (Braillo 270; 200 and 400 of "
                "that age), 11 or older; each embosses another's commands as text",
     .choices = "17 16 11"},
    kSides,
};

constexpr ProtocolFact kBrailloFacts[] = {
    {"firmware 17 and newer: ESC S1 form feeds, ESC C0 one side and C1 both, ESC J0 6 dots, ESC A nn sheet length in half "
     "inches (08 to 28), ESC B nn cells per line (10 to 42), ESC H0 no z-fold, ESC N0 single lines, ESC R0 all lines",
     "dotify 1.0.9 AbstractBraillo200Embosser; libembosser 1.4.3 Braillo200DocumentHandler (the same in another order); ESC R "
     "and S "
     "also in Braillo's manual of the 200, Rev. 9705, page 29",
     Confidence::good},
    {"firmware 12 to 16: ESC E form feeds, ESC S0 one side and S1 both, ESC 6 6 dots, ESC 1Fh n cells per line (27 to 42 as 0 "
     "to F), ESC 1Eh n sheet length (4 to 14 inches as 0 to F), ESC A single lines, ESC Q0 no z-fold",
     "dotify 1.0.9 Braillo200x270x400v12x16Embosser; libembosser 1.4.3 Braillo270DocumentHandler (the same in another order)",
     Confidence::good},
    {"firmware 11 and older: ESC E, ESC 6, ESC 1Fh n and ESC A as firmware 12 to 16, ESC 1Eh n sheet length in half inches over "
     "10 (0 to 8); no command for one or both sides: set the machine to those of the job",
     "dotify 1.0.9 Braillo200x270x400v1x11Embosser; libembosser 1.4.3 Braillo270DocumentHandler", Confidence::good},
    {"a form feed follows the last line without CR LF, which could begin another page if that line is the last that fits "
     "(libembosser has CR LF there); a page without lines has CR LF, because the machine ignores a lone form feed; a job on "
     "both sides ends with a back",
     "dotify 1.0.9 AbstractBraillo200Embosser", Confidence::medium},
    {"one side is sent as ESC C0 or S0, page after page (dotify sends both sides and empty backs)", "libembosser 1.4.3",
     Confidence::medium},
    {"a cell is 6.03 mm wide, a line 10 mm high", "dotify 1.0.9 BrailloEmbosser; libembosser", Confidence::medium},
    {"letters are North American Braille Computer Code; set the machine to it",
     "dotify 1.0.9 BrailloEmbosserProvider; libembosser", Confidence::medium},
};

constexpr CellSize kBrailloCell{2.5, 6.03, 10.0, 1.6};

DotSetting braillo_dots(const Settings&) { return {kBrailloCell, DotBed{{6.8, 6.8}, 0, 3}}; }

std::string two_digits(int number) { return std::string(number < 10 ? "0" : "") + std::to_string(number); }

std::string encode_pages_braillo(std::span<const Page> pages, const Settings& settings) {
    const auto firmware = settings.choice("firmware");
    const int fewest_cells = firmware == "17" ? 10 : 27, least_halves = firmware == "11" ? 20 : 8;
    const Page& page = pages.front();
    const int half_inches = static_cast<int>(std::ceil(page.height / 12.7 - 0.05));
    const int cells = cells_across(page);
    if (half_inches < least_halves || half_inches > 28 || cells < fewest_cells || cells > 42)
        throw Error(
            Fault::usage, "braillo",
            phrase("this machine takes sheets of {0} to 14 inches with {1} to 42 cells in a line; choose another {2} or {3}",
                   std::to_string(least_halves / 2), std::to_string(fewest_cells), spelled("paper"), spelled("orientation")));
    TextJob job;
    const auto set = [&](std::string_view command) { job.begin += "\x1b" + std::string(command); };
    const std::string both = on_both(settings) ? "1" : "0";
    if (firmware == "17") {
        for (const std::string& command : {std::string("S1"), "C" + both, std::string("J0"), "A" + two_digits(half_inches),
                                           "B" + two_digits(cells), std::string("H0"), std::string("N0"), std::string("R0")})
            set(command);
    } else {
        constexpr std::string_view kLengths = "011223344556789ABCDEF", kDigits = "0123456789ABCDEF";
        set("E");
        if (firmware == "16") set("S" + both);
        set("6");
        set(std::string("\x1f") + kDigits[static_cast<std::size_t>(cells - 27)]);
        set(std::string("\x1e") + (firmware == "16" ? kLengths : kDigits)[static_cast<std::size_t>(half_inches - least_halves)]);
        set("A");
        if (firmware == "16") set("Q0");
    }
    job.page_end = "\f";
    job.blank_page_end = "\r\n\f";
    if (on_both(settings) && pages.size() % 2 != 0) job.end = job.blank_page_end;
    job.letter = nabcc_letter;
    return text_job(pages, job);
}

constexpr Embosser kBrailloEmbosser{
    .models = "Braillo 200, 270, 400, 400 S, 400 SR, 600, 600 SR",
    .called = "braillo-200 braillo-270 braillo-400 braillo-400-s braillo-400-sr braillo-600 braillo-600-sr",
    .known_by = "braillo",
    .punch = punch_braillo,
    .widest = 267,
    .longest = 356,
    .facts = kBrailloFacts,
};

}  // namespace

extern const Format braillo_format;
const Format braillo_format{
    .name = "braillo",
    .summary = "Braillo 200, 270, 400 and 600, in cells",
    .medium = "embosser",
    .paper = "a4",
    .options = kBrailloOptions,
    .encode_pages = encode_pages_braillo,
    .embosser = &kBrailloEmbosser,
    .dots = braillo_dots,
};

}  // namespace tactics
