// SPDX-License-Identifier: Apache-2.0
// Contour scores as the Berkeley benchmark has them (D. Martin, C. Fowlkes, J. Malik 2004; P. Arbelaez et al. 2011).
#pragma once

#include <span>
#include <vector>

#include "tactics/image.h"
#include "tactics/measure/matching.h"

namespace tactics {

/// Pixels counted. They add up over annotators and pictures before any ratio is taken.
struct Counts {
    long long found = 0;  ///< of the annotators' pixels, those with a partner; each annotator counts
    long long truth = 0;  ///< all of them
    long long right = 0;  ///< of the line pixels, those with a partner in any annotator's map
    long long lines = 0;  ///< all of them

    Counts& operator+=(const Counts& other);
    double precision() const;  ///< 0 without lines
    double recall() const;     ///< 0 without truth
    double f() const;          ///< harmonic mean of both
};

/// The maximum distance of a pair: 0.75 % of the diagonal.
double reach_of(int width, int height);

/// The strengths at which lines are cut, in grey levels, falling; the last is 0: everything.
std::span<const float> levels();

/// The score at each level. The annotators' maps have the size of the lines.
std::vector<Counts> score_at_levels(const EdgeMap& lines, std::span<const PixelSet> annotators);

/// That annotator's map scored against the others'; nothing with fewer than two.
Counts score_person(std::span<const PixelSet> annotators, std::size_t one);

/// All of them, added up.
Counts score_people(std::span<const PixelSet> annotators);

}  // namespace tactics
