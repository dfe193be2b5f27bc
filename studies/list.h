// SPDX-License-Identifier: Apache-2.0
// All studies, in the order of the help. To add one: a file that defines `extern const Study NAME_study`, one line in list.inc.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "studies/study.h"

namespace tactics {

std::span<const Study* const> studies();
/// By its name, or what is asked without one; nullptr if there is none.
const Study* find_study(std::string_view name);
/// Those with a name, in alphabetical order.
std::vector<std::string_view> study_names();

}  // namespace tactics
