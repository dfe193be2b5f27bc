// SPDX-License-Identifier: Apache-2.0
// `tactics evaluate --study stability`: how much of a drawing stays when its picture changes.
#pragma once

#include "cli/verbs/evaluate_request.h"

namespace tactics {

/// Runs the study, prints its tables or JSON, and gives the exit code.
int study_stability(const EvaluateRequest& request);

}  // namespace tactics
