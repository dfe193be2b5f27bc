// SPDX-License-Identifier: Apache-2.0
// Where tones are heard: a loudspeaker by ALSA, which PipeWire and PulseAudio offer, too, or nowhere. Those of a file are in
// tone_track.h.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace tactics {

class ToneSink {
public:
    virtual ~ToneSink() = default;
    /// Pairs of samples, kToneRate a second. Throws nothing.
    virtual void take(std::span<const std::int16_t> samples) = 0;
    virtual bool has_beat() const { return false; }  ///< it takes them as they are heard; the others at once
    virtual std::string trouble() { return {}; }     ///< why nothing is heard, and how to mend it; empty: nothing is known
};

struct OpenedTones {
    std::unique_ptr<ToneSink> sink;  ///< never empty
    std::string note;                ///< why it is not what was wished; empty: it is
};

/// The loudspeaker, or nowhere. No sound is a note.
OpenedTones open_tones();

std::unique_ptr<ToneSink> open_alsa(std::string& note);  ///< empty, with a note, if there is none

}  // namespace tactics
