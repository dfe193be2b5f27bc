// SPDX-License-Identifier: Apache-2.0
// The metadata of a height file, the same in PNG (tEXt), TIFF (lines of ImageDescription) and EXR (attributes):
//     tactics:pitch-mm    distance of two samples
//     tactics:black-mm    height of black; of decimal numbers the lowest
//     tactics:white-mm    height of white; of decimal numbers the highest
//     tactics:profile     cross-section of lines: round or flat
// Numbers are text without a unit. Decimal numbers are heights in mm themselves.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tactics {

inline constexpr std::string_view kPitchWord = "tactics:pitch-mm", kBlackWord = "tactics:black-mm",
                                  kWhiteWord = "tactics:white-mm", kProfileWord = "tactics:profile";

struct HeightWords {
    std::optional<double> pitch, black, white;  ///< mm
    double resolution_pitch = 0;                ///< mm, from the file's own tags for the resolution; 0: none

    /// Ignores other keys and invalid numbers.
    void take(std::string_view key, std::string_view value);
};

/// One entry per line, `KEY VALUE`. Ignores other lines.
HeightWords height_words(std::string_view lines);

/// In their order; without a profile, no word of it.
std::vector<std::pair<std::string_view, std::string>> words_of(double pitch, double black, double white,
                                                               std::string_view profile);

}  // namespace tactics
