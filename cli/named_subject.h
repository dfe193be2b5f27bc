// SPDX-License-Identifier: Apache-2.0
// The parts of a picture that matter, from the options --subject, --subject-only and --leave.
#pragma once

#include "cli/command.h"
#include "tactics/job/subject_wish.h"

namespace tactics {

/// The wish from the options. Throws Error(usage).
SubjectWish subject_value(const Given& given);

}  // namespace tactics
