// SPDX-License-Identifier: Apache-2.0
#include "tactics/transport/descriptor.h"

#include <fcntl.h>
#include <poll.h>
#include <pthread.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "tactics/error.h"

namespace tactics {

Descriptor::~Descriptor() {
    if (number_ >= 0) close(number_);
}

namespace {

// Names such as /dev/serial/by-id/usb-FTDI-if00 are links.
bool is_serial(const std::string& path) {
    std::error_code fault;
    const std::string name = std::filesystem::weakly_canonical(path, fault).filename().string();
    return name.starts_with("tty") || name.starts_with("rfcomm");
}

}  // namespace

Error refusal_of(const std::string& path, int fault) {
    const bool serial = is_serial(path);
    const auto failed = [&](Phrase message) { return Error(Fault::failed, path, std::move(message)); };
    if (fault == ENOENT || fault == ENODEV || fault == ENXIO)
        return failed(phrase("there is no such device; plug it in and switch it on; see tactics devices"));
    if (fault == EBUSY)
        return failed(
            serial
                ? phrase("is busy: another program has it open, perhaps BRLTTY or a second one of this; end that one first")
                : phrase(
                      "is busy: another program has it open, perhaps a print queue; print to the queue instead ({0} queue:NAME)",
                      spelled("to")));
    if (fault == EACCES || fault == EPERM) {
        const std::string group = serial ? "dialout" : "lp";
        return failed(
            serial ? phrase("you are not permitted to use it; become a member of the group {0} (sudo adduser $USER {0}, then log "
                            "in again)",
                            group)
                   : phrase("you are not permitted to use it; become a member of the group {0} (sudo adduser $USER {0}, then log "
                            "in again), or install lib/udev/rules.d/70-tactics.rules of this program in /etc/udev/rules.d",
                            group));
    }
    return failed(phrase("cannot be opened: {0}", std::strerror(fault)));
}

Descriptor open_device(const std::string& path) {
    const int number = open(path.c_str(), O_RDWR | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
    if (number < 0) throw refusal_of(path, errno);
    Descriptor device(number);
    struct stat kind {};
    if (fstat(number, &kind) != 0 || !S_ISCHR(kind.st_mode))
        throw Error(Fault::failed, path, phrase("is no device; see tactics devices"));
    return device;
}

Channel::Taken take_by(int descriptor, std::string_view bytes) {
    // The USB printer driver says that a write was interrupted after it has begun; it must not be begun again.
    sigset_t all, before;
    sigfillset(&all);
    for (;;) {
        pthread_sigmask(SIG_BLOCK, &all, &before);
        const ssize_t count = write(descriptor, bytes.data(), bytes.size());
        const int fault = errno;
        pthread_sigmask(SIG_SETMASK, &before, nullptr);
        errno = fault;
        if (count >= 0) return {static_cast<std::size_t>(count)};
        switch (errno) {
            case EINTR: continue;
            case EAGAIN: return {};
            case ENOSPC: return {0, Ending::paper_out};
            case ENODEV:
            case ENXIO:
            case EPIPE:
            case ECONNRESET:
            case EIO: return {0, Ending::gone};
            default: return {0, Ending::failed, std::strerror(errno)};
        }
    }
}

bool wait_for(int descriptor, std::chrono::milliseconds time) {
    pollfd ready{descriptor, POLLOUT, 0};
    return poll(&ready, 1, static_cast<int>(time.count())) > 0;
}

}  // namespace tactics
