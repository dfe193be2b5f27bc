// SPDX-License-Identifier: Apache-2.0
// Figures of SVG to try the reader on.
#pragma once

#include <optional>
#include <string>

#include "tactics/readers/svg/svg.h"

namespace tactics::tests {

/// What is read of that content of a figure of 200 x 100 mm, with a millimetre as its unit.
inline FoundPage figure(const std::string& body) {
    return read_svg(
        "<svg xmlns='http://www.w3.org/2000/svg' width='200mm' height='100mm' viewBox='0 0 200 100'>" + body + "</svg>",
        "figure.svg", 0, std::nullopt, SvgPurpose::figure);
}

}  // namespace tactics::tests
