// SPDX-License-Identifier: Apache-2.0
// How little is enough for a finger: the rate at which heights, or forces, must be told so that they are wrong by no more than a
// just noticeable difference.
#pragma once

#include "tactics/information/grid.h"

namespace tactics {

/// Bits of the whole grid for an error of so many levels, root mean square (over 0): the rate of a Gaussian source of its
/// spectrum by reverse water-filling (T. Berger, "Rate Distortion Theory", 1971, section 4.5), or as neighbour_bits has it
/// of the grid quantised to that error, whichever is less: a wall is no Gaussian. The spectrum is the mean over at most 16
/// squares of at most 128 cells, each without its plane and under a Hann window, slices of voxels apart; the code is that of all
/// of it, or of bands of rows with 130,000 cells.
double felt_bits(const LevelGrid& grid, double error);

/// The first of the two, bits a cell.
double gaussian_rate(const LevelGrid& grid, double error);

/// mm, root mean square: heights that are wrong by no more are taken for the same. Ours, for want of a source for relief under a
/// finger that moves: it is the height of a braille dot (0.48 mm, NLS Specification 800), which is made to be told from nothing.
inline constexpr double kFeltHeight = 0.5;

/// Forces are told apart when they differ by a tenth (5 to 10 %: X.-D. Pang, H. Z. Tan, N. I. Durlach 1991; L. A. Jones 1989).
inline constexpr double kWeberForce = 0.1;

/// How many forces a finger tells apart from `least` to `most`, N: as many such steps as lie between, to the nearest; at least 1.
int weber_levels(double least, double most);

}  // namespace tactics
