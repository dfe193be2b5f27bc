// Index Basic-D, Everest-D, FanFold-D and BrailleBox of the fourth and fifth series: 4-dot graphics.
#include "print/embosser.h"
#include "print/embossers/index_set_up.h"
#include "print/format.h"
#include "print/machines/machines.h"

namespace tactics {

namespace {

constexpr Option kOptions[] = {
    {.name = "pitch", .type = Option::Type::choice, .fallback = 2, .min = 0, .max = 2, .unit = "",
     .summary = "mm from dot to dot; labels are braille of standard size at 2.5, too small at 2.0, large at 1.6", .choices = "1.6 2.0 2.5"},
    {.name = "setup", .type = Option::Type::choice, .fallback = 0, .min = 0, .max = 1, .unit = "",
     .summary = "send settings for this job: no for firmware older than 10.30, which embosses them", .choices = "yes no"},
    {.name = "impacts", .type = Option::Type::whole, .fallback = 1, .min = 1, .max = 3, .unit = "",
     .summary = "how often a dot is struck, for heavy paper", .choices = ""},
    {.name = "copies", .type = Option::Type::whole, .fallback = 1, .min = 1, .max = 10000, .unit = "", .summary = "copies of all pages", .choices = ""},
};

constexpr ProtocolFact kFacts[] = {
    {"ESC 07h and ESC 06h begin and end 4-dot graphics; @ to O is a column of 4 dots, the lowest bit on top; @ at the end may be left out",
     "cups-filters imageubrltoindexv3 and v4", Confidence::good},
    {"ESC D key,key; sets up this job with firmware 10.30 and newer; GD is the graphic pitch (2.0, 2.5, 1.6 mm), DP1 single-sided, PN0 no page numbers, MC copies, "
     "MI impacts, TM and BI margins, FO first line",
     "cups-filters index.sh; dotify IndexV4Header", Confidence::medium},
    {"1Ah ends a job", "cups-filters; dotify", Confidence::medium},
    {"a form feed outside of graphics ends a page of them", "this project, by analogy with text", Confidence::uncertain},
    {"5 mm are kept free on every side", "cups-filters indexv4.drv (HWMargins)", Confidence::medium},
    {"firmware 10.20 embosses the set-up as text", "cups-filters README", Confidence::medium},
};

DotSetting dots(const Settings& settings) { return four_dot_setting(settings.choice("pitch"), {5.8, 5.8}); }

std::string encode_pages(std::span<const Page> pages, const Settings& settings) {
    const auto pitch = settings.choice("pitch");
    return four_dot_job(pages, index_set_up(settings, pitch == "2.0" ? "GD0" : pitch == "2.5" ? "GD1" : "GD2"));
}

std::string encode(const Page& page, const Settings& settings) { return encode_pages({&page, 1}, settings); }

constexpr Embosser kEmbosser{
    .models = "Index Basic-D, Everest-D, FanFold-D, BrailleBox V4 and V5; APH PageBlaster; Enabling Romeo 60, Juliet 120",
    .known_by = "index",
    .punch = punch_index_v4,
    .widest = 325,
    .longest = 590,
    .facts = kFacts,
};

}  // namespace

extern const Format index_v4_format;
const Format index_v4_format{
    .name = "index-v4",
    .summary = "Index Basic-D, Everest-D, FanFold-D, BrailleBox V4 and V5: dots 1.6, 2.0 or 2.5 mm apart",
    .extensions = "",
    .medium = "embosser",
    .paper = "a4",
    .options = kOptions,
    .encode = encode,
    .encode_pages = encode_pages,
    .embosser = &kEmbosser,
    .dots = dots,
};

}  // namespace tactics
