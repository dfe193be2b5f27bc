// SPDX-License-Identifier: Apache-2.0
// The contour map that a filter uses: its option `map`.
#pragma once

#include <memory>
#include <string_view>

#include "filters/net/nets.h"
#include "tactics/filter.h"

namespace tactics {

/// auto becomes learned or plain, depending on the installation; reports missing weights.
ChosenSetting settle_map(Settings& settings, std::string_view filter);

/// nullptr: without training. Throws Error(failed) if the weights are requested but not installed.
std::shared_ptr<const ContourNet> net_for(const Settings& settings);

}  // namespace tactics
