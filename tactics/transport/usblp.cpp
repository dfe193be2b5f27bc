// SPDX-License-Identifier: Apache-2.0
// The kernel's driver for USB printers. Its behaviour was measured on Linux 6.1: a write takes at most 8192 bytes; closing at
// once after a write that did not wait loses them all, waiting for POLLOUT first loses none; while the printer accepts nothing,
// its status can still be read.
#include <poll.h>
#include <sys/ioctl.h>

#include <cerrno>

#include "tactics/transport/channels.h"
#include "tactics/transport/descriptor.h"

namespace tactics {

namespace {

// linux/lp.h, and USB Printer Class 1.1, GET_PORT_STATUS.
constexpr unsigned long kGetStatus = 0x060b;
constexpr int kPaperOut = 0x20;

class Usblp : public Channel {
public:
    explicit Usblp(Descriptor device) : device_(std::move(device)) {}

    Taken take(std::string_view bytes) override {
        const Taken taken = take_by(device_.number(), bytes);
        if (taken.bytes > 0) last_ = taken.bytes;
        return taken;
    }
    bool wait(std::chrono::milliseconds time) override { return wait_for(device_.number(), time); }
    Ending trouble() override {
        int status = 0;
        if (is_gone() || (ioctl(device_.number(), kGetStatus, &status) != 0 && errno == ENODEV)) return Ending::gone;
        return (status & kPaperOut) != 0 ? Ending::paper_out : Ending::stalled;
    }
    // It is ready for more when the last write has left; one that is gone is ready, too, and has not taken it.
    std::size_t on_the_way() override {
        return is_gone() || !wait_for(device_.number(), std::chrono::milliseconds{0}) ? last_ : 0;
    }

private:
    bool is_gone() const {
        pollfd state{device_.number(), 0, 0};
        return poll(&state, 1, 0) > 0 && (state.revents & (POLLHUP | POLLERR)) != 0;
    }
    Descriptor device_;
    std::size_t last_ = 0;
};

}  // namespace

std::unique_ptr<Channel> open_usblp(const std::string& path) { return std::make_unique<Usblp>(open_device(path)); }

}  // namespace tactics
