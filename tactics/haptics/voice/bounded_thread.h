// SPDX-License-Identifier: Apache-2.0
// A thread for which the wait is bounded, because it may hang in a library call.
#pragma once

#include <chrono>
#include <functional>
#include <future>
#include <thread>

namespace tactics {

class BoundedThread {
public:
    /// `work` owns everything that it uses, because it may outlive this object. It must not throw. The thread blocks signals.
    explicit BoundedThread(std::function<void()> work);
    ~BoundedThread() { ends_within(std::chrono::milliseconds(0)); }
    BoundedThread(const BoundedThread&) = delete;
    BoundedThread& operator=(const BoundedThread&) = delete;

    /// Waits that long for `work` to end; false: it was abandoned.
    bool ends_within(std::chrono::milliseconds time);

private:
    std::future<void> done_;
    std::thread thread_;
};

}  // namespace tactics
