// SPDX-License-Identifier: Apache-2.0
// ElevationGrid and Extrusion.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "tactics/readers/vrml/placing.h"
#include "tactics/readers/vrml/shape.h"

namespace tactics {

namespace {

Point3 point_of(std::span<const double> numbers, std::size_t i) {
    return {numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]};
}

// Nothing: it has none.
std::optional<Point3> direction_of(const Point3& a) {
    const double length = length_of(a);
    if (!(length > 1e-12) || !std::isfinite(length)) return std::nullopt;
    return (1 / length) * a;
}

// The frame of the section at each point of the spine ("spine-aligned cross-section plane"): y along the spine, z out of the
// plane in which it bends.
class Planes {
public:
    explicit Planes(std::span<const double> spine) : spine_(spine), count_(spine.size() / 3) {
        closed_ = count_ > 2 && point(0) == point(count_ - 1);
        for (std::size_t i = 0; i < count_; ++i) {
            along_.push_back(direction_of(tangent(i)));
            out_.push_back(direction_of(bend(i)));
        }
        fill();
    }
    bool closed() const { return closed_; }
    Placing at(std::size_t i) const {
        const Point3 y = *along_[i], x = direction_of(cross(y, *out_[i])).value_or(Point3{1, 0, 0});
        return {x, y, cross(x, y), point(i)};
    }

private:
    Point3 point(std::size_t i) const { return point_of(spine_, i); }
    std::size_t before(std::size_t i) const { return i > 0 ? i - 1 : closed_ ? count_ - 2 : 0; }
    std::size_t after(std::size_t i) const { return i + 1 < count_ ? i + 1 : closed_ ? 1 : count_ - 1; }
    Point3 tangent(std::size_t i) const { return point(after(i)) - point(before(i)); }
    Point3 bend(std::size_t i) const { return cross(point(after(i)) - point(i), point(before(i)) - point(i)); }

    // Straight parts and repeated points take the frame before them; at the beginning, the frame after them. The ends of an open
    // spine have no bend of their own.
    void fill() {
        take_over(along_);
        if (!along_[0]) along_.assign(count_, Point3{0, 1, 0});
        const bool bends = std::any_of(out_.begin(), out_.end(), [](const auto& one) { return one.has_value(); });
        take_over(out_);
        for (std::size_t i = 0; bends && i < count_; ++i)
            if (i > 0 && dot(*out_[i], *out_[i - 1]) < 0) out_[i] = -1 * *out_[i];
        if (bends) return;
        // A straight spine: all planes are turned as little as brings y along it.
        const Point3 up{0, 1, 0}, axis = cross(up, *along_[0]);
        Placing turn = turned(axis, std::atan2(length_of(axis), dot(up, *along_[0])));
        if (length_of(axis) == 0 && along_[0]->y < 0) turn = turned({0, 0, 1}, std::numbers::pi);  // as Coin has it
        out_.assign(count_, turn.direction({0, 0, 1}));
        along_.assign(count_, *along_[0]);
    }
    static void take_over(std::vector<std::optional<Point3>>& all) {
        for (std::size_t i = 1; i < all.size(); ++i)
            if (!all[i]) all[i] = all[i - 1];
        for (std::size_t i = all.size() - 1; i-- > 0;)
            if (!all[i]) all[i] = all[i + 1];
    }

    std::span<const double> spine_;
    std::size_t count_;
    bool closed_ = false;
    std::vector<std::optional<Point3>> along_, out_;
};

}  // namespace

WorldShape make_elevation(const ElevationFields& fields) {
    WorldShape shape;
    for (std::size_t j = 0; j < fields.along; ++j)
        for (std::size_t i = 0; i < fields.across; ++i)
            shape.vertices.push_back({static_cast<double>(i) * fields.across_step, fields.heights[i + j * fields.across],
                                      static_cast<double>(j) * fields.along_step});
    for (std::size_t j = 0; j + 1 < fields.along; ++j)
        for (std::size_t i = 0; i + 1 < fields.across; ++i) {
            const std::uint32_t at = index32(i + j * fields.across), below = at + index32(fields.across);
            shape.add_face({at, below, below + 1, at + 1});
        }
    return shape;
}

WorldShape make_extrusion(const ExtrusionFields& fields) {
    WorldShape shape;
    const std::size_t stations = fields.spine.size() / 3;
    std::size_t sides = fields.section.size() / 2;
    if (stations < 2 || sides < 2) return shape;
    const auto section = [&](std::size_t i) { return Point3{fields.section[2 * i], 0, fields.section[2 * i + 1]}; };
    const bool ring = sides > 2 && section(0) == section(sides - 1);
    if (ring) --sides;
    const Planes planes(fields.spine);
    // Lists that are too short: their last entry repeats.
    const auto of_list = [](std::span<const double> list, std::size_t size, std::size_t i) {
        const std::size_t entries = list.size() / size;
        return entries == 0 ? std::span<const double>() : list.subspan(size * std::min(i, entries - 1), size);
    };
    for (std::size_t i = 0; i < stations; ++i) {
        Placing here = planes.at(i);
        if (const auto turn = of_list(fields.orientations, 4, i); !turn.empty())
            here = here * turned({turn[0], turn[1], turn[2]}, turn[3]);
        if (const auto scale = of_list(fields.scales, 2, i); !scale.empty()) here = here * scaled({scale[0], 1, scale[1]});
        for (std::size_t j = 0; j < sides; ++j) shape.vertices.push_back(here(section(j)));
    }
    const auto at = [&](std::size_t i, std::size_t j) { return index32((i % stations) * sides + j % sides); };
    for (std::size_t i = 0; i + 1 < stations; ++i)
        for (std::size_t j = 0; j + (ring ? 0 : 1) < sides; ++j)
            shape.add_face({at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)});
    std::vector<std::uint32_t> cap;
    for (std::size_t j = 0; j < sides; ++j) cap.push_back(at(stations - 1, j));
    if (fields.end_cap && !planes.closed()) shape.add_face(cap);
    for (std::size_t j = 0; j < sides; ++j) cap[j] = at(0, sides - 1 - j);
    if (fields.begin_cap && !planes.closed()) shape.add_face(cap);
    shape.one_sided = planes.closed() || (fields.begin_cap && fields.end_cap);
    return shape;
}

}  // namespace tactics
