// SPDX-License-Identifier: Apache-2.0
// Index Basic-D, Everest-D, FanFold-D and BrailleBox of the fourth and fifth series: 4-dot graphics.
#include "print/embosser.h"
#include "print/embossers/index_set_up.h"
#include "print/equal_dots.h"
#include "print/format.h"
#include "print/machines/machines.h"

namespace tactics {

namespace {

constexpr ProtocolFact kIndexV4Facts[] = {
    kFourDotFact,
    kFourDotSetUpFact,
    kJobEndFact,
    kPacketFact,
    kFeedFact,
    {"an unprintable margin of 5 mm on every side", "cups-filters indexv4.drv (HWMargins)", Confidence::medium},
    {"firmware 10.20 embosses the setup commands as text", "cups-filters README", Confidence::medium},
    kIndexTextFact,
    kIndexCellFact,
    {"CH cells per line, LP lines per page (LP needs TM, CH needs BI), LS50 single lines",
     "cups-filters 1.28.17 indexv4.sh; libembosser 1.4.3; dotify 1.0.9; brailleplot 63abd73, after Index's Interface Protocol V5 "
     "and "
     "V4 of 2016-05-13",
     Confidence::good},
};

DotSetting index_v4_dots(const Settings& settings) { return equal_dots(settings.choice("pitch"), kFirstDotV4); }

constexpr Embosser kIndexV4Embosser{
    .models = "Index Basic-D, Everest-D, FanFold-D, BrailleBox V4 and V5; APH PageBlaster; Enabling Romeo 60, Juliet 120",
    .called =
        "basic-d basic everest-d everest fanfold-d fanfold braillebox basic-d-v4 basic-d-v5 basic-v4 basic-v5 "
        "everest-d-v4 everest-d-v5 everest-v4 everest-v5 fanfold-d-v4 fanfold-d-v5 fanfold-v4 fanfold-v5 "
        "braillebox-v4 braillebox-v5 pageblaster romeo-60 juliet-120",
    .known_by = "index",
    .packet = kIndexPacket,
    .punch = punch_index_v4,
    .widest = 325,
    .longest = 590,
    .facts = kIndexV4Facts,
    .text = &index_v4_text,
};

}  // namespace

extern const Format index_v4_format;
const Format index_v4_format{
    .name = "index-v4",
    .summary = "Index Basic-D, Everest-D, FanFold-D, BrailleBox V4 and V5: dots 1.6, 2.0 or 2.5 mm apart",
    .medium = "embosser",
    .paper = "a4",
    .options = kFourDotOptionsV4,
    .encode_pages = four_dot_job_v4,
    .embosser = &kIndexV4Embosser,
    .dots = index_v4_dots,
};

}  // namespace tactics
