// SPDX-License-Identifier: Apache-2.0
// Which contour map a filter works on: its option `map`.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "filters/net/nets.h"
#include "tactics/filter.h"

namespace tactics {

/// auto becomes learned or plain, by what is installed; says so if the weights are missing.
std::string settle_map(Settings& settings, std::string_view filter);

/// nullptr: without training. Throws Error(failed) if the weights are asked for and not installed.
std::shared_ptr<const ContourNet> net_for(const Settings& settings);

}  // namespace tactics
