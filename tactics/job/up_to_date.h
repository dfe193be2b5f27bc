// SPDX-License-Identifier: Apache-2.0
// Whether a picture has to be converted again (--update).
#pragma once

#include "tactics/job/wishes.h"

namespace tactics {

/// All outputs are there and none is older than the picture or the recipe file. Of pages in files of their own those are
/// asked for that are known before the picture is read: all tiles, and a second one where a key may need it.
bool is_up_to_date(const Wishes& wishes, const Item& item);

}  // namespace tactics
