// SPDX-License-Identifier: Apache-2.0
// The number of classes that a picture needs.
#pragma once

#include <functional>

#include "tactics/text/phrase.h"

namespace tactics {

struct LevelChoice {
    int k = 1;
    double explained = 1;  ///< share of the picture's variance that this many classes explain
    bool noise = false;    ///< the residual is no more than the picture's noise
    bool ended = false;    ///< more would be needed, but a finger could not tell them apart
};

/// The least k for which `unexplained(k)`, the variance that the best k classes leave, is no more than that of the picture's
/// noise; or no more than a tenth of the whole, if one class more would not take nine tenths of that, too. At least `least`, at
/// most as many as there are textures.
///
/// A tenth is this project's own: even shades from black to white, which have no classes of their own, need four then, and what
/// has four plain greys is not given three.
LevelChoice choose_levels(const std::function<double(int)>& unexplained, double noise_variance, int least);

/// "3 greys explain 94 % of its variance"
Phrase reason_of(const LevelChoice& choice, bool of_colours);

}  // namespace tactics
