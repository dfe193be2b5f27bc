// Index Basic-D, Everest-D, FanFold-D and BrailleBox of the fourth and fifth series: 4-dot graphics.
#include "print/embosser.h"
#include "print/embossers/index_set_up.h"
#include "print/equal_dots.h"
#include "print/format.h"
#include "print/machines/machines.h"

namespace tactics {

namespace {

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
    {"text: BT0 is the table of North American Braille Computer Code, TD0 dots 2.5 mm apart, CH cells of a line, LP lines of a page",
     "dotify IndexV4Header; brailleplot AbstractIndexV4Builder", Confidence::medium},
};

DotSetting dots(const Settings& settings) { return equal_dots(settings.choice("pitch"), {5.8, 5.8}); }

DotSetting text_dots(const Settings&) { return {kMarburgMedium, {{5.8, 5.8}, 0, 3}}; }

constexpr TextMode kText{text_dots, index_text_job};

constexpr Embosser kEmbosser{
    .models = "Index Basic-D, Everest-D, FanFold-D, BrailleBox V4 and V5; APH PageBlaster; Enabling Romeo 60, Juliet 120",
    .known_by = "index",
    .punch = punch_index_v4,
    .widest = 325,
    .longest = 590,
    .facts = kFacts,
    .text = &kText,
};

}  // namespace

extern const Format index_v4_format;
const Format index_v4_format{
    .name = "index-v4",
    .summary = "Index Basic-D, Everest-D, FanFold-D, BrailleBox V4 and V5: dots 1.6, 2.0 or 2.5 mm apart",
    .extensions = "",
    .medium = "embosser",
    .paper = "a4",
    .options = kFourDotOptions,
    .encode_pages = four_dot_job,
    .embosser = &kEmbosser,
    .dots = dots,
};

}  // namespace tactics
