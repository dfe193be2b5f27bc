// SPDX-License-Identifier: Apache-2.0
#include "cli/interrupt.h"

#include <fcntl.h>
#include <pthread.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <string>

#include "tactics/error.h"
#include "tactics/transport/child.h"
#include "tactics/transport/file.h"

namespace tactics {

namespace {

std::atomic<int> to_thread = -1;

void tell(int number) {
    const int kept = errno;
    const auto byte = static_cast<unsigned char>(number);
    if (write(to_thread, &byte, 1) < 0) {
        // The pipe is full of signals already.
    }
    errno = kept;
}

}  // namespace

Interrupt::Interrupt(std::function<void()> before_end) : before_end_(std::move(before_end)) {
    if (pipe2(pipe_.data(), O_CLOEXEC) != 0)
        throw Error(Fault::failed, "",
                    phrase("nothing can be begun: {0}; raise the limit of open files (ulimit -n)", std::strerror(errno)));
    fcntl(pipe_[1], F_SETFL, O_NONBLOCK);
    to_thread = pipe_[1];
    thread_ = std::thread([this] { wait(); });
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
        struct sigaction before {};
        // Signals ignored by nohup or a shell's background job stay ignored.
        if (sigaction(number, nullptr, &before) != 0 || before.sa_handler == SIG_IGN) continue;
        struct sigaction action {};
        action.sa_handler = tell;
        action.sa_flags = SA_RESTART;
        if (sigaction(number, &action, nullptr) == 0) before_.push_back({number, before});
    }
}

Interrupt::~Interrupt() {
    for (const auto& [number, before] : before_) sigaction(number, &before, nullptr);
    tell(0);
    thread_.join();
    to_thread = -1;
    for (const int end : pipe_) close(end);
}

void Interrupt::wait() {
    unsigned char number = 0;
    while (read(pipe_[0], &number, 1) < 0 && errno == EINTR) {
    }
    if (number == 0) return;
    before_end_();
    remove_unfinished_files();
    end_children();
    struct sigaction action {};
    action.sa_handler = SIG_DFL;
    sigaction(number, &action, nullptr);
    raise(number);
    _exit(128 + number);  // the first process of a container outlives its signals
}

}  // namespace tactics
