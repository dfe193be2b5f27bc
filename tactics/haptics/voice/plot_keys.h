// SPDX-License-Identifier: Apache-2.0
// The keys of a tactile plot: the same on every device and on the keyboard beside it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "tactics/text/phrase.h"

namespace tactics {

enum class PlotAction : std::uint8_t { chosen, choose, under, nearest, start, follow, extremum, compare, position, let_go };

/// An entry of the one list from which the help, the device keys and the keyboard are made.
struct PlotKey {
    PlotAction action = PlotAction::chosen;
    char letter = 0;        ///< on the keyboard; 0: none
    SourceWords name = "";  ///< it is said aloud when it is chosen
    std::string_view what = {};
};

/// The first kNumberedKeys correspond to the keys of a device, numbered from 1, and to these digits on the keyboard; the others
/// have only a letter.
///
/// A device has one to eight keys, often two, so the first two reach everything: the second steps through the actions and names
/// each aloud; the first carries out the last one named, initially the position. No keys are held down or pressed together, which
/// is hard for stiff hands on a handle that pushes, and the length of a press does not matter. While a finger is led, the second
/// key releases it. With more keys, or a keyboard, the actions are also directly available.
std::span<const PlotKey> plot_keys();
inline constexpr std::size_t kNumberedKeys = 8;

/// The actions that the second key steps through, in order.
std::span<const PlotAction> chosen_actions();

const PlotKey& key_of(PlotAction action);

}  // namespace tactics
