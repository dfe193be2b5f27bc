// SPDX-License-Identifier: Apache-2.0
// What a play feels of a file that is no plot: how its heights are made.
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
    Wishes drawing;                              ///< of what is drawn before it is felt
    std::optional<double> radius = {};           ///< mm, of the fingertip
    std::optional<MediumChannel> best_for = {};  ///< heights are transformed so that it loses least of them
};

/// --pitch, --width, --low, --high, --radius, --recipe, --filter, --set, --detail, --page, --allow, and those of tables. Throws
/// Error(usage).
MapWish map_wish(const Given& given, const Disk& disk);

/// A length of those; nothing where the flag is not given. Throws Error(usage).
std::optional<double> length_of(const Given& given, std::string_view flag);
/// --radius, mm; nothing where it is not given. Throws Error(usage).
std::optional<double> radius_of(const Given& given);

/// A file as heights, with what should be known of them said.
FeltHeights felt_map(Source source, const std::string& path, const MapWish& wish, bool quiet);

}  // namespace tactics
