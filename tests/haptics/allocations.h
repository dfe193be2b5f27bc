// SPDX-License-Identifier: Apache-2.0
// How often memory was taken by this program since it began.
#pragma once

#include <cstddef>

namespace tactics::tests {

std::size_t allocations() noexcept;
/// Sanitizers have an allocator of their own, which is left to them.
bool counts_allocations() noexcept;

}  // namespace tactics::tests
