// SPDX-License-Identifier: Apache-2.0
// Recipes over a folder of pictures, all cores at work.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "cli/verbs/evaluate_request.h"
#include "tactics/measure/evaluation.h"

namespace tactics {

/// What cannot be scored is said at once and stands in the problems; the rest goes on. The same values with any number of
/// workers, but for times and memory.
Evaluation evaluate(const EvaluateRequest& request);

/// Works through the numbers below `count`, all cores at work, telling how far it is: what `work` gives are problems, one
/// line each, said at once after those of the folders.
void work_through(const EvaluateRequest& request, std::size_t count,
                  const std::function<std::vector<std::string>(std::size_t)>& work);

/// Time of this thread on a processor, so that other pictures at work do not count.
double cpu_ms();

/// The last words, "2 could not be scored:" and which. Gives the exit code.
int tell_problems(const std::vector<std::string>& problems, const std::string& what);

}  // namespace tactics
