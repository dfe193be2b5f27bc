// SPDX-License-Identifier: Apache-2.0
// A file descriptor that closes itself, and queries for descriptors of devices.
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

/// The error of open_device for that errno of open(2); the remedy depends on the kind of device, not on its name.
Error refusal_of(const std::string& path, int fault);

/// write(2) as a channel has it: nothing is taken while it would have to wait; ENODEV, EIO after an unplug and EPIPE are gone.
Channel::Taken take_by(int descriptor, std::string_view bytes);
/// poll(2) for POLLOUT; a device that is gone is ready, too, as taking will say so.
bool wait_for(int descriptor, std::chrono::milliseconds time);

}  // namespace tactics
