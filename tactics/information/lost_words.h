// SPDX-License-Identifier: Apache-2.0
// What a medium loses of a scene, in words.
#pragma once

#include <vector>

#include "tactics/text/phrase.h"

namespace tactics {

struct MediumChannel;
struct Fit;
struct MeasuredScene;

/// Most important first: "lines closer than 3 mm (12 % of their length)", "heights between its 4 levels", "what is smaller than
/// 2.5 mm there". Empty: nothing.
std::vector<Phrase> lost_words(MeasuredScene& scene, const MediumChannel& channel, const Fit& fit);

}  // namespace tactics
