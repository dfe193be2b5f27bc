// SPDX-License-Identifier: Apache-2.0
// A thread that is not waited for without end: it may stand in a call of a library that waits for somebody else.
#pragma once

#include <chrono>
#include <functional>
#include <future>
#include <thread>

namespace tactics {

class BoundedThread {
public:
    /// `work` owns all that it uses: it may outlive this. It must not throw. Signals are for other threads.
    explicit BoundedThread(std::function<void()> work);
    ~BoundedThread() { ends_within(std::chrono::milliseconds(0)); }
    BoundedThread(const BoundedThread&) = delete;
    BoundedThread& operator=(const BoundedThread&) = delete;

    /// Waits that long for `work` to end; false: it was left to itself.
    bool ends_within(std::chrono::milliseconds time);

private:
    std::future<void> done_;
    std::thread thread_;
};

}  // namespace tactics
