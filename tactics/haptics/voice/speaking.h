// SPDX-License-Identifier: Apache-2.0
// The thread that speaks. The loop passes it plain values and never waits; this thread makes the words and calls the voice.
//
//     OpenedVoice opened = open_voice({.kind = "auto", .language = "en"});      // before playing; tell opened.note, if any
//     const SpokenFrame frame{{low_x, high_x, width}, {low_y, high_y, height}};  // of the field, mm
//     const PlotWords words(std::make_shared<const Plot>(plot), frame);
//     Speaking speaking(std::move(opened.voice), [words](const Announcement& one) { return words.of(one); });
//     ... in the loop, when a button goes down:
//     speaking.ask({.telling = Telling::position, .x = x, .y = y});
//     ... after playing:
//     speaking.finish();
//     tell speaking.note(), if any, and speaking.counts()
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "tactics/haptics/voice/announcement.h"
#include "tactics/haptics/voice/voice.h"

namespace tactics {

struct SpokenCounts {
    std::uint64_t said = 0;       ///< passed to the voice
    std::uint64_t overtaken = 0;  ///< dropped because a newer one arrived before it could be spoken
    std::uint64_t dropped = 0;    ///< dropped because the queue was full: the voice hangs
};

class Speaking {
public:
    /// Called on the speaking thread only. It owns everything that it uses, because the thread may outlive this object if a voice
    /// hangs.
    using Words = std::function<std::string(const Announcement&)>;

    Speaking(std::unique_ptr<Voice> voice, Words words);
    ~Speaking();  ///< as finish
    Speaking(const Speaking&) = delete;
    Speaking& operator=(const Speaking&) = delete;

    /// For one thread. No lock, no allocation, no system call. False: dropped. The newest interrupts the current speech, except
    /// with a voice that speaks everything in turn.
    bool ask(const Announcement& announcement) noexcept;

    /// Cuts off the current speech and closes the voice within kFarewell; false: the voice hangs and the thread was abandoned.
    bool finish();
    static constexpr int kFarewell = 1000;  ///< ms

    SpokenCounts counts() const noexcept;
    Phrase note() const;  ///< the first trouble of the voice; empty: none

private:
    struct Shared;
    struct Thread;
    static void work(Shared& shared);
    std::shared_ptr<Shared> shared_;
    std::unique_ptr<Thread> thread_;
};

}  // namespace tactics
