// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/voice/bounded_thread.h"

#include <pthread.h>
#include <signal.h>

namespace tactics {

BoundedThread::BoundedThread(std::function<void()> work) {
    std::packaged_task<void()> task([work = std::move(work)]() mutable {
        work();
        work = nullptr;  // destroys what it owns before signalling the end
    });
    done_ = task.get_future();
    // A thread begins with the mask of who starts it.
    sigset_t all, before;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    thread_ = std::thread(std::move(task));
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

bool BoundedThread::ends_within(std::chrono::milliseconds time) {
    if (!thread_.joinable()) return done_.wait_for(std::chrono::milliseconds(0)) == std::future_status::ready;
    if (done_.wait_for(time) == std::future_status::ready) {
        thread_.join();
        return true;
    }
    thread_.detach();
    return false;
}

}  // namespace tactics
