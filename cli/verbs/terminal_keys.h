// SPDX-License-Identifier: Apache-2.0
// Single keys of the terminal that a program was started from.
#pragma once

#include <atomic>
#include <thread>

#include "tactics/haptics/voice/keyed_scene.h"

namespace tactics {

/// While it lives a terminal on standard input gives each key as it is pressed, without showing it; Ctrl-C is what it was. A
/// thread of its own reads and sets the bits of `typed` (plot_keys(): digits by number, letters in either case), so nobody waits
/// for it.
///
/// The terminal is as it was when this ends, when the program is stopped (Ctrl-Z) or ended by a signal, and is asked for single
/// keys again when it goes on. In the background (`&`) nothing is read, and nothing changed.
class TerminalKeys {
public:
    explicit TerminalKeys(TypedKeys& typed);
    ~TerminalKeys();
    TerminalKeys(const TerminalKeys&) = delete;
    TerminalKeys& operator=(const TerminalKeys&) = delete;
    bool listens() const noexcept { return reader_.joinable(); }

private:
    void read_keys(TypedKeys& typed);
    std::atomic<bool> over_{false};
    std::thread reader_;
};

}  // namespace tactics
