// SPDX-License-Identifier: Apache-2.0
#include "tests/haptics/allocations.h"

#include <atomic>
#include <cstdlib>
#include <new>

#include "tests/sanitized.h"

namespace {

std::atomic<std::size_t> taken{0};

}  // namespace

#if !TACTICS_SANITIZED
// Those that a tick could call by accident; the rest of the library goes through them.
void* operator new(std::size_t size) {
    ++taken;
    if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
    throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
#endif

namespace tactics::tests {

std::size_t allocations() noexcept { return taken.load(); }

bool counts_allocations() noexcept {
#if TACTICS_SANITIZED
    return false;
#else
    return true;
#endif
}

}  // namespace tactics::tests
