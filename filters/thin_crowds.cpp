// SPDX-License-Identifier: Apache-2.0
// Room for what matters: in a crowd of short lines, such as grass or gravel, a finger finds nothing.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "tactics/filter.h"
#include "tactics/geometry/evidence.h"
#include "tactics/text/phrase.h"
#include "tactics/units.h"

namespace tactics {

namespace {

// Defaults are chosen on the even half of 100 photographs of BSDS500 (`tactics evaluate --study page -r sobel-kmeans -r sobel
// --half even`): the harmonic mean of P3 and R3 is level between 0.5 and 0.8 of the ground, and between 15 and 30 mm. A hundred
// lines, so that the faces among the samples keep their eyes on sheets of 2.5 inches, is ours.
constexpr Option kThinCrowdsOptions[] = {
    {.name = "ground",
     .type = Option::Type::number,
     .fallback = 0.6,
     .min = 0,
     .max = 100,
     .summary =
         "share of the ground that lines may take with their gaps, in a square of 26 mm round each; 1 is line beside line"},
    {.name = "short",
     .type = Option::Type::length,
     .fallback = 20,
     .min = 0,
     .max = 1000,
     .unit = "mm",
     .summary = "longer lines stay, as a finger can follow them out of the crowd"},
    {.name = "few",
     .type = Option::Type::whole,
     .fallback = 100,
     .min = 0,
     .max = 1e6,
     .summary = "so many lines stay in any case, as a finger can look at each"},
    {.name = "gap",
     .type = Option::Type::length,
     .fallback = 4.2,
     .min = 0.5,
     .max = 50,
     .unit = "mm",
     .summary = "minimum distance between the middles of two lines"},
};

// A line's surroundings are a square of 26 mm, about what lies under two fingers.
constexpr double kGroundCell = 2;        // mm
constexpr std::size_t kCellsAround = 6;  // cells on each side

// How much of the ground round a place is taken by lines and the gaps beside them.
class CrowdedGround {
public:
    struct Taken {
        std::uint32_t cell;
        double room;  // mm2
    };

    CrowdedGround(double width, double height) : columns_(cells(width)), rows_(cells(height)), taken_(columns_ * rows_) {}

    std::vector<Taken> taken_by(const Stroke& stroke, double beside) const {
        std::vector<Taken> parts;
        const std::size_t n = stroke.points.size(), sides = stroke.closed || n == 0 ? n : n - 1;
        for (std::size_t i = 0; i < sides; ++i) {
            const Point a = stroke.points[i], b = stroke.points[(i + 1) % n];
            const double length = distance(a, b), steps = std::max(1.0, std::round(length / kGroundCell));
            for (double k = 0.5; k < steps; ++k)
                parts.push_back({cell({a.x + k / steps * (b.x - a.x), a.y + k / steps * (b.y - a.y)}), length / steps * beside});
        }
        return parts;
    }

    void take(const std::vector<Taken>& parts, double times) {
        for (const Taken& part : parts) taken_[part.cell] += times * part.room;
    }

    // The mean along a line, as a share.
    double round_it(const std::vector<Taken>& parts) const {
        double sum = 0, all = 0;
        for (const Taken& part : parts) {
            sum += part.room * round_it(part.cell);
            all += part.room;
        }
        return all > 0 ? sum / all : 0;
    }

private:
    static std::size_t cells(double side) { return static_cast<std::size_t>(side / kGroundCell) + 1; }

    std::uint32_t cell(Point at) const {
        const auto place = [](double along, std::size_t count) {
            return static_cast<std::size_t>(std::clamp(along / kGroundCell, 0.0, static_cast<double>(count - 1)));
        };
        return static_cast<std::uint32_t>(place(at.y, rows_) * columns_ + place(at.x, columns_));
    }

    double round_it(std::uint32_t cell) const {
        const std::size_t x = cell % columns_, y = cell / columns_;
        const std::size_t left = x - std::min(x, kCellsAround), right = std::min(columns_, x + kCellsAround + 1);
        const std::size_t top = y - std::min(y, kCellsAround), bottom = std::min(rows_, y + kCellsAround + 1);
        double sum = 0;
        for (std::size_t row = top; row < bottom; ++row)
            for (std::size_t column = left; column < right; ++column) sum += taken_[row * columns_ + column];
        return sum / (static_cast<double>((right - left) * (bottom - top)) * kGroundCell * kGroundCell);
    }

    std::size_t columns_, rows_;
    std::vector<double> taken_;  // mm2 in each cell
};

Artwork apply_thin_crowds(Artwork artwork, const Settings& settings) {
    auto& drawing = std::get<Drawing>(artwork);
    const double most = settings.number("ground"), longest = settings.number("short");
    CrowdedGround ground(drawing.width, drawing.height);
    std::vector<std::vector<CrowdedGround::Taken>> parts;
    parts.reserve(drawing.strokes.size());
    for (const Stroke& stroke : drawing.strokes) {
        parts.push_back(ground.taken_by(stroke, settings.number("gap")));
        ground.take(parts.back(), 1);
    }
    std::vector<bool> goes(drawing.strokes.size());
    std::size_t left = drawing.strokes.size();
    const auto few = static_cast<std::size_t>(settings.number("few"));
    const std::vector<std::size_t> order = by_evidence(drawing.strokes);
    std::for_each(order.rbegin(), order.rend(), [&](std::size_t i) {
        if (left <= few || length_of(drawing.strokes[i]) >= longest || ground.round_it(parts[i]) <= most) return;
        ground.take(parts[i], -1);
        goes[i] = true;
        --left;
    });
    const std::size_t all = drawing.strokes.size();
    if (left < all)
        drawing.remarks.push_back(phrases(all - left, "Of {1} edges, {0} short one in a crowd is left out.",
                                          "Of {1} edges, {0} short ones in crowds are left out.", std::to_string(all)));
    std::size_t at = 0;
    std::erase_if(drawing.strokes, [&](const Stroke&) { return goes[at++]; });
    return artwork;
}

void fit_thin_crowds(Settings& settings, const Medium& medium) {
    if (settings.is_default("gap")) settings.set("gap", to_text(medium.gap + medium.line), "thin-crowds", "thin-crowds");
}

}  // namespace

extern const Filter thin_crowds_filter;
const Filter thin_crowds_filter{
    .name = "thin-crowds",
    .summary = "of many short lines in a crowd, keeps the strongest",
    .takes = static_cast<Kinds>(Kind::drawing),
    .gives = static_cast<Kinds>(Kind::drawing),
    .options = kThinCrowdsOptions,
    .apply = apply_thin_crowds,
    .fit = fit_thin_crowds,
    .in_full = "-",
};

}  // namespace tactics
