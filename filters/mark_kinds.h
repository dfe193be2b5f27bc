// SPDX-License-Identifier: Apache-2.0
// What kinds of marks a plot has: forms that are there several times by themselves, but for thin lines that they are on.
#pragma once

#include <vector>

#include "filters/lab.h"
#include "filters/mark_forms.h"
#include "tactics/geometry/skeleton.h"
#include "tactics/image.h"

namespace tactics {

constexpr int kInkOfMarks = 160;         ///< of 255 is the ground
constexpr int kMarkColour = 60;          ///< levels in any channel that marks of one kind may differ by
constexpr std::size_t kFewestMarks = 3;  ///< alike, to be a kind

/// Pixels are counted from the corner of a box that holds the form with some ground around it.
struct MarkKind {
    PixelColour colour{};
    MarkForm shape = MarkForm::disc;
    int width = 0, height = 0;      ///< of the box
    double radius = 0, depth = 0;   ///< half of its larger side; how far its deepest pixel is from the ground
    bool thin = false;              ///< made of lines
    bool joined = false;            ///< only seen where lines meet it, by the ground within
    std::vector<PixelStep> body;    ///< what all of them have
    std::vector<PixelStep> around;  ///< ground where one stands alone, outside and within
    std::vector<PixelStep> hull;    ///< around it, in order
};

/// Marks from `least` to `most` pixels wide and high, those made of lines to three quarters of that. `ink`: ink_on_white of the
/// picture. Empty where there are too many kinds for a plot.
std::vector<MarkKind> mark_kinds_in(const Image& picture, const Image& ink, double least, double most);

}  // namespace tactics
