// SPDX-License-Identifier: Apache-2.0
// Single keys from the program's terminal.
#pragma once

#include <atomic>
#include <thread>

#include "tactics/haptics/voice/keyed_scene.h"

namespace tactics {

/// While this object lives, a terminal on standard input delivers each key when it is pressed, without echo; Ctrl-C works as
/// usual. A separate thread reads and sets the bits of `typed` (plot_keys(): digits by number, letters in either case), so
/// nothing waits for it.
///
/// The terminal is restored when this ends and when the program is stopped (Ctrl-Z) or ended by a signal; it is set again when
/// the program continues. In the background (`&`) nothing is read or changed.
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
