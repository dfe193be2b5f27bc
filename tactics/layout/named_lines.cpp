// SPDX-License-Identifier: Apache-2.0
#include "tactics/layout/named_lines.h"

#include <algorithm>

namespace tactics {

std::vector<const PageName*> names_of_lines(const Page& page) {
    // From top to bottom: a page may have tens of thousands.
    std::vector<const PageName*> names;
    double highest = 0;
    for (const PageName& name : page.names) {
        names.push_back(&name);
        highest = std::max(highest, name.place.height);
    }
    std::stable_sort(names.begin(), names.end(),
                     [](const PageName* a, const PageName* b) { return a->place.top < b->place.top; });
    constexpr double kRounding = 1e-6;
    std::vector<const PageName*> of_lines;
    for (const BrailleLine& line : page.braille) {
        const PageName* found = nullptr;
        auto each = std::lower_bound(names.begin(), names.end(), line.first_dot.y - highest - kRounding,
                                     [](const PageName* name, double top) { return name->place.top < top; });
        for (; each != names.end() && (*each)->place.top <= line.first_dot.y; ++each) {
            const Rect& place = (*each)->place;
            const double right = line.first_dot.x - place.left, down = line.first_dot.y - place.top;
            const bool within = right >= 0 && right <= place.width && down >= 0 && down <= place.height;
            if (within && (found == nullptr || *each < found)) found = *each;
        }
        of_lines.push_back(found);
    }
    return of_lines;
}

}  // namespace tactics
