// SPDX-License-Identifier: Apache-2.0
// Index Basic, Everest, 4x4 PRO and 4-Waves of the third series: 4-dot graphics.
#include "print/embosser.h"
#include "print/embossers/index_set_up.h"
#include "print/equal_dots.h"
#include "print/format.h"
#include "print/machines/machines.h"

namespace tactics {

namespace {

constexpr ProtocolFact kIndexV3Facts[] = {
    kFourDotFact,
    kFourDotSetUpFact,
    kJobEndFact,
    kPacketFact,
    kFeedFact,
    {"no unprintable margin at the left, 2 mm at the top", "cups-filters indexv3.drv (HWMargins)", Confidence::medium},
    kIndexTextFact,
    kIndexCellFact,
    {"PW and PL give the size of the sheet: in mm for Everest and 4x4 PRO, in inches and a digit (quarter, third, half, two "
     "thirds, three quarters) for Basic; not sent for 4-Waves; rounded down (dotify rounds up, pads to three digits and sends "
     "PW for 4-Waves)",
     "cups-filters 1.28.17 indexv3.sh, indexv3.drv; dotify 1.0.9 IndexV3Embosser", Confidence::medium},
    {"LS4 selects single lines, 5 mm between dots; dotify sends LS50, unknown to firmware before 12.01.3",
     "cups-filters 1.28.17 "
     "indexv3.sh; dotify 1.0.9 IndexV3Embosser",
     Confidence::medium},
};

DotSetting index_v3_dots(const Settings& settings) { return equal_dots(settings.choice("pitch"), kFirstDotV3); }

constexpr Embosser kIndexV3Embosser{
    .models = "Index Basic, Everest, 4x4 PRO, 4-Waves V3",
    .called = "basic-v3 basic-d-v3 everest-v3 everest-d-v3 4x4-pro 4x4-pro-v3 4-waves 4-waves-v3",
    .known_by = "index",
    .packet = kIndexPacket,
    .punch = punch_index_v3,
    .widest = 325,
    .longest = 432,
    .facts = kIndexV3Facts,
    .text = &index_v3_text,
};

}  // namespace

extern const Format index_v3_format;
const Format index_v3_format{
    .name = "index-v3",
    .summary = "Index Basic, Everest, 4x4 PRO and 4-Waves V3: dots 1.6, 2.0 or 2.5 mm apart",
    .medium = "embosser",
    .paper = "a4",
    .options = kFourDotOptions,
    .encode_pages = four_dot_job_v3,
    .embosser = &kIndexV3Embosser,
    .dots = index_v3_dots,
};

}  // namespace tactics
