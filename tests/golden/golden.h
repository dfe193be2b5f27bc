// SPDX-License-Identifier: Apache-2.0
// Golden images: results that a person has examined and found right.
//
// expect_golden("filters/sobel", picture) compares with tests/golden/filters/sobel.png. When it differs, the build folder
// gets golden-failures/filters/sobel.png: expected, difference and actual side by side. TACTICS_REGENERATE=1 in the
// environment writes the golden instead, and the test still fails that time, so that nobody regenerates without looking.
#pragma once

#include <string>
#include <string_view>

#include "tactics/artwork.h"

namespace tactics::golden {

/// How far two compilers may be apart: shares of pixels that differ by more than kLevels.
inline constexpr int kLevels = 12;
inline constexpr double kShare = 0.004;

/// Adds a test failure if the picture is not the golden one. Grey or colour, at most 512 x 512.
void expect_golden(std::string_view name, const Image& actual, double share = kShare);

/// The golden picture itself, for tests that start from one. Throws std::runtime_error if it is missing.
Image read_golden(std::string_view name);
bool has_golden(std::string_view name);

/// Any artwork as a picture: edges as grey, a drawing at `pixels_per_mm` with lines of 0.7, 1 and 3 mm.
Image picture_of(const Artwork& artwork, double pixels_per_mm = 3);

Image read_png(const std::string& path);
void write_png(const Image& image, const std::string& path);

}  // namespace tactics::golden
