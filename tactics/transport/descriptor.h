// SPDX-License-Identifier: Apache-2.0
// A file descriptor that is closed at the end, and what is asked of those that lead to devices.
#pragma once

#include <string>

#include "tactics/error.h"
#include "tactics/transport/delivery.h"

namespace tactics {

class Descriptor {
public:
    explicit Descriptor(int number) : number_(number) {}
    ~Descriptor();
    Descriptor(Descriptor&& other) noexcept : number_(other.number_) { other.number_ = -1; }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    int number() const { return number_; }

private:
    int number_;
};

/// For a path of a device, not to wait. Throws Error(failed): missing, busy, not permitted (with what to do about it), no device.
Descriptor open_device(const std::string& path);

/// What open_device throws where open(2) failed with that errno; what to do depends on what the path leads to, not on how it is
/// named.
Error refusal_of(const std::string& path, int fault);

/// write(2) as a channel has it: nothing is taken while it would have to wait; ENODEV, EIO after an unplug and EPIPE are gone.
Channel::Taken take_by(int descriptor, std::string_view bytes);
/// poll(2) for POLLOUT; a device that is gone is ready, too, as taking will say so.
bool wait_for(int descriptor, std::chrono::milliseconds time);

}  // namespace tactics
