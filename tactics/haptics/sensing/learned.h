// SPDX-License-Identifier: Apache-2.0
// What a fusion has found of a mouse's sensors and of its overlay, and how sure it is of each: kept from one use to the next, the
// first stroke of the next is known as well as the last of this one.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace tactics {

/// In the order of LearningFilter's states behind place and heading: drift in rad/mm, how unlike the sensors are, their scales,
/// the delays of the overlay in s.
struct LearnedPointing {
    static constexpr std::size_t kValues = 16;
    double judged = 0;  ///< by which speed the overlay's delay goes: 0, 0.5 or 1 (LearningFilter)
    double noise = 0;   ///< mm
    double jitter = 0;  ///< s
    std::array<double, kValues> values{};
    std::array<std::array<double, kValues>, kValues> covariance{};
};

/// Lines of text. Throws Error(failed) where they are others, or no such values can be: read_learned gives what to_text was
/// given.
std::string to_text(const LearnedPointing& learned);
LearnedPointing read_learned(std::string_view text, std::string_view origin);

}  // namespace tactics
