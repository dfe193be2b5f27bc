// SPDX-License-Identifier: Apache-2.0
// Laws for every artwork that a filter returns, for any input. Used by tests and by the fuzzer.
#pragma once

#include <string>

#include "tactics/artwork.h"
#include "tactics/filter.h"

namespace tactics {

/// The first law that is broken, in words, or nothing.
std::string broken_law(const Artwork& artwork);

bool same(const Artwork& a, const Artwork& b);

/// What the filter must give for that kind.
Kind kind_after(const Filter& filter, Kind given);

}  // namespace tactics
