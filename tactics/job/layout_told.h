// SPDX-License-Identifier: Apache-2.0
// Facts about laid-out pages.
#pragma once

#include "tactics/job/make_pages.h"
#include "tactics/layout/pages.h"

namespace tactics {

/// Writes sizes, counts and names of these pages into their layout.
void tell_layout(Layout& layout, const Pages& pages);

}  // namespace tactics
