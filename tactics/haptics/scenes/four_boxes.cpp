// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/scenes/four_boxes.h"

#include <algorithm>
#include <cmath>

namespace tactics {

namespace {

// A sum of some products of rounded numbers is wrong by less than 20 roundings (2^-24 each) of the largest.
constexpr float kWrong = 4e-6f;

float largest_of(const Point3& p) noexcept { return static_cast<float>(std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)})); }

Point3 from(const float* origin, const Point3& place) noexcept {
    return {place.x - double{origin[0]}, place.y - double{origin[1]}, place.z - double{origin[2]}};
}

}  // namespace

FourBoxes::FourBoxes() noexcept {
    for (std::size_t k = 0; k < 3; ++k) low[k] = high[k] = all_four(kNowhere);
}

void FourBoxes::take(std::size_t lane, const FourBoxes& from, std::size_t its) noexcept {
    for (std::size_t k = 0; k < 3; ++k) {
        low[k][lane] = from.low[k][its];
        high[k][lane] = from.high[k][its];
    }
}

WideWay::WideWay(const Point3& from, const Point3& way, float around) noexcept
    : start(from), inverse(way), wide(around), share(1) {
    for (Four& along : inverse.at) along = 1 / (along == 0 ? all_four(1e-30f) : along);
}

FourFacets::FourFacets(const FacetCorners* facets, std::uint32_t first_, std::uint32_t count_) noexcept
    : x{},
      z{},
      x0{},
      y0{},
      z0(all_four(FourBoxes::kNowhere)),
      length{},
      in_x{},
      in_y{},
      origin{},
      size(0),
      first(first_),
      count(count_) {
    Point3 middle;
    for (std::uint32_t i = 0; i < count; ++i) middle = middle + (1.0 / (3 * count)) * (facets[i].a + facets[i].b + facets[i].c);
    origin[0] = static_cast<float>(middle.x);
    origin[1] = static_cast<float>(middle.y);
    origin[2] = static_cast<float>(middle.z);
    for (std::uint32_t i = 0; i < count; ++i) {
        Point3 at[3] = {from(origin, facets[i].a), from(origin, facets[i].b), from(origin, facets[i].c)};
        for (const Point3& corner : at) size = std::max(size, largest_of(corner));
        const auto side = [&](std::size_t k) { return length_of(at[(k + 1) % 3] - at[k]); };
        std::rotate(at, at + (side(1) > side(0) ? side(2) > side(1) ? 2 : 1 : side(2) > side(0) ? 2 : 0), at + 3);
        put(i, at);
    }
}

void FourFacets::put(std::uint32_t lane, const Point3* at) noexcept {
    const Point3 along = unit(at[1] - at[0]), over = unit(cross(at[1] - at[0], at[2] - at[0])), across = cross(over, along);
    const auto axis = [&](const Point3& is, Four* axes) {
        axes[0][lane] = static_cast<float>(is.x);
        axes[1][lane] = static_cast<float>(is.y);
        axes[2][lane] = static_cast<float>(is.z);
    };
    axis(along, x);
    axis(over, z);
    x0[lane] = static_cast<float>(-dot(along, at[0]));
    y0[lane] = static_cast<float>(-dot(across, at[0]));
    z0[lane] = static_cast<float>(-dot(over, at[0]));
    const double far = dot(along, at[1] - at[0]), apex_x = dot(along, at[2] - at[0]), apex_y = dot(across, at[2] - at[0]);
    length[lane] = static_cast<float>(far);
    const double from_end = std::hypot(far - apex_x, apex_y), from_start = std::hypot(apex_x, apex_y);
    in_x[0][lane] = static_cast<float>(-apex_y / from_end);
    in_y[0][lane] = static_cast<float>((apex_x - far) / from_end);
    in_x[1][lane] = static_cast<float>(apex_y / from_start);
    in_y[1][lane] = static_cast<float>(-apex_x / from_start);
}

void FourFacets::take_y(Four* y) const noexcept {
    y[0] = z[1] * x[2] - z[2] * x[1];
    y[1] = z[2] * x[0] - z[0] * x[2];
    y[2] = z[0] * x[1] - z[1] * x[0];
}

// The part of the way on which it is no farther than `reach` from the facet's plane and from being over the facet.
unsigned FourFacets::may_meet(const Point3& ball, const Point3& way, double radius) const noexcept {
    const Point3 off = from(origin, ball);
    const FourPoints start(off), along(way);
    const Four reach = all_four(static_cast<float>(radius) * (1 + kWrong) + kWrong * (largest_of(off) + largest_of(way) + size));
    Four enter{}, leave = all_four(1);
    const auto keep_in = [&](Four far, Four rate) {  // to where far + share * rate is 0 or more
        rate = rate == 0 ? all_four(1e-30f) : rate;
        const Four when = -far / rate;
        enter = larger(enter, rate > 0 ? when : enter);
        leave = smaller(leave, rate > 0 ? leave : when);
    };
    const Four up = dot(z, start) + z0, rises = dot(z, along);
    keep_in(reach + up, rises);
    keep_in(reach - up, -rises);
    Four y[3];
    take_y(y);
    const Four at_x = dot(x, start) + x0, at_y = dot(y, start) + y0, by_x = dot(x, along), by_y = dot(y, along);
    keep_in(reach + at_y, by_y);
    keep_in(reach + in_x[0] * (at_x - length) + in_y[0] * at_y, in_x[0] * by_x + in_y[0] * by_y);
    keep_in(reach + in_x[1] * at_x + in_y[1] * at_y, in_x[1] * by_x + in_y[1] * by_y);
    return lanes_of(enter <= leave);
}

// From the triangle it is as far as from its plane and, beside it, from the rectangle around its longest side or a line along
// another side: what is more.
Four FourFacets::squared_at_least(const Point3& place) const noexcept {
    const Point3 off = from(origin, place);
    const FourPoints at(off);
    const Four wrong = all_four(kWrong * (largest_of(off) + size)), none{};
    Four y[3];
    take_y(y);
    const Four up = dot(z, at) + z0, at_x = dot(x, at) + x0, at_y = dot(y, at) + y0;
    const Four over = larger(larger(up, -up) - wrong, none);
    const Four below = larger(-at_y - wrong, none), beside = larger(larger(-at_x, at_x - length) - wrong, none);
    const Four aside = larger(-in_x[0] * (at_x - length) - in_y[0] * at_y, -in_x[1] * at_x - in_y[1] * at_y);
    const Four out = larger(aside - wrong, none);
    return (over * over + larger(below * below + beside * beside, out * out)) * (1 - kWrong);
}

}  // namespace tactics
