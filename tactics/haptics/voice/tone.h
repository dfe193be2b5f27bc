// SPDX-License-Identifier: Apache-2.0
// A value as a tone: its pitch is the value, its stereo position follows the finger.
#pragma once

#include <cstdint>
#include <span>

namespace tactics {

/// The current sound.
struct Tone {
    double value = 0;  ///< 0 to 1: from the lowest to the highest pitch
    double side = 0;   ///< 0 to 1: from the left ear to the right
    std::uint8_t series = 0;
    bool sounds = false;
};

inline constexpr int kToneRate = 44'100;  ///< frames per second, each with a sample for the left ear and one for the right

/// MIDI notes 45 to 93, four octaves: 110 to 1760 Hz. L. Brown, S. Brewster, R. Ramloll, M. Burton, B. Riedel, "Design guidelines
/// for audio presentation of graphs and tables", ICAD 2003, use notes 35 to 100, which listeners distinguish well, and instrument
/// sounds rather than sines; small loudspeakers are weak below 110 Hz, and harmonics need room above.
inline constexpr double kLowestTone = 110, kHighestTone = 1760;  ///< Hz
/// Pitch is perceived by ratios, so equal steps of the value are equal intervals.
double tone_frequency(double value);

/// Renders tones without clicks: the phase is continuous, pitch and side glide within some 10 ms, and loudness rises and falls
/// over 10 ms along half a period of a cosine. Even series have all harmonics up to the fourth (1/n), odd ones only the odd
/// harmonics, hollow like a clarinet. The same tones give the same samples.
class ToneSynthesiser {
public:
    /// `samples` are pairs. NaN is silence.
    void render(const Tone& tone, std::span<std::int16_t> samples);

private:
    double phase_ = 0;    // 0 to 1
    double swell_ = 0;    // 0 to 1
    double pitch_ = 0;    // logarithm of the frequency; that of the previous tone while it fades
    double side_ = 0.5;   // 0 to 1
    double hollow_ = 0;   // 0 to 1
    bool begins_ = true;  // silent: the next tone begins at its own pitch
};

}  // namespace tactics
