// SPDX-License-Identifier: Apache-2.0
// How a blindfolded hand follows a line that attracts its finger (scenes/fixture.h): pushes on along its way, gives in to what
// pulls it aside, and feels its way round corners.
#pragma once

#include <array>
#include <cstddef>

#include "tactics/point3.h"

namespace tactics {

/// One walk along a line in the plane, from where the finger rests on it as far as the line goes that way. Knows places and
/// forces only as a person does (hand.h). Nothing allocates.
///
/// Where the finger does not get on, the line ends or has a corner: the hand tries other directions, the slightest turn first. A
/// try that leads back over the places that it came by is none, and if none is left, that was the end. So is where it goes to and
/// fro between corners that it knows.
class LineWalk {
public:
    enum class State { walks, ended, closed };  ///< closed: it came back to where it began, the same way

    /// From `finger` towards `way`, a unit vector, at `speed`, mm/s.
    void begin(const Point3& finger, const Point3& way, double speed) noexcept;
    /// One tick: `force` in N as it is felt by now, `at` is where the hand holds, mm, in and out.
    State go(const Point3& finger, const Point3& force, double dt, Point3& at) noexcept;

    const Point3& end() const noexcept { return corner_; }       ///< once it has ended
    const Point3& came_by() const noexcept { return came_by_; }  ///< direction in which it arrived there, of length 1

private:
    void push_on(const Point3& force, double dt, Point3& at) noexcept;
    void remember() noexcept;
    State stop() noexcept;
    bool try_next() noexcept;
    bool was_here(double within) const noexcept;
    Point3 way_back() const noexcept;
    bool is_back() noexcept;
    bool is_to_and_fro() noexcept;

    Point3 finger_, before_, way_, velocity_, start_, start_way_, corner_, came_by_;
    double speed_ = 0, stalled_ = 0, free_ = 0, returns_ = 0;
    bool trying_ = false, left_ = false, past_start_ = false;
    std::size_t tries_ = 0;
    std::array<Point3, 64> places_{};  // that it came by, a millimetre apart; a ring
    std::size_t placed_ = 0, placed_at_corner_ = 0;
    std::array<Point3, 16> corners_{};  // the last ones; a ring
    std::size_t cornered_ = 0, again_ = 0;
};

}  // namespace tactics
