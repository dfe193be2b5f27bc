// SPDX-License-Identifier: Apache-2.0
#include "filters/map_choice.h"

#include "tactics/error.h"

namespace tactics {

ChosenSetting settle_map(Settings& settings, std::string_view filter) {
    if (settings.choice("map") != "auto") return {};
    const bool learned = find_net() != nullptr;
    settings.set("map", learned ? "learned" : "plain", filter, filter);
    if (learned) return {};
    return {"map=plain", phrase("the weights of the contour net are not installed; contours are less sure without them")};
}

std::shared_ptr<const ContourNet> net_for(const Settings& settings) {
    if (settings.choice("map") == "plain") return nullptr;
    auto net = find_net();
    if (net == nullptr && settings.choice("map") == "learned")
        throw Error(Fault::failed, "map=learned",
                    phrase("the weights of the contour net are not installed; install them, or take map=plain"));
    return net;
}

}  // namespace tactics
