#include "tactics/transport/descriptor.h"

#include <fcntl.h>
#include <poll.h>
#include <pthread.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "tactics/error.h"

namespace tactics {

Descriptor::~Descriptor() {
    if (number_ >= 0) close(number_);
}

Descriptor open_device(const std::string& path) {
    const int number = open(path.c_str(), O_RDWR | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
    if (number < 0) {
        const int fault = errno;
        const bool serial = path.find("tty") != std::string::npos;
        if (fault == ENOENT || fault == ENODEV || fault == ENXIO)
            throw Error(Fault::failed, path, "there is no such device; plug it in and switch it on; see tactics devices");
        if (fault == EBUSY) throw Error(Fault::failed, path, "is busy: another program has it open, perhaps a print queue; print to the queue instead (--to queue:NAME)");
        if (fault == EACCES || fault == EPERM)
            throw Error(Fault::failed, path,
                        std::string("you are not permitted to use it; become a member of the group ") + (serial ? "dialout" : "lp") + " (sudo adduser $USER " +
                            (serial ? "dialout" : "lp") + ", then log in again)" + (serial ? "" : ", or install lib/udev/rules.d/70-tactics.rules of this program in /etc/udev/rules.d"));
        throw Error(Fault::failed, path, std::string("cannot be opened: ") + std::strerror(fault));
    }
    Descriptor device(number);
    struct stat kind {};
    if (fstat(number, &kind) != 0 || !S_ISCHR(kind.st_mode)) throw Error(Fault::failed, path, "is no device; see tactics devices");
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
