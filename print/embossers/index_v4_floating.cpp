// SPDX-License-Identifier: Apache-2.0
// Index V4 and V5 with floating dots: each dot where it belongs, to 0.05 mm.
#include <cmath>

#include "print/embosser.h"
#include "print/embossers/index_set_up.h"
#include "print/format.h"
#include "print/free_dots.h"
#include "print/machines/machines.h"
#include "tactics/error.h"

namespace tactics {

namespace {

constexpr Option kIndexV4FloatingOptions[] = {
    {.name = "spacing",
     .type = Option::Type::length,
     .fallback = 2,
     .min = 1.6,
     .max = 3,
     .unit = "mm",
     .summary = "distance from dot to dot along lines"},
    {.name = "left",
     .type = Option::Type::length,
     .fallback = 0,
     .min = 0,
     .max = 60,
     .unit = "mm",
     .summary = "distance from the sheet's left edge to the machine's origin"},
    {.name = "top",
     .type = Option::Type::length,
     .fallback = 0,
     .min = 0,
     .max = 60,
     .unit = "mm",
     .summary = "distance from the sheet's top edge to the machine's origin"},
    {.name = "setup",
     .type = Option::Type::choice,
     .fallback = 0,
     .min = 0,
     .max = 1,
     .summary = "send settings for this job; choose no for firmware older than 10.30, which embosses them as text",
     .choices = "yes no"},
    {.name = "impacts",
     .type = Option::Type::whole,
     .fallback = 1,
     .min = 1,
     .max = 3,
     .summary = "how many times to strike each dot, for heavy paper"},
    {.name = "copies",
     .type = Option::Type::whole,
     .fallback = 1,
     .min = 1,
     .max = 10000,
     .summary = "number of copies of all pages"},
};

constexpr ProtocolFact kIndexV4FloatingFacts[] = {
    {"ESC F ; LF begins an area of floating dots; each line is one dot, x:y in mm with two decimals; a line with ; ends the "
     "area",
     "brailleplot 63abd73 FloatingDotAreaBuilder, after Index's Interface Protocol V5 and V4 of 2016-05-13",
     Confidence::uncertain},
    {"coordinates count from the top left corner of the sheet", "this project; settings left and top", Confidence::uncertain},
    {"dots stand on a grid of 0.05 mm", "Index's Interface Protocol, at second hand", Confidence::uncertain},
    kFourDotSetUpFact,
    {"a form feed after an area ends its page", "this project, by analogy with text", Confidence::uncertain},
    {"one side only: no source says from which edge coordinates on the back are measured", "this project", Confidence::uncertain},
    kJobEndFact,
    kPacketFact,
    kIndexTextFact,
};

// Two decimals, the second 0 or 5.
std::string place(double mm) {
    const long steps = std::lround(mm / 0.05);
    if (steps < 0)
        throw Error(Fault::usage, "index-v4-floating",
                    phrase("a dot would lie left of where the machine counts from, or above; take a larger {0} than left and top",
                           spelled("margin")));
    const long hundredths = steps * 5;
    std::string text = std::to_string(hundredths / 100) + ".";
    text += static_cast<char>('0' + hundredths / 10 % 10);
    text += static_cast<char>('0' + hundredths % 10);
    return text;
}

std::string encode_pages_index_v4_floating(std::span<const Page> pages, const Settings& settings) {
    std::string bytes = index_set_up(pages.front(), settings, IndexSeries::v4, "");
    const double left = settings.number("left"), top = settings.number("top");
    for (const Page& page : pages) {
        bytes +=
            "\x1b"
            "F;\n";
        std::string_view between;
        for (const Point dot : free_dots(page, settings.number("spacing"))) {
            bytes += std::string(between) + place(dot.x - left) + ":" + place(dot.y - top);
            between = "\n";
        }
        bytes += ";\f";
    }
    return index_job(bytes + '\x1a');
}

constexpr Embosser kIndexV4FloatingEmbosser{
    .models = "Index Basic-D, Everest-D, FanFold-D, BrailleBox V4 and V5; APH PageBlaster; Enabling Romeo 60, Juliet 120",
    .known_by = "index",
    .packet = kIndexPacket,
    .punch = punch_index_floating,
    .widest = 325,
    .longest = 590,
    .facts = kIndexV4FloatingFacts,
    .text = &index_v4_text,
};

}  // namespace

extern const Format index_v4_floating_format;
const Format index_v4_floating_format{
    .name = "index-v4-floating",
    .summary = "Index V4 and V5 with floating dots, which lie exactly on lines and curves",
    .medium = "floating-dots",
    .paper = "a4",
    .options = kIndexV4FloatingOptions,
    .encode_pages = encode_pages_index_v4_floating,
    .embosser = &kIndexV4FloatingEmbosser,
};

}  // namespace tactics
