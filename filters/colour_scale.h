// SPDX-License-Identifier: Apache-2.0
// Colours that stand for values: those of a colour bar, or those of a field that has none.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "tactics/image.h"

namespace cv {
class Mat;
}

namespace tactics {

/// Levels that a pixel may be off the colours of its scale: blur and compression leave something between.
inline constexpr double kOnScale = 24;

/// A smooth course through colours, from 0 to 1. One that no bar shows runs towards the darker end.
class ColourScale {
public:
    struct Knot {
        double position = 0;
        std::array<double, 3> colour{};
    };
    explicit ColourScale(std::vector<Knot> knots) : knots_(std::move(knots)) {}

    struct Found {
        double position = 0;
        double away = 0;  ///< levels, from the colour of that position
    };
    Found nearest(const std::uint8_t* rgb) const;
    const std::vector<Knot>& knots() const { return knots_; }

private:
    std::vector<Knot> knots_;
};

/// Of a picture in three channels. Nothing: the strip has more than one colour across, or its colours do not run one way, each
/// unlike all that are not its neighbours. From the bottom up, or from left to right.
std::optional<ColourScale> scale_of_bar(const cv::Mat& picture, const PixelBox& bar);

/// Of a field without a bar: nearly all of its colours lie on one course, as those of no photograph do. Greys always lie on one,
/// so they never have a scale.
std::optional<ColourScale> scale_of_colours(const cv::Mat& picture, const PixelBox& field);

}  // namespace tactics
