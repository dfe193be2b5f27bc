// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/voice/tone.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tactics {

namespace {

constexpr double kSwellTime = 0.010;  // s
constexpr double kGlideTime = 0.010;  // s, to 63 % of the way
constexpr double kLoudness = 0.3;     // of full scale, for both ears together
constexpr double kTurn = 2 * std::numbers::pi;

// Four harmonics, as large as they become together: 1.5273 and 0.9333.
double bright(double phase) {
    double sum = 0;
    for (int n = 1; n <= 4; ++n) sum += std::sin(kTurn * n * phase) / n;
    return sum / 1.53;
}

double hollow(double phase) {
    double sum = 0;
    for (int n = 1; n <= 5; n += 2) sum += std::sin(kTurn * n * phase) / n;
    return sum / 0.94;
}

}  // namespace

double tone_frequency(double value) { return kLowestTone * std::pow(kHighestTone / kLowestTone, std::clamp(value, 0.0, 1.0)); }

void ToneSynthesiser::render(const Tone& tone, std::span<std::int16_t> samples) {
    const bool sounds = tone.sounds && std::isfinite(tone.value) && std::isfinite(tone.side);
    const double glide = 1 - std::exp(-1 / (kGlideTime * kToneRate)), step = 1 / (kSwellTime * kToneRate);
    const double pitch = sounds ? std::log(tone_frequency(tone.value)) : pitch_;
    const double side = sounds ? std::clamp(tone.side, 0.0, 1.0) : side_;
    const double kind = sounds ? tone.series % 2 : hollow_;
    if (sounds && begins_) {
        pitch_ = pitch;
        side_ = side;
        hollow_ = kind;
    }
    for (std::size_t i = 0; i + 1 < samples.size(); i += 2) {
        pitch_ += glide * (pitch - pitch_);
        side_ += glide * (side - side_);
        hollow_ += glide * (kind - hollow_);
        swell_ = std::clamp(swell_ + (sounds ? step : -step), 0.0, 1.0);
        begins_ = swell_ == 0;
        if (begins_) {
            samples[i] = samples[i + 1] = 0;
            continue;
        }
        phase_ += std::exp(pitch_) / kToneRate;
        phase_ -= std::floor(phase_);
        const double loud = kLoudness * (1 - std::cos(std::numbers::pi * swell_)) / 2;
        const double wave = loud * ((1 - hollow_) * bright(phase_) + hollow_ * hollow(phase_));
        // Both ears together are as loud anywhere: cosine and sine.
        samples[i] = static_cast<std::int16_t>(std::lround(32'767 * wave * std::cos(side_ * std::numbers::pi / 2)));
        samples[i + 1] = static_cast<std::int16_t>(std::lround(32'767 * wave * std::sin(side_ * std::numbers::pi / 2)));
    }
}

}  // namespace tactics
