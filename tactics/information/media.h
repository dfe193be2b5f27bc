// SPDX-License-Identifier: Apache-2.0
// The channels of the product: each medium, embosser, display, file of heights, mouse and arm that it lists, described by what
// the tree already says of it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tactics/haptics/simulated/arm.h"
#include "tactics/haptics/simulated/lever_file.h"
#include "tactics/information/channel.h"
#include "tactics/medium.h"

namespace tactics {

/// In the order of the lists. Pages are those of `paper`, or of what each is made for. The places of braille cells stand in two
/// and more distances; the pitch is that of as many dots at equal distances.
std::vector<MediumChannel> channels(const std::optional<Paper>& paper);

/// An arm: a surface is felt by where the finger is stopped, so its heights are told apart as places are.
MediumChannel channel_of(std::string_view name, const ArmSettings& arm);

/// A haptic mouse, which is moved over a table that has no end.
MediumChannel channel_of(const MouseSettings& mouse);

/// One of them. Throws Error(usage) at `place`, with the nearest.
MediumChannel named_channel(const std::string& name, const std::string& place);

/// Of those, "all", or the names between the commas. Throws Error(usage) at `place`, with the nearest.
std::vector<MediumChannel> named_channels(const std::string& names, const std::optional<Paper>& paper, const std::string& place);

}  // namespace tactics
