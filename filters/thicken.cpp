// SPDX-License-Identifier: Apache-2.0
// Line width says what matters: how wide each class is, the medium decides.
#include "tactics/filter.h"
#include "tactics/geometry/evidence.h"

namespace tactics {

namespace {

constexpr Option kThickenOptions[] = {
    {.name = "line",
     .type = Option::Type::choice,
     .fallback = 2,
     .min = 0,
     .max = 2,
     .summary = "how the lines become",
     .choices = "thin normal thick"},
    {.name = "share",
     .type = Option::Type::number,
     .fallback = 100,
     .min = 0,
     .max = 100,
     .unit = "percent",
     .summary = "share of the line to change, the strongest and longest strokes first"},
};

LineClass class_of(std::string_view name) {
    return name == "thin" ? LineClass::thin : name == "normal" ? LineClass::normal : LineClass::thick;
}

Artwork apply_thicken(Artwork artwork, const Settings& settings) {
    auto& drawing = std::get<Drawing>(artwork);
    const LineClass line = class_of(settings.choice("line"));
    const double share = settings.number("share");
    if (share >= 100) {
        for (Stroke& stroke : drawing.strokes) stroke.line = line;
        return artwork;
    }
    double rest = total_stroke_length(drawing) * share / 100;
    for (const std::size_t i : by_evidence(drawing.strokes)) {
        // As in the line budget: a stroke counts in if at least half of it does.
        const double length = length_of(drawing.strokes[i]);
        if (length > 2 * rest) break;
        drawing.strokes[i].line = line;
        rest -= length;
    }
    return artwork;
}

}  // namespace

extern const Filter thicken_filter;
const Filter thicken_filter{
    .name = "thicken",
    .summary = "makes lines thin, normal or thick: all of them, or the strongest share",
    .takes = static_cast<Kinds>(Kind::drawing),
    .gives = static_cast<Kinds>(Kind::drawing),
    .options = kThickenOptions,
    .apply = apply_thicken,
};

}  // namespace tactics
