#include "cli/play_device.h"

#include "cli/embosser_flags.h"
#include "tactics/error.h"
#include "tactics/haptics/lever_file.h"
#include "tactics/haptics/mouse_devices.h"
#include "tactics/words.h"

namespace tactics {

LeverSettings lever_of(const std::string& name) {
    for (const NamedLever& one : kLevers)
        if (one.name == name) return one.lever;
    std::string text;
    append_file(text, name);
    return read_mouse(text, name).lever;
}

FingerSettings finger_of(const std::string& name) {
    std::vector<std::string_view> names;
    for (const NamedFinger& one : kFingers) {
        if (one.name == name) return one.finger;
        names.push_back(one.name);
    }
    throw Error(Fault::usage, "--finger", "there is no finger \"" + name.substr(0, 80) + "\"" + did_you_mean(name, names) + "; it is soft, nominal or stiff");
}

std::unique_ptr<MouseDevice> open_mouse(const DeviceWish& wish) {
    const std::string& name = wish.name;
    const auto colon = name.find(':');
    const std::string kind = name.substr(0, colon), rest = colon == std::string::npos ? "" : name.substr(colon + 1);
    if (kind == "simulated") {
        const HeightMap& map = wish.surface.map();
        return simulated_mouse(wish.lever, wish.finger, map.width(), map.height(), wish.surface.height({0, map.height() / 2}), wish.speed, wish.seconds);
    }
    if (kind == "recorded") {
        if (rest.empty()) throw Error(Fault::usage, "--device", "name the file of the way: recorded:hand.csv");
        std::string csv;
        append_file(csv, rest);
        return recorded_mouse(csv, rest, wish.lever, wish.finger, wish.surface.lowest());
    }
    if (kind == "hid") return hid_mouse(rest, {wish.lever.encoder_step, wish.counts_per_mm});
    throw Error(Fault::usage, "--device", "there is no mouse \"" + name.substr(0, 80) + "\"" + did_you_mean(kind, {"simulated", "recorded", "hid"}) +
                                              "; it is simulated, recorded:FILE.csv, hid: or hid:/dev/hidraw0");
}

}  // namespace tactics
