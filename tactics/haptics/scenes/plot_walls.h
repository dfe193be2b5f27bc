// SPDX-License-Identifier: Apache-2.0
// The walls that hold a finger in a plot: the plane of the plot, and its axes, walls that stand on that plane, with a bump at
// each tick.
#pragma once

#include "tactics/haptics/scenes/force_law.h"
#include "tactics/haptics/scenes/plot_frame.h"
#include "tactics/haptics/scenes/scene.h"

namespace tactics {

/// The plane z = 0, felt from above: F = k x with x the depth ("Design of a Haptic Graphing System": "the spring model"), damped
/// while the finger sinks in.
class PlotWall final : public Scene {
public:
    explicit PlotWall(const ForceLaw& law) : law_(law) {}
    Felt feel(const Touch& touch, double dt) noexcept override;
    void begin_again() noexcept override {}

private:
    ForceLaw law_;
};

struct AxisFeel {
    ForceLaw law;
    double bump_height = 1.5;  ///< mm by which a tick stands out of its axis: several times what a finger on the device can
                               ///< detect
    double bump_width = 5;     ///< mm, and at most two thirds of the distance to the next tick
};

/// The axes at the left (x = 0) and at the bottom (y = height): no force until a finger would leave the field, "which eliminates
/// interference with the forces due to the data lines". A tick is a bump with the shape of one period of a cosine, and a finger
/// that slides along the axis rises over it. The force has a potential, so a bump gives back the energy it takes.
class PlotAxes final : public Scene {
public:
    PlotAxes(const PlotFrame& frame, const AxisFeel& feel);
    Felt feel(const Touch& touch, double dt) noexcept override;
    void begin_again() noexcept override {}

private:
    // Ticks along an axis, mm, ascending.
    struct Bumps {
        std::vector<double> at;
        double height, width;
        double rise(double along) const noexcept;   ///< mm
        double slope(double along) const noexcept;  ///< mm per mm
        double from_nearest(double along) const noexcept;
    };
    Bumps bumps_on(std::vector<double> ticks) const;

    AxisFeel feel_;
    double bottom_;
    Bumps left_, below_;
};

struct GridFeel {
    double damping_ns_per_m = 4;  ///< B
    double width = 2;             ///< mm, of a grid line
};

/// The grid: at each tick a thin layer across the field that drags like honey, F = -B v_n. B is full in the middle half of a
/// layer and falls to zero at its sides, so that no force begins abruptly.
class PlotGrid final : public Scene {
public:
    PlotGrid(const PlotFrame& frame, const GridFeel& feel);
    Felt feel(const Touch& touch, double dt) noexcept override;
    void begin_again() noexcept override {}

private:
    double share_at(const std::vector<double>& lines, double along) const noexcept;

    GridFeel feel_;
    std::vector<double> across_, down_;
};

}  // namespace tactics
