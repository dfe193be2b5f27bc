// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/voice/plot_keys.h"

#include <array>

namespace tactics {

namespace {

using enum PlotAction;

constexpr std::array<PlotKey, 10> kKeys = {{
    {chosen, 0, SourceWords("do"), "carries out the chosen action: at first, says the position"},
    {choose, 0, SourceWords("choose"), "stops leading the finger; if it is not led, chooses the next action and names it"},
    {under, 'u', SourceWords("under"), "says what is under the finger"},
    {nearest, 'n', SourceWords("nearest"), "says the nearest data point"},
    {start, 's', SourceWords("start"), "leads the finger to the beginning of the nearest curve; again: of the next curve"},
    {follow, 'f', SourceWords("follow"), "leads it along the curve to the end; again: back"},
    {extremum, 'e', SourceWords("extremum"), "leads it along the curve to the next maximum or minimum, and says its value"},
    {compare, 'c', SourceWords("compare"), "leads it to the next curve at the same x, and says the difference"},
    {position, 'p', SourceWords("position"), "says where the finger is"},
    {let_go, 'l', SourceWords("let go"), "stops leading the finger"},
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
