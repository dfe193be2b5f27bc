// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/workers.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <new>
#include <thread>
#include <vector>

#include "tactics/error.h"

namespace tactics {

Failure failure_of(const std::string& name, const std::function<void()>& work) {
    Failure failure;
    try {
        work();
        return failure;
    } catch (const Error& error) {
        failure = {error.told(), error.fault()};
    } catch (const std::bad_alloc&) {
        failure.text = phrase("there is not enough memory for it; try {0} 1 or a smaller picture", spelled("jobs"));
    } catch (const std::exception& error) {
        failure.text = phrase("this should not happen, please report it: {0}", error.what());
    }
    if (!failure.text.english().starts_with(name + ":")) failure.text = phrase("{0}: {1}", name, std::move(failure.text));
    return failure;
}

void share_out(std::size_t count, int workers, const std::function<void(std::size_t)>& work) {
    std::atomic<std::size_t> next = 0;
    std::mutex mutex;
    std::exception_ptr first;
    const auto take = [&] {
        try {
            for (std::size_t i = next++; i < count; i = next++) work(i);
        } catch (...) {
            next = count;
            const std::scoped_lock lock(mutex);
            if (!first) first = std::current_exception();
        }
    };
    const std::size_t wanted =
        workers > 0 ? static_cast<std::size_t>(workers) : std::max(1u, std::thread::hardware_concurrency());
    std::vector<std::jthread> others(std::max<std::size_t>(1, std::min(wanted, count)) - 1);
    for (auto& other : others) other = std::jthread(take);
    take();
    others.clear();  // joined
    if (first) std::rethrow_exception(first);
}

}  // namespace tactics
