// Every tick of a play in a file, written while it goes on.
#pragma once

#include <atomic>
#include <cstdio>
#include <memory>
#include <string>
#include <thread>

#include "tactics/haptics/recorder.h"

namespace tactics {

/// The lines go to FILE.part, which takes the name of FILE when all is over: a program that is killed leaves there what was felt until then.
/// What is no file (-, a pipe, a device) gets them straight.
class TickLog {
public:
    /// Throws Error(failed): the file cannot be written. `recorder` must outlive it.
    TickLog(std::string path, const Recorder& recorder, bool truth);
    ~TickLog();
    TickLog(const TickLog&) = delete;
    TickLog& operator=(const TickLog&) = delete;

    /// From now on by a thread of its own, some times a second; else by whoever calls keep_up().
    void write_beside();
    /// For a play that may wait: writes when half of what the recorder holds is not yet written.
    void keep_up();
    /// The rest, and the name. Throws Error(failed) with what went wrong, also earlier.
    void finish();

private:
    void write_new();

    std::string path_, part_;
    const Recorder& recorder_;
    bool truth_;
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
    std::size_t written_ = 0;
    int fault_ = 0;  // errno
    std::atomic<bool> done_ = false;
    std::thread writer_;
};

}  // namespace tactics
