// SPDX-License-Identifier: Apache-2.0
// Writes every tick of a play to a file while it runs.
#pragma once

#include <atomic>
#include <optional>
#include <string>
#include <string_view>
#include <thread>

#include "tactics/haptics/loop/recorder.h"
#include "tactics/text/phrase.h"
#include "tactics/transport/descriptor.h"

namespace tactics {

/// The lines go to FILE.part, which is renamed to FILE at the end: a killed program leaves the ticks so far there. Anything that
/// is no file (-, a pipe, a device) gets the lines directly; a closed pipe is no error.
class TickLog {
public:
    /// Throws Error(failed) if the file cannot be written, or its .part exists, with the ticks of a play that was killed.
    /// `recorder` must outlive it.
    TickLog(std::string path, const Recorder& recorder, const TickColumns& columns);
    /// Writes the ticks so far to .part.
    ~TickLog();
    TickLog(const TickLog&) = delete;
    TickLog& operator=(const TickLog&) = delete;

    /// From now on, a separate thread writes a few times per second; otherwise call keep_up().
    void write_beside();
    /// For a play that may wait: writes when half of the recorder's ticks are unwritten.
    void keep_up();
    /// Writes the rest and renames the file. Throws Error(failed) for any failure, including earlier ones, which were also
    /// reported at once.
    void finish();

private:
    void write_new(std::size_t sure);  ///< ticks that the recorder certainly still holds
    void write(std::string_view text);
    void fail(Phrase why);
    void stop_writer();

    std::string path_, part_;
    const Recorder& recorder_;
    TickColumns columns_;
    std::optional<Descriptor> file_;
    std::size_t written_ = 0;  // ticks
    bool closed_ = false;      // the reader has closed the pipe
    Phrase fault_;
    std::atomic<bool> done_ = false;
    std::thread writer_;
};

}  // namespace tactics
