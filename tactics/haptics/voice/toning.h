// SPDX-License-Identifier: Apache-2.0
// The thread that sounds tones: it plays the last tone from the loop.
//
//     OpenedTones opened = open_tones();         // before playing; tell opened.note, if any
//     Toning toning(std::move(opened.sink));
//     ... in the loop, at each tick of tracing a curve:
//     toning.tell({.value = share_of_y, .side = share_of_x, .series = 0, .sounds = true});
//     toning.tell({});                           // silence
//     ... after playing: toning.finish(), and tell toning.note(), if any
#pragma once

#include <memory>

#include "tactics/haptics/voice/tone.h"
#include "tactics/haptics/voice/tone_sink.h"

namespace tactics {

class Toning {
public:
    explicit Toning(std::unique_ptr<ToneSink> sink);
    ~Toning();  ///< as finish
    Toning(const Toning&) = delete;
    Toning& operator=(const Toning&) = delete;

    /// For any thread: one store, no lock, no allocation, no system call.
    void tell(const Tone& tone) noexcept;

    /// Fades and closes the sink within a second; false: the sink hangs and the thread was abandoned.
    bool finish();
    Phrase note() const;  ///< the first trouble of the sink; empty: none

private:
    struct Shared;
    struct Thread;
    static void work(Shared& shared);
    std::shared_ptr<Shared> shared_;
    std::unique_ptr<Thread> thread_;
};

}  // namespace tactics
