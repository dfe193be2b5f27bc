// SPDX-License-Identifier: Apache-2.0
// Runs of ink around something.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace tactics {

/// On a closed course; `middle` may be beyond its last place, as the first one follows.
struct RunAround {
    std::size_t middle = 0, length = 0;
};

/// Runs of the `count` places of a closed course for which `holds(place)`; it is asked for places beyond the last, too. Nothing
/// if it holds for all of them.
template <typename Holds>
std::optional<std::vector<RunAround>> runs_around(std::size_t count, Holds holds) {
    std::size_t first = 0;
    while (first < count && holds(first)) ++first;
    if (first == count) return std::nullopt;
    std::vector<RunAround> runs;
    std::size_t length = 0;
    for (std::size_t at = first + 1; at <= first + count; ++at) {
        if (holds(at)) {
            ++length;
            continue;
        }
        if (length > 0) runs.push_back({at - 1 - length / 2, length});
        length = 0;
    }
    return runs;
}

}  // namespace tactics
