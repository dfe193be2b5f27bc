// SPDX-License-Identifier: Apache-2.0
#include "tactics/layout/facing.h"

#include <utility>

namespace tactics {

namespace {

bool next_is_front(const std::vector<Page>& sides) { return sides.size() % 2 == 0; }

}  // namespace

Pages on_both_sides(Pages drawn, std::vector<Page> key) {
    const Page blank = empty_like(drawn.all.front());
    std::vector<Page> sides;
    const auto put = [&](Page& page, bool front) {
        if (next_is_front(sides) != front) sides.push_back(blank);
        sides.push_back(std::move(page));
    };
    if (key.size() > 1 && drawn.all.size() == 1) {
        put(drawn.all.front(), false);
        drawn.drawn = sides.size() - 1;
        for (Page& page : key) put(page, true);
    } else {
        if (key.size() % 2 == 1) sides.push_back(blank);
        for (Page& page : key) sides.push_back(std::move(page));
        drawn.drawn = sides.size();
        for (Page& page : drawn.all) put(page, true);
    }
    drawn.all = std::move(sides);
    return drawn;
}

}  // namespace tactics
