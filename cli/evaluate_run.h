// Recipes over a folder of pictures, all cores at work.
#pragma once

#include "cli/evaluate_request.h"
#include "tactics/measure/evaluation.h"

namespace tactics {

/// What cannot be scored is said at once and stands in the problems; the rest goes on. The same values with any number of
/// workers, but for times and memory.
Evaluation evaluate(const EvaluateRequest& request);

}  // namespace tactics
