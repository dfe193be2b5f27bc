// SPDX-License-Identifier: Apache-2.0
// Heads of arrows in a figure, as large as a finger needs: at the size of a page those of a large diagram are specks.
#pragma once

#include "tactics/drawing.h"

namespace tactics {

/// Small filled triangles, with or without a notch, and open angles at the end of a line that they point along are its head: they
/// become open heads (Role::arrow), as a filled one is felt as a blob (rule filled-arrows), with sides of a least length, but no
/// more than their line has room for. What their tip nearly touches it touches.
void make_heads_felt(Drawing& drawing);

}  // namespace tactics
