// SPDX-License-Identifier: Apache-2.0
// Many pictures at once: one per worker; a bad picture never stops the rest.
#pragma once

#include "cli/request.h"

namespace tactics {

/// Converts all pictures and reports the results. Returns the exit code.
int run_batch(const Request& request);

}  // namespace tactics
