// SPDX-License-Identifier: Apache-2.0
// Parallel work on many things, where no failure stops the rest.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "tactics/error.h"

namespace tactics {

/// The error, as a line that begins with the name of the thing; empty if there was none.
struct Failure {
    Phrase text;
    Fault fault = Fault::failed;
};
Failure failure_of(const std::string& name, const std::function<void()>& work);

/// Calls `work` with each number below `count`, with that many workers at a time; 0: the number of cores. If a call throws, no
/// more are started, and the exception is rethrown here when all have finished.
void share_out(std::size_t count, int workers, const std::function<void(std::size_t)>& work);

}  // namespace tactics
