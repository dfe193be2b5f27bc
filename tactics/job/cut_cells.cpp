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

std::string CutCells::note() const {
    if (most_ == 0) return "";
    std::string names;
    for (const std::string& name : formats_) names += (names.empty() ? "" : " and ") + name;
    return (most_ == 1 ? "1 cell of its braille loses" : std::to_string(most_) + " cells of its braille lose") +
           " dots 7 and 8, which " + names + (formats_.size() == 1 ? " does" : " do") +
           " not have; take a table of six dots with " + spelled("braille") + ", or what has eight: pef with " + spelled("set") +
           " pef.dots=8, generic with " + spelled("set") + " generic.dots=8, index-v4";
}

}  // namespace tactics
