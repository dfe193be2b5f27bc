// SPDX-License-Identifier: Apache-2.0
// What a figure of SVG stands on: a surface as large as the page, drawn before all else. It is no part of the drawing.
#pragma once

#include <optional>
#include <vector>

#include "tactics/page.h"
#include "tactics/readers/svg/svg_path.h"
#include "tactics/readers/svg/svg_style.h"

namespace tactics {

/// What of a figure is seen: first what most are made of.
enum class SvgLook { plain, gleams, on_dark };

class Ground {
public:
    explicit Ground(SvgLook look)
        : only_(look != SvgLook::plain), lightness_(look == SvgLook::on_dark ? std::optional(0.0) : std::nullopt) {}

    /// True: this surface is the ground, as nothing has been drawn so far and it covers all of the page. Else its paints become
    /// what they would be on a white ground: light lines on a dark one are dark lines.
    bool takes(const std::vector<Subpath>& surface, Paint& fill, Paint& stroke, const Page& page);

    /// As light as it would be on a white ground.
    double on_white(double lightness) const { return lightness_ && *lightness_ < 0.5 ? 1 - lightness : lightness; }

private:
    bool only_;  // there is nothing else: it is what is drawn
    std::optional<double> lightness_;
};

}  // namespace tactics
