// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/simulated/lever_file.h"

#include <iterator>

#include "tactics/error.h"
#include "tactics/haptics/loop/safety.h"
#include "tactics/haptics/simulated/parameter_file.h"

namespace tactics {

namespace {

// Where the parameter of that index is.
struct Place {
    double LeverSettings::*of_lever = nullptr;
    double FingerSettings::*of_finger = nullptr;
    double SensorSettings::*of_sensors = nullptr;
};

constexpr FileParameter kParameters[] = {
    {"lever.mass", "g", 1, 5000, "felt at the fingertip"},
    {"lever.damping", "N s/m", 0, 100, "of motor and bearings"},
    {"lever.friction", "N", 0, 10, "the same at any speed"},
    {"lever.gravity", "m/s2", 0, 30, "gravity on its mass"},
    {"lever.lowest", "mm", -1000, 1000, "its lower stop"},
    {"lever.highest", "mm", -1000, 1000, "its upper stop"},
    {"lever.encoder", "mm", 0, 1, "height of a count"},
    {"lever.force", "N", 0.1, SafetyLimits{}.most_force, "greatest force sent to it"},
    {"lever.rate", "Hz", 100, kMostRateHz, "forces per second"},
    {"lever.delay", "s", 0, kMostDelay, "from a measurement to its force"},
    {"finger.mass", "g", 1, 1000, "of the fingertip"},
    {"finger.stiffness", "N/mm", 0.01, 10, "of what holds it"},
    {"finger.damping", "N s/m", 0, 100, "of what holds it"},
    {"finger.pad-stiffness", "N/mm", 0.1, 10, "of its soft pad"},
    {"finger.pad-damping", "N s/m", 0, 20, "of its soft pad"},
    {"finger.preload", "N", 0, 20, "weight of the resting hand"},
    {"finger.relaxation", "s", 0.005, 100, "time until it gives way"},
    {"sensors.apart", "mm", 5, 500, "from the first (left) to the second"},
    {"sensors.counts", "1/mm", 0.1, 10'000, "counts of an optical sensor"},
    {"sensors.finger-across", "mm", -500, 500, "right of their middle"},
    {"sensors.finger-ahead", "mm", -500, 500, "away from the hand"},
};

constexpr Place kPlaces[] = {
    {&LeverSettings::mass_g},
    {&LeverSettings::damping_ns_per_m},
    {&LeverSettings::friction},
    {&LeverSettings::gravity_m_per_s2},
    {&LeverSettings::lowest},
    {&LeverSettings::highest},
    {&LeverSettings::encoder_step},
    {&LeverSettings::most_force},
    {&LeverSettings::rate_hz},
    {&LeverSettings::delay},
    {nullptr, &FingerSettings::mass_g},
    {nullptr, &FingerSettings::stiffness},
    {nullptr, &FingerSettings::damping_ns_per_m},
    {nullptr, &FingerSettings::pad_stiffness},
    {nullptr, &FingerSettings::pad_damping_ns_per_m},
    {nullptr, &FingerSettings::preload},
    {nullptr, &FingerSettings::relaxation},
    {nullptr, nullptr, &SensorSettings::apart},
    {nullptr, nullptr, &SensorSettings::counts_per_mm},
    {nullptr, nullptr, &SensorSettings::finger_across},
    {nullptr, nullptr, &SensorSettings::finger_ahead},
};
static_assert(std::size(kPlaces) == std::size(kParameters));

double& value_of(std::size_t index, MouseSettings& mouse) {
    const Place& place = kPlaces[index];
    if (place.of_lever != nullptr) return mouse.lever.*place.of_lever;
    return place.of_finger != nullptr ? mouse.finger.*place.of_finger : mouse.sensors.*place.of_sensors;
}

}  // namespace

MouseSettings read_mouse(std::string_view text, std::string_view origin) {
    constexpr std::string_view kPresets[] = {"lever", "finger"};
    MouseSettings mouse;
    const auto take = [&](std::string_view name, std::string_view word, const std::string& place) {
        if (name == "lever")
            mouse.lever = preset(kLevers, word, place, name).lever;
        else if (word == "none")
            mouse.lifted = true;
        else
            mouse.finger = preset(kFingers, word, place, name).finger;
    };
    read_parameters(text, origin, {"a mouse", kPresets, kParameters, take, [&](std::size_t index, double value) {
                                       value_of(index, mouse) = value;
                                   }});
    if (!(mouse.lever.lowest < mouse.lever.highest))
        throw Error(Fault::usage, origin,
                    phrase("lever.lowest is not below lever.highest (leave the lever a way between its stops)"));
    return mouse;
}

std::string to_text(const MouseSettings& mouse) {
    std::string text = mouse.lifted ? "finger = none\n" : "";
    MouseSettings copy = mouse;
    for (std::size_t i = 0; i < std::size(kParameters); ++i) text += parameter_line(kParameters[i], value_of(i, copy));
    return text;
}

}  // namespace tactics
