// SPDX-License-Identifier: Apache-2.0
// What a file holds, regardless of its name.
#pragma once

#include "tactics/readers/read.h"

namespace tactics {

enum class Holds {
    picture,  ///< or an unknown kind, for which the reader reports what it looks like
    svg,      ///< lines
    pdf,      ///< pages
    table,    ///< columns of numbers, as text (csv.h)
    model,    ///< a solid (model.h)
};

/// Rewinds it.
Holds look_at(Source& source);

}  // namespace tactics
