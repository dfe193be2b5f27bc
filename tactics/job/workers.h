// SPDX-License-Identifier: Apache-2.0
// Many things to do: by many hands, and none of them stops the rest.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "tactics/error.h"

namespace tactics {

/// What went wrong, as a line that begins with the name of what was worked on; no text if nothing did.
struct Failure {
    Phrase text;
    Fault fault = Fault::failed;
};
Failure failure_of(const std::string& name, const std::function<void()>& work);

/// Calls `work` with each number below `count`, by so many workers at a time; 0: as many as there are cores. If one
/// throws, no more are begun, and what it threw is thrown here when all have come to their end.
void share_out(std::size_t count, int workers, const std::function<void(std::size_t)>& work);

}  // namespace tactics
