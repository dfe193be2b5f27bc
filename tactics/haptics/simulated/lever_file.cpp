// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/simulated/lever_file.h"

#include <algorithm>
#include <optional>
#include <set>
#include <vector>

#include "tactics/error.h"
#include "tactics/haptics/loop/safety.h"
#include "tactics/text/words.h"
#include "tactics/units.h"

namespace tactics {

namespace {

constexpr std::size_t kMostBytes = 64 * 1024;

struct Parameter {
    std::string_view name;
    std::string_view unit;
    double least, most;
    std::string_view what;
    double LeverSettings::*of_lever = nullptr;
    double FingerSettings::*of_finger = nullptr;
    double SensorSettings::*of_sensors = nullptr;
};

constexpr Parameter kParameters[] = {
    {"lever.mass", "g", 1, 5000, "felt at the fingertip", &LeverSettings::mass_g},
    {"lever.damping", "N s/m", 0, 100, "of motor and bearings", &LeverSettings::damping_ns_per_m},
    {"lever.friction", "N", 0, 10, "the same at any speed", &LeverSettings::friction},
    {"lever.gravity", "m/s2", 0, 30, "what pulls its mass down", &LeverSettings::gravity_m_per_s2},
    {"lever.lowest", "mm", -1000, 1000, "its lower stop", &LeverSettings::lowest},
    {"lever.highest", "mm", -1000, 1000, "its upper stop", &LeverSettings::highest},
    {"lever.encoder", "mm", 0, 1, "height of a count", &LeverSettings::encoder_step},
    {"lever.force", "N", 0.1, SafetyLimits{}.most_force, "the most it is told", &LeverSettings::most_force},
    {"lever.rate", "Hz", 100, kMostRateHz, "forces a second", &LeverSettings::rate_hz},
    {"lever.delay", "s", 0, kMostDelay, "from a measure to its force", &LeverSettings::delay},
    {"finger.mass", "g", 1, 1000, "of the fingertip", nullptr, &FingerSettings::mass_g},
    {"finger.stiffness", "N/mm", 0.01, 10, "of what holds it", nullptr, &FingerSettings::stiffness},
    {"finger.damping", "N s/m", 0, 100, "of what holds it", nullptr, &FingerSettings::damping_ns_per_m},
    {"finger.pad-stiffness", "N/mm", 0.1, 10, "of its soft pad", nullptr, &FingerSettings::pad_stiffness},
    {"finger.pad-damping", "N s/m", 0, 20, "of its soft pad", nullptr, &FingerSettings::pad_damping_ns_per_m},
    {"finger.preload", "N", 0, 20, "weight of the resting hand", nullptr, &FingerSettings::preload},
    {"finger.relaxation", "s", 0.005, 100, "until it gives way", nullptr, &FingerSettings::relaxation},
    {"sensors.apart", "mm", 5, 500, "first, left, to second", nullptr, nullptr, &SensorSettings::apart},
    {"sensors.counts", "1/mm", 0.1, 10'000, "counts of an optical sensor", nullptr, nullptr, &SensorSettings::counts_per_mm},
    {"sensors.finger-across", "mm", -500, 500, "right of their middle", nullptr, nullptr, &SensorSettings::finger_across},
    {"sensors.finger-ahead", "mm", -500, 500, "away from the hand", nullptr, nullptr, &SensorSettings::finger_ahead},
};

double& value_of(const Parameter& parameter, MouseSettings& mouse) {
    if (parameter.of_lever != nullptr) return mouse.lever.*parameter.of_lever;
    return parameter.of_finger != nullptr ? mouse.finger.*parameter.of_finger : mouse.sensors.*parameter.of_sensors;
}

template <typename Presets>
auto preset(const Presets& presets, std::string_view name, const std::string& place, std::string_view what) {
    std::vector<std::string_view> names;
    for (const auto& entry : presets) {
        if (entry.name == name) return entry;
        names.push_back(entry.name);
    }
    throw Error(Fault::usage, place,
                "no " + std::string(what) + " is called \"" + std::string(name) + "\"" + did_you_mean(name, names));
}

std::string range_of(const Parameter& parameter) {
    return to_text(parameter.least) + " to " + to_text(parameter.most) + " " + std::string(parameter.unit);
}

void set(const Parameter& parameter, std::string_view text, MouseSettings& mouse, const std::string& place) {
    const std::size_t blank = text.find_first_of(kBlanks);
    const auto value = parse_number(text.substr(0, blank));
    const std::string_view unit = blank == std::string_view::npos ? std::string_view{} : trimmed(text.substr(blank));
    const std::string name(parameter.name);
    if (!value) throw Error(Fault::usage, place, name + " is no number (give " + range_of(parameter) + ")");
    if (unit != parameter.unit)
        throw Error(Fault::usage, place, name + " has no unit that fits (give " + range_of(parameter) + ")");
    if (*value < parameter.least || *value > parameter.most)
        throw Error(Fault::usage, place, name + " is out of range (give " + range_of(parameter) + ")");
    value_of(parameter, mouse) = *value;
}

void read_line(std::string_view line, MouseSettings& mouse, std::set<std::string, std::less<>>& seen, const std::string& place) {
    const std::size_t equals = line.find('=');
    if (equals == std::string_view::npos) throw Error(Fault::usage, place, "no \"=\" (write NAME = VALUE UNIT)");
    const std::string_view name = trimmed(line.substr(0, equals)), text = trimmed(line.substr(equals + 1));
    if (!seen.emplace(name).second)
        throw Error(Fault::usage, place, std::string(name) + " is given twice (take one of them out)");
    if (name == "lever" || name == "finger") {
        const auto later = seen.lower_bound(std::string(name) + ".");
        if (later != seen.end() && later->starts_with(std::string(name) + "."))
            throw Error(Fault::usage, place, std::string(name) + " would undo " + *later + " above it (put it first)");
        if (name == "lever")
            mouse.lever = preset(kLevers, text, place, name).lever;
        else if (text == "none")
            mouse.lifted = true;
        else
            mouse.finger = preset(kFingers, text, place, name).finger;
        return;
    }
    const auto known =
        std::find_if(std::begin(kParameters), std::end(kParameters), [&](const Parameter& p) { return p.name == name; });
    if (known == std::end(kParameters)) {
        std::vector<std::string_view> names = {"lever", "finger"};
        for (const Parameter& parameter : kParameters) names.push_back(parameter.name);
        throw Error(Fault::usage, place, "a mouse has no \"" + std::string(name) + "\"" + did_you_mean(name, names));
    }
    set(*known, text, mouse, place);
}

}  // namespace

MouseSettings read_mouse(std::string_view text, std::string_view origin) {
    if (text.size() > kMostBytes)
        throw Error(Fault::usage, origin, "longer than any file of parameters (give one of at most 64 kB)");
    MouseSettings mouse;
    std::set<std::string, std::less<>> seen;
    for (std::size_t number = 1; !text.empty(); ++number) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view line = trimmed(text.substr(0, std::min(end, text.find('#'))));
        text.remove_prefix(std::min(end + 1, text.size()));
        if (!line.empty()) read_line(line, mouse, seen, std::string(origin) + ":" + std::to_string(number));
    }
    if (!(mouse.lever.lowest < mouse.lever.highest))
        throw Error(Fault::usage, origin, "lever.lowest is not below lever.highest (leave the lever a way between its stops)");
    return mouse;
}

std::string to_text(const MouseSettings& mouse) {
    std::string text = mouse.lifted ? "finger = none\n" : "";
    MouseSettings copy = mouse;
    for (const Parameter& parameter : kParameters)
        text += std::string(parameter.name) + " = " + to_text(value_of(parameter, copy)) + " " + std::string(parameter.unit) +
                "  # " + range_of(parameter) + "; " + std::string(parameter.what) + "\n";
    return text;
}

}  // namespace tactics
