// SPDX-License-Identifier: Apache-2.0
// What a file holds, whatever its name says.
#pragma once

#include "tactics/readers/read.h"

namespace tactics {

enum class Holds {
    picture,  ///< or what nobody knows, whose reader will say what it looks like
    svg,      ///< lines
    pdf,      ///< pages
    table,    ///< columns of numbers, as text (csv.h)
    model,    ///< a solid (model.h)
};

/// Rewinds it.
Holds look_at(Source& source);

}  // namespace tactics
