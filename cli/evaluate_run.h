// Recipes over a folder of pictures, all cores at work.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "cli/evaluate_request.h"
#include "tactics/measure/evaluation.h"

namespace tactics {

/// What cannot be scored is said at once and stands in the problems; the rest goes on. The same values with any number of
/// workers, but for times and memory.
Evaluation evaluate(const EvaluateRequest& request);

/// What goes wrong with `name` becomes a line of text; empty if nothing does.
std::string fault_of(const std::string& name, const std::function<void()>& work);

/// Calls `work` with each number below `count`, by so many workers at a time; 0: as many as there are cores. `work` must not
/// throw.
void share_out(std::size_t count, int workers, const std::function<void(std::size_t)>& work);

}  // namespace tactics
