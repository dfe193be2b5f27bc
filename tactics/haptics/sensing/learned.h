// SPDX-License-Identifier: Apache-2.0
// A fusion's learned parameters of a mouse's sensors and overlay, with their uncertainties. Kept from one use to the next, they
// make the first stroke as accurate as the last one before.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace tactics {

/// In the order of LearningFilter's states after place and heading: drift in rad/mm, difference of the sensors, their scales, the
/// delays of the overlay in s.
struct LearnedPointing {
    static constexpr std::size_t kValues = 16;
    double judged = 0;  ///< which speed determines the overlay's delay: 0, 0.5 or 1 (LearningFilter)
    double noise = 0;   ///< mm
    double jitter = 0;  ///< s
    std::array<double, kValues> values{};
    std::array<std::array<double, kValues>, kValues> covariance{};
};

/// Lines of text. read_learned returns what to_text was given; it throws Error(failed) for other lines or impossible values.
std::string to_text(const LearnedPointing& learned);
LearnedPointing read_learned(std::string_view text, std::string_view origin);

}  // namespace tactics
