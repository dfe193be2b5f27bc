// SPDX-License-Identifier: Apache-2.0
#include "tactics/layout/kind_words.h"

#include <vector>

#include "tactics/text/table.h"

namespace tactics {

namespace {

Phrase name_of(LineKind kind) {
    switch (kind) {
        case LineKind::inner: return phrase("lines inside things");
        case LineKind::values: return phrase("axes, ticks and lead lines");
        case LineKind::grid: return phrase("grid lines");
        case LineKind::pattern: return phrase("patterns");
        case LineKind::drawn: break;
    }
    return phrase("the drawing and braille");
}

}  // namespace

Phrase words_of(const KindHeights& heights) {
    std::vector<Phrase> kinds;
    for (std::size_t i = 0; i < kLineKinds; ++i)
        if (const auto kind = static_cast<LineKind>(i); heights.there[i])
            kinds.push_back(phrase("{0}: {1}", name_of(kind), percent(heights.share(kind))));
    return row_of(kinds);
}

}  // namespace tactics
