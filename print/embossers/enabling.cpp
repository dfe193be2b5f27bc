// SPDX-License-Identifier: Apache-2.0
// Enabling Technologies: Romeo, Juliet, ET, Phoenix, Cyclone and others, as text.
#include <algorithm>
#include <cmath>
#include <iterator>

#include "print/embosser.h"
#include "print/format.h"
#include "print/machines/machines.h"
#include "print/sides.h"
#include "print/text_job.h"
#include "tactics/error.h"

namespace tactics {

namespace {

// mm; 45 cells of 6 mm with the margins of 6, so that a sheet that may lie either way does not get more cells than most models
// have.
constexpr double kWidest = 286;

struct Model {
    std::string_view name;
    int cells = 40;     ///< most in a line
    bool both = false;  ///< sides
    std::string_view line_end = "\r\n";
    std::string_view end = "";
    double widest = kWidest;  ///< sheet, mm
    std::string_view paper = "11x11.5";
};

// In the order of the choices of the option. Source: libembosser 1.4.3 Model and ETFactory.
constexpr Model kModels[] = {
    {"any", 45, true},
    {"attache", 32, false, "\n", "", 8.5 * 25.4, "letter"},
    {"romeo"},
    {"thomas"},
    {"et", 40, true},
    {"juliet-pro60", 40, true},
    {"juliet", 56, true, "\r\n", "", 15 * 25.4},
    {"bookmaker", 44, true},
    {"express", 44, true},
    {"phoenix", 45, false, "\r\n", "\x1a"},
    {"cyclone", 45, false, "\r\n", "\x1a"},
    {"trident", 45, true, "\r\n", "\x1a"},
};

constexpr Option kEnablingOptions[] = {
    {.name = "model",
     .type = Option::Type::choice,
     .fallback = 0,
     .min = 0,
     .max = std::size(kModels) - 1,
     .summary = "the machine's model, which decides the cells per line, how lines and jobs end and whether it embosses both "
                "sides: Romeo Attache (and Pro), Romeo 25 and Pro 50, Thomas (and Pro), ET, Juliet Pro 60, Juliet Pro and "
                "Classic, BookMaker, Braille Express, Phoenix, Cyclone, Trident; a Romeo 60 or Juliet 120 is an index-v4",
     .choices = "any attache romeo thomas et juliet-pro60 juliet bookmaker express phoenix cyclone trident"},
    {.name = "cell",
     .type = Option::Type::choice,
     .fallback = 0,
     .min = 0,
     .max = 1,
     .summary = "size of its braille: Marburg Medium, or NLS for machines that have no other",
     .choices = "marburg nls"},
    {.name = "commands",
     .type = Option::Type::choice,
     .fallback = 0,
     .min = 0,
     .max = 1,
     .summary = "letters, as the American Printing House's BrailleBlaster sends them; or control bytes, as dotify sends them: "
                "for a machine that embosses the letters of commands or assumes another sheet length",
     .choices = "letters control"},
    kSides,
};

constexpr ProtocolFact kEnablingFacts[] = {
    {"ESC A, K, W, i, s, L, R, T, Q set tables, 6 dots, wrapping, sides, size of the cell, margin, cells, inches and lines; a "
     "number n is the letter 40h + n, up to 59",
     "libembosser 1.4.3 EnablingTechnologiesDocumentHandler", Confidence::medium},
    {"ESC i @ selects both sides, ESC i A one; a job on both sides ends with a back", "libembosser 1.4.3", Confidence::medium},
    {"ESC s @ is NLS braille, ESC s H Marburg Medium", "libembosser 1.4.3", Confidence::medium},
    {"a page, even one without lines, ends with the end of a line and a form feed; a full page ends with the end of its last "
     "line alone, after which the machine feeds by itself",
     "libembosser 1.4.3 (setEopOnFullPage), where full means the number of lines that ESC Q gives", Confidence::medium},
    {"most cells in a line by model, LF without CR for the Attache, 1Ah behind jobs of Phoenix, Cyclone and Trident",
     "libembosser 1.4.3 Model", Confidence::medium},
    {"as control bytes the commands are the same without the 40h (ESC 01h for ESC A, 08h for H), with ESC 00h, 0Fh, 23h and 34h "
     "for reset, paper sensor, centring and top of form; the length is the inches minus 3; a page, even a full one, ends with a "
     "form feed after its last line; 11h is also XON on a serial cable",
     "dotify 1.0.9 EnablingTechnologiesEmbosser, beside libembosser 1.4.3", Confidence::medium},
    {"the two sources contradict each other on the value of ESC T and ESC 14h for 11 inches: 11 and 8",
     "libembosser 1.4.3; dotify 1.0.9", Confidence::uncertain},
    {"sheets of 3 to 14 inches, up to 15 wide (Juliet; Attache 8.5)", "libembosser 1.4.3 ETFactory; dotify 1.0.9",
     Confidence::medium},
    {"only the maker's programs know a graphics mode", "no public source found", Confidence::good},
};

const Model& model_of(const Settings& settings) {
    return *std::find_if(std::begin(kModels), std::end(kModels),
                         [&](const Model& each) { return each.name == settings.choice("model"); });
}

// A page goes as far to the right as the machine has cells, however wide the sheet is.
DotSetting enabling_dots(const Settings& settings) {
    const CellSize cell = settings.choice("cell") == "nls" ? CellSize{2.34, 6.096, 10.16, 1.44} : kMarburgMedium;
    DotSetting set{cell, DotBed{{cell.dot / 2 + 6, cell.dot / 2 + 6}, 0, 3}};
    set.reach = set.bed.first.x + (model_of(settings).cells - 1) * cell.cell_pitch + cell.dot_pitch + cell.dot / 2;
    return set;
}

struct SetUp {
    int cells = 0, lines = 0, inches = 0;
    bool both = false;
};

std::string letters(const SetUp& set_up, char cell) {
    std::string bytes;
    const auto set = [&](std::string_view command, int value) {
        bytes += "\x1b" + std::string(command) + static_cast<char>(0x40 + value);
    };
    set("A@", 0);
    set("K", 0);
    set("W", 0);
    set("i", set_up.both ? 0 : 1);
    set("s", cell);
    set("L", 1);
    set("R", set_up.cells);
    set("T", set_up.inches);
    set("Q", set_up.lines);
    return bytes;
}

std::string control_bytes(const SetUp& set_up, char cell, const Model& model) {
    std::string bytes;
    const auto set = [&](char command, int value) { bytes += {'\x1b', command, static_cast<char>(value)}; };
    bytes += {'\x1b', 0, '\x1b', 1, 0, 0};
    set(0x0b, 0);
    set(0x0c, 1);
    set(0x0f, 1);
    set(0x11, set_up.lines);
    set(0x12, set_up.cells);
    set(0x14, set_up.inches - 3);
    set(0x17, 0);
    set(0x23, 0);
    if (model.both) set(0x29, set_up.both ? 0 : 1);
    set(0x33, cell);
    set(0x34, 0);
    return bytes;
}

void check_cells(std::span<const Page> pages, const Model& model) {
    for (const Page& page : pages) {
        const CellRows rows = cell_rows(page);
        for (std::size_t line = 0; line < rows.lines; ++line)
            if (const std::size_t cells = without_end(rows.line(line)).size(); cells > static_cast<std::size_t>(model.cells))
                throw Error(Fault::usage, "enabling",
                            phrase("line {0} of the page has {1} cells, and the machine {2}; choose a narrower {3} or a wider "
                                   "{4}, or {5} enabling.model=NAME if yours has more",
                                   std::to_string(line + 1), std::to_string(cells), std::to_string(model.cells), spelled("paper"),
                                   spelled("margin"), spelled("set")));
    }
}

std::string encode_pages_enabling(std::span<const Page> pages, const Settings& settings) {
    const Page& page = pages.front();
    const Model& model = model_of(settings);
    const bool both = on_both(settings), control = settings.choice("commands") == "control";
    if (both && !model.both)
        throw Error(Fault::usage, "enabling",
                    phrase("this model embosses one side of a sheet; leave {0} out, or choose another model", spelled("duplex")));
    const int inches = static_cast<int>(std::ceil(page.height / 25.4 - 0.05));
    if (inches < 3)
        throw Error(Fault::usage, "enabling",
                    phrase("this machine takes sheets of 3 to 14 inches; choose a longer {0}", spelled("paper")));
    check_cells(pages, model);
    const SetUp set_up{std::min(cells_across(page), model.cells), std::min(lines_down(page), 59), inches, both};
    const char cell = settings.choice("cell") == "nls" ? 0 : 8;
    TextJob job;
    job.letter = nabcc_letter;
    job.begin = control ? control_bytes(set_up, cell, model) : letters(set_up, cell);
    job.line_end = control ? "\r\n" : model.line_end;
    job.page_end = job.blank_page_end = (control ? "" : job.line_end) + "\f";
    if (!control) {
        job.most_lines = static_cast<std::size_t>(set_up.lines);
        job.full_page_end = job.line_end;
    }
    if (both && pages.size() % 2 != 0) job.end = job.blank_page_end;
    job.end += model.end;
    return text_job(pages, job);
}

// Models that share a protocol, as listed in the option's summary; a Marathon is none of them.
constexpr ModelSettings kByModel[] = {
    {"romeo", "model=romeo"},
    {"romeo-attache", "model=attache"},
    {"romeo-25", "model=romeo"},
    {"romeo-pro-50", "model=romeo"},
    {"juliet", "model=juliet"},
    {"juliet-pro", "model=juliet"},
    {"juliet-pro-60", "model=juliet-pro60"},
    {"juliet-classic", "model=juliet"},
    {"thomas", "model=thomas"},
    {"thomas-pro", "model=thomas"},
    {"et", "model=et"},
    {"bookmaker", "model=bookmaker"},
    {"braille-express", "model=express"},
    {"phoenix", "model=phoenix"},
    {"cyclone", "model=cyclone"},
    {"trident", "model=trident"},
};

constexpr Embosser kEnablingEmbosser{
    .models = "Enabling Technologies Romeo, Juliet, Thomas, Marathon, ET, BookMaker, Braille Express, Phoenix, Cyclone, Trident",
    .called =
        "romeo romeo-attache romeo-25 romeo-pro-50 juliet juliet-pro juliet-pro-60 juliet-classic thomas "
        "thomas-pro marathon et bookmaker braille-express phoenix cyclone trident",
    .settings_by_model = kByModel,
    .known_by = "enabling romeo juliet",
    .punch = punch_enabling,
    .widest = kWidest,
    .widest_of = [](const Settings& settings) { return model_of(settings).widest; },
    .longest = 356,
    .paper_of = [](const Settings& settings) { return model_of(settings).paper; },
    .facts = kEnablingFacts,
};

}  // namespace

extern const Format enabling_format;
const Format enabling_format{
    .name = "enabling",
    .summary = "Enabling Technologies: Romeo, Juliet, ET, Phoenix and others, in cells",
    .medium = "embosser",
    .paper = "11x11.5",
    .options = kEnablingOptions,
    .encode_pages = encode_pages_enabling,
    .embosser = &kEnablingEmbosser,
    .dots = enabling_dots,
};

}  // namespace tactics
