// SPDX-License-Identifier: Apache-2.0
// Everything requested for one picture.
#pragma once

#include "tactics/job/item.h"
#include "tactics/job/wishes.h"

namespace tactics {

/// A picture, the files to make from it, and how to make its pages. A batch has one set of wishes and many items.
struct Job : Item, Wishes {};

}  // namespace tactics
