// SPDX-License-Identifier: Apache-2.0
// From a file to heights: height maps of ours, pictures (black low, white high) and models seen from above.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tactics/point3.h"
#include "tactics/readers/read.h"
#include "tactics/relief/depth.h"
#include "tactics/text/phrase.h"

namespace tactics {

inline constexpr long long kMostHeights = kMaxWholePixels;  ///< of a map that is read: 480 MB of them

// Defaults if neither the file nor the user gives a value; their use is reported.
inline constexpr double kPixelPitch =
    25.4 / 96;                              ///< mm: a pixel of a screen (W3C CSS Values and Units 3, section 6.2: 1px is 1/96 in)
inline constexpr double kModelPitch = 0.1;  ///< mm
inline constexpr double kPictureHeight =
    10;  ///< mm from black to white; ours: a quarter of the wall of the 1-DOF haptic mouse's paper

/// The user's wishes; absent values come from the file or, failing that, are defaults, which are reported.
struct HeightWish {
    std::optional<double> pitch = {};  ///< mm; of a picture another size, of a model more or fewer samples
    std::optional<double> width =
        {};  ///< mm from the left to the right edge; of a model of the model, which grows in height with it
    std::optional<double> low = {};   ///< mm: height of black, or of the lowest place of a model or of decimal numbers
    std::optional<double> high = {};  ///< mm: height of white, or of the highest place; over `low`
    bool invert = false;              ///< low is high: a mould
};

struct HeightFile {
    HeightMap map;
    double low = 0, high = 0;   ///< mm: what black and white stand for; all heights lie between them, and high is over low
    std::string format;         ///< "16-bit PNG", "STL model", ...
    std::vector<Phrase> notes;  ///< defaults used and data lost: one sentence each, for the user
};

/// A format as a message names it: "16-bit PNG", "STL model", "picture (BMP)", "drawing".
Phrase format_in_words(const std::string& format);

/// Throws Error(usage) for a wish that contradicts itself or the file, with the option's name as its place, and Error(failed),
/// naming the file, for what cannot be read.
HeightFile read_heights(Source& source, const HeightWish& wish);
HeightFile read_heights(const std::string& path, const HeightWish& wish);  ///< "-": standard input

/// The same for a model, with wishes that depend on its shape. `up` as for read_model.
using ModelWish = std::function<HeightWish(const ModelBox& box)>;
HeightFile read_model_heights(Source& source, std::optional<UpAxis> up, const ModelWish& wish);

/// The same for a height file: a model, floating-point numbers, 16-bit grey, or a picture that gives the heights of black and
/// white. Nothing for any other picture. Throws as read_heights does.
std::optional<HeightFile> read_told_heights(Source& source, const HeightWish& wish);

}  // namespace tactics
