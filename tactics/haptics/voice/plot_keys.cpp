// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/voice/plot_keys.h"

#include <array>

namespace tactics {

namespace {

using enum PlotAction;

constexpr std::array<PlotKey, 10> kKeys = {{
    {chosen, 0, "do", "does what is chosen: at first, tells the position"},
    {choose, 0, "choose", "lets go of a finger that is led; else chooses the next action and names it"},
    {under, 'u', "under", "tells what is under the finger"},
    {nearest, 'n', "nearest", "tells the nearest data point"},
    {start, 's', "start", "leads the finger to where the nearest curve begins; again: the next curve"},
    {follow, 'f', "follow", "leads it along the curve to the end; again: back"},
    {extremum, 'e', "extremum", "leads it along the curve to the next maximum or minimum, and tells it"},
    {compare, 'c', "compare", "leads it to the next curve at the same x, and tells the difference"},
    {position, 'p', "position", "tells where the finger is"},
    {let_go, 'l', "let go", "lets go of a finger that is led"},
}};
static_assert(kKeys.size() >= kNumberedKeys && kKeys.size() < 16);

constexpr std::array<PlotAction, 7> kChosen = {position, nearest, under, start, follow, extremum, compare};

}  // namespace

std::span<const PlotKey> plot_keys() { return kKeys; }
std::span<const PlotAction> chosen_actions() { return kChosen; }

const PlotKey& key_of(PlotAction action) {
    for (const PlotKey& key : kKeys)
        if (key.action == action) return key;
    return kKeys.front();
}

}  // namespace tactics
