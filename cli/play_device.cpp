#include "cli/play_device.h"

#include <algorithm>

#include "cli/embosser_flags.h"
#include "tactics/error.h"
#include "tactics/haptics/mouse_devices.h"
#include "tactics/units.h"
#include "tactics/words.h"

namespace tactics {

namespace {

FingerSettings finger_of(const std::string& name) {
    std::vector<std::string_view> names;
    for (const NamedFinger& one : kFingers) {
        if (one.name == name) return one.finger;
        names.push_back(one.name);
    }
    throw Error(Fault::usage, "--finger", "there is no finger \"" + name.substr(0, 80) + "\"" + did_you_mean(name, names) + "; it is soft, nominal or stiff");
}

}  // namespace

MouseSettings machine_of(const std::string& lever, const std::string& finger) {
    MouseSettings machine;
    machine.finger = finger_of("nominal");
    const auto preset = std::find_if(kLevers.begin(), kLevers.end(), [&](const NamedLever& one) { return one.name == lever; });
    if (preset != kLevers.end()) {
        machine.lever = preset->lever;
    } else {
        std::string text;
        append_file(text, lever);
        machine = read_mouse(text, lever);
    }
    if (!finger.empty()) machine.finger = finger_of(finger);
    return machine;
}

std::unique_ptr<MouseDevice> open_mouse(const DeviceWish& wish) {
    const std::string& name = wish.name;
    const auto colon = name.find(':');
    const std::string kind = name.substr(0, colon), rest = colon == std::string::npos ? "" : name.substr(colon + 1);
    const LeverSettings& lever = wish.machine.lever;
    const FingerSettings& finger = wish.machine.finger;
    const HeightMap& map = wish.surface.map();
    const double begin_height = wish.surface.height({0, map.height() / 2});
    if (name == "simulated") return simulated_mouse(lever, finger, map.width(), map.height(), begin_height, wish.speed, wish.seconds);
    if (name == "sensed") {
        if (wish.seconds > kMostSensed) throw Error(Fault::usage, "--seconds", "a sensed mouse is simulated for at most " + to_text(kMostSensed) + " s");
        return sensed_mouse(lever, finger, {geometry_of(wish.machine.sensors), map.width(), map.height(), begin_height, wish.speed, wish.seconds, lever.rate_hz});
    }
    if (kind == "recorded") {
        if (rest.empty()) throw Error(Fault::usage, "--device", "name the file of the way: recorded:hand.csv");
        std::string csv;
        append_file(csv, rest);
        return recorded_mouse(csv, rest, lever, finger, wish.surface.lowest());
    }
    if (kind == "hid") return hid_mouse(rest, {lever.encoder_step, wish.machine.sensors.counts_per_mm});
    throw Error(Fault::usage, "--device", "there is no mouse \"" + name.substr(0, 80) + "\"" + did_you_mean(kind, {"simulated", "sensed", "recorded", "hid"}) +
                                              "; it is simulated, sensed, recorded:FILE.csv, hid: or hid:/dev/hidraw0");
}

}  // namespace tactics
