// The line budget. More lines than a hand can follow make a sheet harder to know, not easier: in a simulated matching by
// touch, 75 to 150 mm of line on a square of 63 mm (the paper's 2.5 in) were matched far more often than more. Of 20 sheets
// simulated readers find 0.92 with 150 mm, 0.98 with 120 mm and 0.99 with 100 mm (tactics evaluate --study matching), while
// of the contours that people drew 0.22, 0.19 and 0.16 are kept.
//
// For other sizes nothing was measured. A hand that remembers the same scene wants line in proportion to the side; a finger
// that wants the same room between lines, in proportion to the area. The budget goes between them, as side to the 5/3: A4
// has 0.7 to 1 m.
#include <cmath>

#include "filters/evidence.h"
#include "tactics/filter.h"

namespace tactics {

namespace {

constexpr Option kOptions[] = {
    {.name = "line", .type = Option::Type::length, .fallback = 120, .min = 1, .max = 100'000, .unit = "mm",
     .summary = "how much line is kept on a square of 63 mm; a larger drawing has more, as its side to the 5/3", .choices = ""},
};

constexpr double kMeasuredSide = 63;

double budget_for(const Drawing& drawing, double line) {
    const double side = std::sqrt(drawing.width * drawing.height);
    return line * std::pow(side / kMeasuredSide, 5.0 / 3);
}

// Whole strokes, most evidence first. The first that does not fit is kept if at least half of it does, for a line cut off
// at an arbitrary place would tell a finger of an end that is not there; then all is said. So a larger budget only adds.
Artwork apply(Artwork artwork, const Settings& settings) {
    auto& drawing = std::get<Drawing>(artwork);
    double rest = budget_for(drawing, settings.number("line"));
    std::vector<bool> kept(drawing.strokes.size(), false);
    bool first = true;
    for (const std::size_t i : by_evidence(drawing.strokes)) {
        const double length = length_of(drawing.strokes[i]);
        if (!first && length > 2 * rest) break;
        kept[i] = true;
        first = false;
        rest -= length;
        if (rest <= 0) break;
    }
    std::vector<Stroke> strokes;
    for (std::size_t i = 0; i < kept.size(); ++i)
        if (kept[i]) strokes.push_back(std::move(drawing.strokes[i]));
    drawing.strokes = std::move(strokes);
    return artwork;
}

}  // namespace

extern const Filter strongest_filter;
const Filter strongest_filter{
    .name = "strongest",
    .summary = "keeps the strongest and longest lines, up to a budget of line that a finger can follow",
    .takes = static_cast<Kinds>(Kind::drawing),
    .gives = static_cast<Kinds>(Kind::drawing),
    .uses_colour = false,
    .options = kOptions,
    .apply = apply,
};

}  // namespace tactics
