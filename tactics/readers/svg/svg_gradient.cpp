// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/svg/svg_gradient.h"

#include <algorithm>
#include <vector>

#include "tactics/readers/svg/svg_numbers.h"

namespace tactics {

namespace {

struct Stop {
    double at, lightness, opacity;
};

std::vector<Stop> stops_of(const Element& gradient, const std::function<Declarations(const Element& stop)>& colour) {
    std::vector<Stop> stops;
    for (const Element& child : gradient.children) {
        if (child.name != "stop") continue;
        Stop stop{parse_svg_length(child.attribute("offset"), 1).value_or(0), 0, 1};
        for (const auto& [name, value] : colour(child)) {
            if (name == "stop-color") stop.lightness = lightness_of(value).value_or(0);
            if (name == "stop-opacity") stop.opacity = std::clamp(parse_svg_length(value, 1).value_or(1), 0.0, 1.0);
        }
        stop.at = std::clamp(stop.at, stops.empty() ? 0.0 : stops.back().at, 1.0);
        stops.push_back(stop);
    }
    return stops;
}

}  // namespace

std::optional<MeanPaint> mean_of_gradient(const Element& gradient, const std::map<std::string, const Element*, std::less<>>& all,
                                          const std::function<Declarations(const Element& stop)>& colour) {
    constexpr int kMostSteps = 16;
    constexpr double kClear = 0.1, kFull = 0.6;  // settings
    const Element* from = &gradient;
    std::vector<Stop> stops = stops_of(*from, colour);
    for (int step = 0; stops.empty() && step < kMostSteps; ++step) {
        const std::string_view name = from->attribute("href");
        const auto next = name.starts_with('#') ? all.find(name.substr(1)) : all.end();
        if (next == all.end()) return std::nullopt;
        from = next->second;
        stops = stops_of(*from, colour);
    }
    if (stops.empty()) return std::nullopt;
    const bool radial = gradient.name == "radialGradient";
    stops.insert(stops.begin(), {0, stops.front().lightness, stops.front().opacity});
    stops.push_back({1, stops.back().lightness, stops.back().opacity});
    double opacity = 0, light = 0, clearest = 1, fullest = 0;
    for (std::size_t i = 0; i < stops.size(); ++i) {
        clearest = std::min(clearest, stops[i].opacity);
        fullest = std::max(fullest, stops[i].opacity);
        if (i == 0) continue;
        const Stop &a = stops[i - 1], &b = stops[i];
        const double share = radial ? b.at * b.at - a.at * a.at : b.at - a.at;
        opacity += share * (a.opacity + b.opacity) / 2;
        light += share * (a.opacity * a.lightness + b.opacity * b.lightness) / 2;
    }
    MeanPaint mean;
    mean.opacity = opacity;
    mean.lightness = opacity > 0 ? light / opacity : 1;
    // From one side to the other drawing programs fade what is to be seen, too.
    mean.fades = clearest < kClear && fullest > kClear && (radial || fullest < kFull);
    return mean;
}

}  // namespace tactics
