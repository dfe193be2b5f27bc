// SPDX-License-Identifier: Apache-2.0
// Settings of a format for a page, and a check that its machine takes the page.
#pragma once

#include "print/format.h"
#include "tactics/job/wishes.h"
#include "tactics/layout/place.h"
#include "tactics/readers/read.h"

namespace tactics {

/// As wished; for a bare page, one pixel for each pixel of the picture, or of its remaining part.
Settings settings_for(const Wishes& wishes, const Format& format, const PictureInfo& picture, const Kept& kept);

/// Throws Error(usage) if the format's machine does not take such a sheet. Several sheets go in one by one, all upright or all
/// turned.
void check_machine(const Wishes& wishes, const Format& format, const Sheet& sheet, const Place& place);

}  // namespace tactics
