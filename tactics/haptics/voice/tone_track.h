// SPDX-License-Identifier: Apache-2.0
// The tones of a play, stored by the time of its ticks: they sound as long as they were felt, however fast the simulation ran,
// and the same ticks give the same file.
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
    /// Reserves memory for that many seconds; later tones are lost.
    explicit ToneTrack(double seconds);
    /// The tone from now on, `dt` s after the previous one. A late tick keeps its length, 0.1 s at most. Allocates nothing.
    void add(const Tone& tone, double dt) noexcept;
    const std::vector<Tone>& tones() const noexcept { return tones_; }  ///< kTonesPerSecond per second
    bool lost() const noexcept { return lost_; }

private:
    std::vector<Tone> tones_;
    double time_ = 0;  // s, that is not in tones_ yet
    bool lost_ = false;
};

/// A WAV file: RIFF with 16-bit PCM for each ear (Microsoft and IBM, "Multimedia Programming Interface and Data Specifications
/// 1.0", 1991). Until it is finished it is FILE.part.
class WavFile {
public:
    /// Throws Error(failed) if it cannot be written.
    explicit WavFile(std::string path);
    ~WavFile();  ///< removes an unfinished file
    WavFile(const WavFile&) = delete;
    WavFile& operator=(const WavFile&) = delete;

    /// Writes all tones, fades out, and gives the file its name. Throws Error(failed) if the disk is full.
    void finish(const std::vector<Tone>& tones);
    static constexpr double kMostSeconds = 6 * 3600;  ///< its length field has 32 bits

private:
    void write_head(std::uint32_t bytes);
    std::string path_, part_;
    std::ofstream file_;
    bool finished_ = false;
};

}  // namespace tactics
