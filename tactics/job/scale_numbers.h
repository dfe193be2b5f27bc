// SPDX-License-Identifier: Apache-2.0
// Numbers of a scale, which braille may have no room for.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "tactics/job/told_words.h"

namespace tactics {

/// Removes every second of four or more numbers in a row or column that grow or fall all along, as transcribers do where braille
/// has no room for all. Returns how many it removed.
std::size_t thin_out(std::vector<ToldWords>& told);
/// The same for rows, or columns, or both, and once more, where fewer names are lost then: `left_out` counts those that have no
/// room, and a name that is left out is as bad as a few numbers of a scale. `keep` is called after the count of the best so far.
std::size_t thin_out_for_room(std::vector<ToldWords>& told, const std::function<std::size_t()>& left_out,
                              const std::function<void()>& keep);

}  // namespace tactics
