// SPDX-License-Identifier: Apache-2.0
// Outputs for tones: a loudspeaker through ALSA, which PipeWire and PulseAudio also provide, or nothing. Files are in
// tone_track.h.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "tactics/text/phrase.h"

namespace tactics {

class ToneSink {
public:
    virtual ~ToneSink() = default;
    /// Takes pairs of samples, kToneRate per second. Never throws.
    virtual void take(std::span<const std::int16_t> samples) = 0;
    virtual bool has_beat() const { return false; }  ///< it consumes samples in real time; other sinks at once
    virtual Phrase trouble() { return {}; }          ///< why nothing is heard, and the remedy; empty: no known trouble
};

struct OpenedTones {
    std::unique_ptr<ToneSink> sink;  ///< never empty
    Phrase note;                     ///< why it is not the requested one; empty: it is
};

/// The loudspeaker, or nothing. A missing sound device gives a note.
OpenedTones open_tones();

std::unique_ptr<ToneSink> open_alsa(Phrase& note);  ///< empty, with a note, if there is none

}  // namespace tactics
