// SPDX-License-Identifier: Apache-2.0
// Every tick of a play in a file, written while it goes on.
#pragma once

#include <atomic>
#include <optional>
#include <string>
#include <string_view>
#include <thread>

#include "tactics/haptics/loop/recorder.h"
#include "tactics/transport/descriptor.h"

namespace tactics {

/// The lines go to FILE.part, which takes the name of FILE when all is over: a program that is killed leaves there what was felt
/// until then. What is no file (-, a pipe, a device) gets them straight; a reader that goes away has what it wanted.
class TickLog {
public:
    /// Throws Error(failed): the file cannot be written, or its .part is there, with what was felt in a play that was killed.
    /// `recorder` must outlive it.
    TickLog(std::string path, const Recorder& recorder, const TickColumns& columns);
    /// What was felt until then is written to .part.
    ~TickLog();
    TickLog(const TickLog&) = delete;
    TickLog& operator=(const TickLog&) = delete;

    /// From now on by a thread of its own, some times a second; else by whoever calls keep_up().
    void write_beside();
    /// For a play that may wait: writes when half of what the recorder holds is not yet written.
    void keep_up();
    /// The rest, and the name. Throws Error(failed) with what went wrong, also earlier; that was said at once, too.
    void finish();

private:
    void write_new(std::size_t sure);  ///< ticks that the recorder surely has still
    void write(std::string_view text);
    void fail(const std::string& why);
    void stop_writer();

    std::string path_, part_;
    const Recorder& recorder_;
    TickColumns columns_;
    std::optional<Descriptor> file_;
    std::size_t written_ = 0;  // ticks
    bool closed_ = false;      // nobody reads any more
    std::string fault_;
    std::atomic<bool> done_ = false;
    std::thread writer_;
};

}  // namespace tactics
