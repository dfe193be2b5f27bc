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
/// The same, once and once more, until the rest has room; then it is no scale any more.
std::size_t thin_out_until(std::vector<ToldWords>& told, const std::function<bool()>& has_room);

}  // namespace tactics
