// SPDX-License-Identifier: Apache-2.0
// Nothing beside braille that could be mistaken for a dot.
#include <algorithm>
#include <cmath>

#include "tactics/rules/page_geometry.h"
#include "tactics/rules/rule.h"

namespace tactics {

namespace {

// Limit of pixels examined beside braille.
constexpr std::size_t kMostPixels = 100'000'000;

struct Nearby {
    double apart;
    Point at;
    Phrase what;
};

// The pixel of a picture nearest to the box, if it is nearer than the best so far.
void look_at_picture(const Bitmap& picture, const Box& box, Nearby& nearest_thing, std::size_t& budget) {
    if (picture.width <= 0 || picture.height <= 0) return;
    const double across = picture.place.width / picture.width, down = picture.place.height / picture.height;
    if (!(across > 0) || !(down > 0)) return;
    const auto clamped = [](double value, int most) {
        return static_cast<int>(std::clamp(value, 0.0, static_cast<double>(most)));
    };
    const double reach = nearest_thing.apart;
    const int left = clamped(std::floor((box.left - reach - picture.place.left) / across), picture.width);
    const int right = clamped(std::ceil((box.right + reach - picture.place.left) / across), picture.width);
    const int top = clamped(std::floor((box.top - reach - picture.place.top) / down), picture.height);
    const int bottom = clamped(std::ceil((box.bottom + reach - picture.place.top) / down), picture.height);
    for (int y = top; y < bottom; ++y)
        for (int x = left; x < right; ++x) {
            if (budget == 0) return;
            --budget;
            const std::size_t byte = static_cast<std::size_t>(y) * picture.row_bytes() + static_cast<std::size_t>(x) / 8;
            if ((picture.bits[byte] >> (7 - x % 8) & 1) == 0) continue;
            const Box pixel{picture.place.left + x * across, picture.place.top + y * down, picture.place.left + (x + 1) * across,
                            picture.place.top + (y + 1) * down};
            const double apart = distance(box, pixel);
            if (apart < nearest_thing.apart) nearest_thing = {apart, {pixel.left, pixel.top}, phrase("a picture")};
        }
}

Findings check_braille_clearance(const PageGeometry& geometry, double limit) {
    if (geometry.braille.empty()) return {};
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < geometry.pieces.size(); ++i) boxes.push_back(geometry.box_of_piece(i, 0));
    const Grid grid(std::move(boxes), geometry.page.width, geometry.page.height);
    Findings findings;
    std::size_t budget = kMostPixels;
    for (const Box& braille : geometry.braille) {
        const Point middle{(braille.left + braille.right) / 2, (braille.top + braille.bottom) / 2};
        Nearby found{limit - kRounding, {}, {}};
        grid.any_near({braille.left - limit, braille.top - limit, braille.right + limit, braille.bottom + limit},
                      [&](std::size_t i) {
                          const Chain& chain = geometry.chains[geometry.pieces[i].chain];
                          const Nearest near = nearest(geometry.pieces[i].line, braille);
                          const double apart = std::max(0.0, near.distance - chain.half_width);
                          if (apart < found.apart) found = {apart, near.one, chain.ring ? phrase("an area") : phrase("a line")};
                          return apart == 0;
                      });
        if (geometry.black_area_at(middle)) found = {0, middle, phrase("an area")};
        if (geometry.page.picture) look_at_picture(*geometry.page.picture, braille, found, budget);
        if (found.what.empty()) continue;
        findings.places.push_back({found.apart, found.at, middle,
                                   found.apart > 0 ? phrase("{0} {1} mm from braille", found.what, shown(found.apart))
                                                   : phrase("{0} in braille", found.what)});
        if (findings.places.size() > kMostPlaces) break;
    }
    findings.complete = budget > 0;
    return findings;
}

}  // namespace

extern const Rule braille_clearance_rule;
const Rule braille_clearance_rule{
    .name = "braille-clearance",
    .summary = "nothing beside braille that could be taken for a dot",
    .mend = "move the braille or break the line beside it",
    .source =
        "L. Hasty, Designing Tactile Graphics: 1/8 in between any two elements; BANA Guidelines 2.11, 3.4.3.13: blank space "
        "round braille. Measured from all cells, blank ones too, between the first and the last with a dot",
    .confidence = Confidence::good,
    .hard = true,
    .limit = {.name = "least",
              .type = Option::Type::length,
              .fallback = 3.2,
              .min = 0.1,
              .max = 50,
              .unit = "mm",
              .summary = "minimum distance from a cell to the edge of anything else"},
    .check = check_braille_clearance,
};

}  // namespace tactics
