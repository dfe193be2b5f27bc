// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/cut_cells.h"

#include <algorithm>

#include "tactics/error.h"

namespace tactics {

namespace {

constexpr std::uint8_t kSixDots = 0x3F;

}  // namespace

void CutCells::count(const Format& format, const Settings& settings, const std::vector<Page>& pages) {
    if (!has_six_dots(format, settings)) return;
    std::size_t cut = 0;
    for (const Page& page : pages)
        for (const BrailleLine& line : page.braille)
            cut += static_cast<std::size_t>(
                std::count_if(line.cells.begin(), line.cells.end(), [](std::uint8_t cell) { return cell > kSixDots; }));
    if (cut == 0) return;
    most_ = std::max(most_, cut);
    formats_.insert(std::string(format.name));
}

Phrase CutCells::note() const {
    if (most_ == 0) return {};
    const Phrase names = listed({formats_.begin(), formats_.end()});
    const Phrase mend = phrase(
        "take a table of six dots with {0}, or what has eight: pef with {1} pef.dots=8, generic with {1} "
        "generic.dots=8, index-v4",
        spelled("braille"), spelled("set"));
    if (formats_.size() == 1)
        return phrases(most_, "{0} cell of its braille loses dots 7 and 8, which {1} does not have; {2}",
                       "{0} cells of its braille lose dots 7 and 8, which {1} does not have; {2}", names, mend);
    return phrases(most_, "{0} cell of its braille loses dots 7 and 8, which {1} do not have; {2}",
                   "{0} cells of its braille lose dots 7 and 8, which {1} do not have; {2}", names, mend);
}

}  // namespace tactics
