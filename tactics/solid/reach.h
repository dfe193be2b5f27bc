// SPDX-License-Identifier: Apache-2.0
// Which panels of a model a hand can lie on. M. Kurze, CHI 1997: a stove between cupboards is felt from above and from the front.
#pragma once

#include <vector>

#include "tactics/solid/panel.h"

namespace tactics {

struct ReachWish {
    double hand = 50;   ///< mm that a hand needs before a face to lie on it: its thickness and some room (assumed)
    bool floor = true;  ///< the model stands on its lowest place, where nothing is reached from below
};

/// Sets Panel::reached of all.
void find_reached(Panels& panels, const std::vector<ModelPart>& parts, const ReachWish& wish);

}  // namespace tactics
