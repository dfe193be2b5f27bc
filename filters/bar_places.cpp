// SPDX-License-Identifier: Apache-2.0
#include "filters/bar_places.h"

#include <algorithm>
#include <cmath>

#include "tactics/layout/texture.h"

namespace tactics {

namespace {

// mm from cluster to cluster: things closer than 1/4 in are hard to tell apart (APH Guidelines for Design of Tactile Graphics,
// Design 1.2; L. Hasty, Designing Tactile Graphics: as much may be needed on capsule paper).
constexpr double kApart = 6.4;
// Of a bar's thickness, so that a gap is never taken for a bar. No published number; this project's own, untried by touch.
constexpr double kGapShare = 0.5;
// mm; thicker bars say no more. This project's own, too.
constexpr double kThickest = 25;
constexpr double kBarRounding = 1e-9;

// Between the middles of a bar's lines, mm. A pattern keeps the gap from each line, and half of it from the border of its area.
double thinnest(BarLook look, const Medium& medium) {
    const bool dots = has_fixed_dots(medium);
    const double row = kMarburgMedium.dot_pitch, three_rows = 2 * row;  // what is left for the pattern of dots
    switch (look) {
        case BarLook::outlined: return dots ? three_rows + 6 * row : kLeastTexture + 2 * (medium.gap + medium.line);
        case BarLook::hollow: return std::max(medium.gap + medium.line, kLeastTexture);
        case BarLook::solid: return kTwoRows;
        case BarLook::bare: return dots ? three_rows + 3 * row : kLeastTexture + medium.gap;
    }
    return 0;
}

}  // namespace

std::optional<BarPlaces> bars_on(double length, std::size_t clusters, std::size_t bars, BarLook look, const Medium& medium,
                                 const BarPitch& pitch) {
    const bool cells = pitch.mm > 0;
    const auto up = [&](double mm) { return cells ? std::ceil(mm / pitch.mm - kBarRounding) * pitch.mm : mm; };
    const auto down = [&](double mm) { return cells ? std::floor(mm / pitch.mm + kBarRounding) * pitch.mm : mm; };
    const double count = static_cast<double>(bars), inner = look == BarLook::bare ? 0 : up(medium.gap + medium.line);
    const double slot = down(length / static_cast<double>(clusters)), all_inner = (count - 1) * inner;
    // From the first row of dots of a line of cells to its last, and on by whole lines.
    const double odd = look == BarLook::solid && pitch.lines ? kTwoRows : 0;
    const double least = odd > 0 ? odd : up(thinnest(look, medium));
    const double apart = !cells ? kApart : std::max(kTwoRows, look == BarLook::solid ? 0 : down(kApart));
    const double room = std::min((slot - all_inner) / (count + kGapShare), (slot - all_inner - apart) / count);
    const double wanted = std::clamp(odd + down(room - odd), least, std::max(least, odd + down(kThickest - odd)));
    const BarPlaces places{look, slot, wanted, inner, bars};
    if (slot - places.cluster() < apart - kBarRounding) return std::nullopt;
    return places;
}

}  // namespace tactics
