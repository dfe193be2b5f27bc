// SPDX-License-Identifier: Apache-2.0
// The latest value from one thread for another: neither waits, and values are never torn.
#pragma once

#include <array>
#include <atomic>

namespace tactics {

/// Three slots: one for writing, one for reading, and one between them. For one writing and one reading thread.
template <typename T>
class Latest {
public:
    void tell(const T& value) noexcept {
        places_[written_] = value;
        written_ = between_.exchange(written_ | kFresh, std::memory_order_acq_rel) & kPlace;
    }
    /// false: nothing new, and `value` is unchanged.
    bool ask(T& value) noexcept {
        if ((between_.load(std::memory_order_relaxed) & kFresh) == 0) return false;
        read_ = between_.exchange(read_, std::memory_order_acq_rel) & kPlace;
        value = places_[read_];
        return true;
    }

private:
    static constexpr unsigned kPlace = 3, kFresh = 4;
    std::array<T, 3> places_{};
    unsigned written_ = 0, read_ = 1;  // each of one thread
    std::atomic<unsigned> between_{2};
    static_assert(std::atomic<unsigned>::is_always_lock_free);
};

}  // namespace tactics
