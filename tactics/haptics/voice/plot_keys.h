// SPDX-License-Identifier: Apache-2.0
// The keys of a plot that is felt: the same on every device, and on the keyboard beside it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace tactics {

enum class PlotAction : std::uint8_t { chosen, choose, under, nearest, start, follow, extremum, compare, position, let_go };

/// An entry of the one list that help, keys and the keyboard are made from.
struct PlotKey {
    PlotAction action = PlotAction::chosen;
    char letter = 0;  ///< on the keyboard; 0: none
    std::string_view name = {}, what = {};
};

/// The first kNumberedKeys have the keys of a device by their numbers, from 1, and these digits on the keyboard; the others have
/// a letter alone.
///
/// A device has one key to eight, and many have two, so the first two reach everything: the second steps through the actions and
/// each is named aloud, the first does the one that was named last, which is at first the position. Nothing is held down or
/// pressed at once, which is hard for stiff hands on a handle that pushes; nothing depends on how long somebody presses; and
/// while a finger is led the second lets it go. Who has more keys, or a keyboard, has the actions at once as well.
std::span<const PlotKey> plot_keys();
inline constexpr std::size_t kNumberedKeys = 8;

/// The actions that are chosen between, in turn.
std::span<const PlotAction> chosen_actions();

const PlotKey& key_of(PlotAction action);

}  // namespace tactics
