// SPDX-License-Identifier: Apache-2.0
// All that is asked for one picture.
#pragma once

#include "tactics/job/item.h"
#include "tactics/job/wishes.h"

namespace tactics {

/// A picture, the files to make of it, and how its pages are made. A batch keeps its wishes once and its items apart.
struct Job : Item, Wishes {};

}  // namespace tactics
