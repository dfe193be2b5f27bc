// SPDX-License-Identifier: Apache-2.0
// Many pictures at once: one picture a worker, a bad one never stops the rest.
#pragma once

#include "cli/request.h"

namespace tactics {

/// Converts all and says so. Gives the exit code.
int run_batch(const Request& request);

}  // namespace tactics
