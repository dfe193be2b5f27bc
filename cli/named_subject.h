// SPDX-License-Identifier: Apache-2.0
// What of a picture matters, as options say it: --subject, --subject-only and --leave.
#pragma once

#include "cli/command.h"
#include "tactics/job/subject_wish.h"

namespace tactics {

/// Of the options. Throws Error(usage).
SubjectWish subject_value(const Given& given);

}  // namespace tactics
