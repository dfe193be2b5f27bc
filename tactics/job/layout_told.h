// SPDX-License-Identifier: Apache-2.0
// What is known of pages that are laid out.
#pragma once

#include "tactics/job/make_pages.h"
#include "tactics/layout/pages.h"

namespace tactics {

/// Sizes, counts and names of those pages into their layout.
void tell_layout(Layout& layout, const Pages& pages);

}  // namespace tactics
