// SPDX-License-Identifier: Apache-2.0
// How a play makes heights from a file that is no plot.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "cli/command.h"
#include "tactics/job/disk.h"
#include "tactics/job/felt_heights.h"
#include "tactics/job/wishes.h"
#include "tactics/relief/read_heights.h"

namespace tactics {

struct MapWish {
    HeightWish heights;
    Wishes drawing;                              ///< for files that are drawn first
    std::optional<double> radius = {};           ///< mm, of the fingertip
    std::optional<MediumChannel> best_for = {};  ///< transform the heights so that this medium loses the least
};

/// --pitch, --width, --low, --high, --radius, --recipe, --filter, --set, --detail, --page, --allow, and those of tables. Throws
/// Error(usage).
MapWish map_wish(const Given& given, const Disk& disk);

/// The length of such an option; nothing if it is not given. Throws Error(usage).
std::optional<double> length_of(const Given& given, std::string_view flag);
/// --radius, mm; nothing if it is not given. Throws Error(usage).
std::optional<double> radius_of(const Given& given);

/// A file as heights; prints the notes about them.
FeltHeights felt_map(Source source, const std::string& path, const MapWish& wish, bool quiet);

}  // namespace tactics
