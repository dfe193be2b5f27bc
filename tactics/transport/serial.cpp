// SPDX-License-Identifier: Apache-2.0
// Serial lines, by termios (POSIX.1-2017).
#include <poll.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include "tactics/error.h"
#include "tactics/transport/channels.h"
#include "tactics/transport/descriptor.h"

namespace tactics {

namespace {

constexpr std::array<std::pair<int, speed_t>, 9> kSpeeds{{{1200, B1200},
                                                          {2400, B2400},
                                                          {4800, B4800},
                                                          {9600, B9600},
                                                          {19200, B19200},
                                                          {38400, B38400},
                                                          {57600, B57600},
                                                          {115200, B115200},
                                                          {230400, B230400}}};

class Serial : public Channel {
public:
    explicit Serial(Descriptor device) : device_(std::move(device)) {}
    Taken take(std::string_view bytes) override { return take_by(device_.number(), bytes); }
    bool wait(std::chrono::milliseconds time) override { return wait_for(device_.number(), time); }
    Ending trouble() override {
        int lines = 0;
        return ioctl(device_.number(), TIOCMGET, &lines) != 0 && errno == EIO ? Ending::gone : Ending::stalled;
    }
    std::size_t on_the_way() override {
        int count = 0;
        return ioctl(device_.number(), TIOCOUTQ, &count) == 0 && count > 0 ? static_cast<std::size_t>(count) : 0;
    }
    std::optional<std::string> hear(std::chrono::milliseconds time) override {
        pollfd ready{device_.number(), POLLIN, 0};
        if (poll(&ready, 1, static_cast<int>(time.count())) <= 0) return "";
        char block[256];
        const ssize_t count = read(device_.number(), block, sizeof block);
        if (count > 0) return std::string(block, static_cast<std::size_t>(count));
        // A line that hangs up is ready for ever, with nothing in it.
        const bool gone = count == 0 || (errno != EAGAIN && errno != EINTR) || (ready.revents & (POLLHUP | POLLERR)) != 0;
        return gone ? std::nullopt : std::optional<std::string>("");
    }
    void discard() override { tcflush(device_.number(), TCOFLUSH); }

private:
    Descriptor device_;
};

}  // namespace

std::unique_ptr<Channel> open_serial(const std::string& path, int baud, Flow flow) {
    speed_t speed = 0;
    std::string known;
    for (const auto& [number, value] : kSpeeds) {
        known += (known.empty() ? "" : ", ") + std::to_string(number);
        if (number == baud) speed = value;
    }
    if (speed == 0)
        throw Error(Fault::usage, path, phrase("it cannot be set to {0} baud, but to {1}", std::to_string(baud), known));
    Descriptor device = open_device(path);
    termios line{};
    if (tcgetattr(device.number(), &line) != 0)
        throw Error(Fault::failed, path, phrase("is no serial line; see tactics devices"));
    cfmakeraw(&line);
    line.c_cflag |= CLOCAL;
    line.c_cflag &= ~static_cast<tcflag_t>(CSTOPB | CRTSCTS);
    if (flow == Flow::rtscts) line.c_cflag |= CRTSCTS;
    if (flow == Flow::xonxoff) line.c_iflag |= IXON;
    cfsetispeed(&line, speed);
    cfsetospeed(&line, speed);
    // Two programs on one line would mix their bytes. Whoever may do everything is let in all the same.
    ioctl(device.number(), TIOCEXCL);
    if (tcsetattr(device.number(), TCSANOW, &line) != 0)
        throw Error(Fault::failed, path, phrase("cannot be set up: {0}", std::strerror(errno)));
    return std::make_unique<Serial>(std::move(device));
}

}  // namespace tactics
