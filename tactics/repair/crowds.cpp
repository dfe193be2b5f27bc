// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "tactics/geometry/evidence.h"
#include "tactics/repair/means.h"

namespace tactics {

namespace {

// Chosen on the even half of 100 photographs of BSDS500 (`tactics evaluate --study page -r sobel-kmeans -r sobel --half even`):
// the harmonic mean of P3 and R3 is level between 0.5 and 0.8 of the ground, 18 and 34 mm, 15 and 30 mm. Lines that lie as they
// will cannot use all ground.
constexpr double kMostGround = 0.6;
constexpr double kShort = 20;  // mm: what is longer can be followed out of the crowd

// A line's surroundings are a square of 26 mm, about what lies under two fingers.
constexpr double kCell = 2;        // mm
constexpr std::size_t kReach = 6;  // cells on each side

// How much of the ground round a place is taken by lines and the gaps beside them.
class Ground {
public:
    struct Taken {
        std::uint32_t cell;
        double room;  // mm2
    };

    Ground(double width, double height) : columns_(cells(width)), rows_(cells(height)), taken_(columns_ * rows_) {}

    std::vector<Taken> taken_by(const Stroke& stroke, double beside) const {
        std::vector<Taken> parts;
        const std::size_t n = stroke.points.size(), sides = stroke.closed || n == 0 ? n : n - 1;
        for (std::size_t i = 0; i < sides; ++i) {
            const Point a = stroke.points[i], b = stroke.points[(i + 1) % n];
            const double length = distance(a, b), steps = std::max(1.0, std::round(length / kCell));
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
    static std::size_t cells(double side) { return static_cast<std::size_t>(side / kCell) + 1; }

    std::uint32_t cell(Point at) const {
        const auto place = [](double along, std::size_t count) {
            return static_cast<std::size_t>(std::clamp(along / kCell, 0.0, static_cast<double>(count - 1)));
        };
        return static_cast<std::uint32_t>(place(at.y, rows_) * columns_ + place(at.x, columns_));
    }

    double round_it(std::uint32_t cell) const {
        const std::size_t x = cell % columns_, y = cell / columns_;
        const std::size_t left = x - std::min(x, kReach), right = std::min(columns_, x + kReach + 1);
        const std::size_t top = y - std::min(y, kReach), bottom = std::min(rows_, y + kReach + 1);
        double sum = 0;
        for (std::size_t row = top; row < bottom; ++row)
            for (std::size_t column = left; column < right; ++column) sum += taken_[row * columns_ + column];
        return sum / (static_cast<double>((right - left) * (bottom - top)) * kCell * kCell);
    }

    std::size_t columns_, rows_;
    std::vector<double> taken_;  // mm2 in each cell
};

}  // namespace

Mends thin_crowds(Drawing& drawing, const Medium& medium) {
    Mends changes;
    const auto may_go = [](const Stroke& stroke) { return stroke.strength > 0 && length_of(stroke) < kShort; };
    if (std::none_of(drawing.strokes.begin(), drawing.strokes.end(), may_go)) return changes;
    Ground ground(drawing.width, drawing.height);
    std::vector<std::vector<Ground::Taken>> parts;
    parts.reserve(drawing.strokes.size());
    for (const Stroke& stroke : drawing.strokes) {
        parts.push_back(ground.taken_by(stroke, width_of(stroke.line, medium) + medium.gap));
        ground.take(parts.back(), 1);
    }
    std::vector<bool> goes(drawing.strokes.size());
    const std::vector<std::size_t> order = by_evidence(drawing.strokes);
    std::for_each(order.rbegin(), order.rend(), [&](std::size_t i) {
        const Stroke& stroke = drawing.strokes[i];
        if (!may_go(stroke) || ground.round_it(parts[i]) <= kMostGround) return;
        ground.take(parts[i], -1);
        goes[i] = true;
        changes.push_back({Mend::Kind::left_out, stroke.points.front(), length_of(stroke)});
    });
    std::size_t at = 0;
    std::erase_if(drawing.strokes, [&](const Stroke&) { return goes[at++]; });
    return changes;
}

}  // namespace tactics
