// SPDX-License-Identifier: Apache-2.0
// Pictures worked through, all cores at work.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "studies/study.h"

namespace tactics {

/// Works through the numbers below `count`, all cores at work, telling how far it is: what `work` gives are problems, one
/// line each, told at once after those of the folders.
void work_through(const StudyRequest& request, const StudyWatch& watch, std::size_t count,
                  const std::function<std::vector<Phrase>(std::size_t)>& work);

/// Time of this thread on a processor, so that other pictures at work do not count.
double cpu_ms();

}  // namespace tactics
