#include "cli/interrupt.h"

#include <pthread.h>
#include <unistd.h>

#include <utility>

#include "tactics/transport/file.h"

namespace tactics {

Interrupt::Interrupt(std::function<void()> before_end) : before_end_(std::move(before_end)) {
    sigemptyset(&waited_);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        // What nohup or a shell's background job ignores stays ignored.
        struct sigaction action {};
        if (sigaction(signal, nullptr, &action) == 0 && action.sa_handler != SIG_IGN) sigaddset(&waited_, signal);
    }
    // One more of its own, to be woken by when the work is over.
    sigaddset(&waited_, SIGUSR2);
    pthread_sigmask(SIG_BLOCK, &waited_, &before_);
    thread_ = std::thread([this] { wait(); });
}

Interrupt::~Interrupt() {
    over_ = true;
    pthread_kill(thread_.native_handle(), SIGUSR2);
    thread_.join();
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

void Interrupt::wait() {
    int signal = 0;
    if (sigwait(&waited_, &signal) != 0 || over_) return;
    before_end_();
    remove_unfinished_files();
    sigset_t just_this;
    sigemptyset(&just_this);
    sigaddset(&just_this, signal);
    struct sigaction action {};
    action.sa_handler = SIG_DFL;
    sigaction(signal, &action, nullptr);
    raise(signal);  // pending in this thread until the next line lets it in
    pthread_sigmask(SIG_UNBLOCK, &just_this, nullptr);
    _exit(128 + signal);  // the first process of a container outlives its signals
}

}  // namespace tactics
