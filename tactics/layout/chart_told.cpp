// SPDX-License-Identifier: Apache-2.0
#include "tactics/layout/chart_told.h"

#include <string>

namespace tactics {

Phrase told_of_grid(std::size_t lines) {
    return phrase("{0} lines of a grid are left out; draw them in black and whole to have them drawn", std::to_string(lines));
}

Phrase told_of_noise(std::size_t curves) {
    return phrases(curves, "{0} curve goes up and down faster than a finger can follow, and is drawn through the middle of that.",
                   "{0} curves go up and down faster than a finger can follow, and are drawn through the middle of that.");
}

}  // namespace tactics
