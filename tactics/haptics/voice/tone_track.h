// SPDX-License-Identifier: Apache-2.0
// The tones of a play, kept by the time of its ticks: what is simulated in a second sounds as long as it was felt, and the same
// ticks give the same file.
#pragma once

#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

#include "tactics/haptics/voice/tone.h"

namespace tactics {

inline constexpr int kTonesPerSecond = 100;

class ToneTrack {
public:
    /// Room for so many seconds is taken now; what comes later is lost.
    explicit ToneTrack(double seconds);
    /// What is heard from now on, `dt` s after the one before. A tick that is late is as long as it was, 0.1 s at most. Allocates
    /// nothing.
    void add(const Tone& tone, double dt) noexcept;
    const std::vector<Tone>& tones() const noexcept { return tones_; }  ///< kTonesPerSecond of them
    bool lost() const noexcept { return lost_; }

private:
    std::vector<Tone> tones_;
    double time_ = 0;  // s, that is not in tones_ yet
    bool lost_ = false;
};

/// A WAV file: RIFF with 16 bits of PCM for each ear (Microsoft and IBM, "Multimedia Programming Interface and Data
/// Specifications 1.0", 1991). Until it is finished it is FILE.part.
class WavFile {
public:
    /// Throws Error(failed): it cannot be written.
    explicit WavFile(std::string path);
    ~WavFile();  ///< one that is not finished is removed
    WavFile(const WavFile&) = delete;
    WavFile& operator=(const WavFile&) = delete;

    /// Writes all tones, fades, and gives the file its name. Throws Error(failed): no room on the disk.
    void finish(const std::vector<Tone>& tones);
    static constexpr double kMostSeconds = 6 * 3600;  ///< its length is told in 32 bits

private:
    void write_head(std::uint32_t bytes);
    std::string path_, part_;
    std::ofstream file_;
    bool finished_ = false;
};

}  // namespace tactics
