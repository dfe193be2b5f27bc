// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/told_heights.h"

#include <vector>

#include "tactics/layout/kind_words.h"
#include "tactics/text/table.h"

namespace tactics {

std::optional<KindHeights> heights_to_tell(const Format& format, const Page& page) {
    if (format.dots == nullptr || page.heights.most() < 2 || page.heights.dots.any_wished()) return std::nullopt;
    return page.heights;
}

Phrase explained(const KindHeights& heights, const Format& format) {
    if (heights.used == 1)
        return phrase("{0} has {1} heights, and 1 is used: all lines are of one kind, of which more heights would tell nothing",
                      format.name, std::to_string(heights.most()));
    std::vector<Phrase> losses;
    for (std::size_t i = 0; i < heights.losses.size(); ++i)
        losses.push_back(phrase("{0}: {1}", std::to_string(i + 1), percent(heights.losses[i])));
    return phrase(
        "{0} has {1} heights, and {2} are used ({3}), which lose the least of the bits about what a line is for (losses by "
        "number of heights: {4})",
        format.name, std::to_string(heights.most()), std::to_string(heights.used), words_of(heights), row_of(losses));
}

}  // namespace tactics
