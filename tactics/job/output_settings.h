// SPDX-License-Identifier: Apache-2.0
// What a format is told for a page, and whether its machine takes that page.
#pragma once

#include "print/format.h"
#include "tactics/job/wishes.h"
#include "tactics/layout/place.h"
#include "tactics/readers/read.h"

namespace tactics {

/// As wished; of a bare page a pixel for each pixel of the picture, or of the part that is left of it.
Settings settings_for(const Wishes& wishes, const Format& format, const PictureInfo& picture, const Kept& kept);

/// Throws Error(usage): the format's machine does not take such a sheet. Of several sheets each goes in by itself, upright or
/// turned as they all are.
void check_machine(const Wishes& wishes, const Format& format, const Sheet& sheet, const Place& place);

}  // namespace tactics
