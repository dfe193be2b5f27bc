// SPDX-License-Identifier: Apache-2.0
// A clear gap between lines: two lines closer than that are one line to a finger, or a rough patch.
#include "filters/spacing.h"
#include "tactics/filter.h"
#include "tactics/units.h"

namespace tactics {

namespace {

// 3.2 mm (1/8 in) is the least clear distance between two elements (L. Hasty, Designing Tactile Graphics), and a line is
// 1 mm wide on swell paper, so middle lines stand 4.2 mm apart, and 0.2 mm more for what simplify may move them after that. A
// line of half the 12.7 mm (1/2 in) that a side of a shape needs (APH guide) is the least that a piece may be.
constexpr Option kSeparateOptions[] = {
    {.name = "gap",
     .type = Option::Type::length,
     .fallback = 4.4,
     .min = 0.5,
     .max = 50,
     .unit = "mm",
     .summary = "minimum distance between the middles of two lines"},
    {.name = "shortest",
     .type = Option::Type::length,
     .fallback = 6.4,
     .min = 0,
     .max = 100,
     .unit = "mm",
     .summary = "lines and pieces shorter than this are left out; from one line to another half of it is enough"},
};

Artwork apply_separate(Artwork artwork, const Settings& settings) {
    keep_apart(std::get<Drawing>(artwork), settings.number("gap"), settings.number("shortest"));
    return artwork;
}

// Lines that keep the usual gap keep that of the medium.
void fit_separate(Settings& settings, const Medium& medium) {
    if (settings.is_default("gap")) settings.set("gap", to_text(medium.gap + medium.line + kMovedLater), "separate", "separate");
}

}  // namespace

extern const Filter separate_filter;
const Filter separate_filter{
    .name = "separate",
    .summary = "keeps lines far enough apart for a finger; of two that run together, keeps the stronger",
    .takes = static_cast<Kinds>(Kind::drawing),
    .gives = static_cast<Kinds>(Kind::drawing),
    .options = kSeparateOptions,
    .apply = apply_separate,
    .fit = fit_separate,
    .in_full = "-",
};

}  // namespace tactics
