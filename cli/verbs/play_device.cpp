// SPDX-License-Identifier: Apache-2.0
#include "cli/verbs/play_device.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <initializer_list>

#include "cli/report/say.h"
#include "cli/request.h"
#include "tactics/error.h"
#include "tactics/haptics/devices/mouse_devices.h"
#include "tactics/readers/append_file.h"
#include "tactics/text/words.h"
#include "tactics/transport/file.h"
#include "tactics/units.h"

namespace tactics {

namespace {

std::string overlay_path(const std::string& name) {
    if (name != "auto") return name;
    const std::vector<TouchPlace> places = touch_places("");
    if (places.empty())
        throw Error(Fault::failed, "--overlay",
                    phrase("there is no touch overlay; plug it in, or name it, for example --overlay /dev/input/event5; "
                           "/proc/bus/input/devices has their names"));
    if (places.size() == 1) return places[0].path;
    std::string all;
    for (const TouchPlace& place : places) all += (all.empty() ? "" : ", ") + place.path + " (" + place.name + ")";
    throw Error(Fault::failed, "--overlay", phrase("several touch devices are there: {0}; name one of them", all));
}

std::unique_ptr<HapticDevice> overlaid(std::unique_ptr<HapticDevice> mouse, const OverlayWish& wish) {
    const auto open = [wish] {
        const std::string path = overlay_path(wish.name);
        return touch_overlay(open_touch_device(path), wish.place, path);
    };
    return mouse_with_overlay(std::move(mouse), open, [wish](bool there) {
        say(there
                ? phrase("{0}: the touch overlay is there again", wish.name)
                : phrase("{0}: the touch overlay is gone; the finger is followed by the mouse alone until it is plugged in again",
                         wish.name));
    });
}

constexpr std::string_view kNoFinger = "none";

FingerSettings finger_of(const std::string& name) {
    std::vector<std::string_view> names = {kNoFinger};
    for (const NamedFinger& one : kFingers) {
        if (one.name == name) return one.finger;
        names.push_back(one.name);
    }
    throw Error(Fault::usage, "--finger",
                phrase("there is no finger \"{0}\"{1}; it is soft, nominal, stiff, or none", name.substr(0, 80),
                       did_you_mean(name, names)));
}

const DeviceKind& device_of(const Given& given) {
    return kind_of_device(given.value("--device", std::string(device_kinds().front()->name)));
}

}  // namespace

std::optional<Point> two_lengths(std::string_view text, char between) {
    const auto at = text.find(between);
    if (at == std::string_view::npos) return std::nullopt;
    const std::string_view second = text.substr(at + 1);
    std::string first(text.substr(0, at));
    if (parse_number(first)) first += second.substr(std::min(second.size(), second.find_last_of("0123456789.") + 1));
    const auto x = parse_length(first), y = parse_length(second);
    return x && y ? std::optional(Point{*x, *y}) : std::nullopt;
}

std::optional<OverlayWish> overlay_of(const Given& given) {
    for (const std::string_view flag : {"--overlay-size", "--map-at"})
        if (given.has(flag) && !given.has("--overlay"))
            throw Error(Fault::usage, flag, phrase("it is about a touch overlay; name that, too: --overlay auto"));
    if (!given.has("--overlay")) return std::nullopt;
    if (!device_of(given).real || !device_of(given).finds_place)
        throw Error(Fault::usage, "--overlay",
                    phrase("it goes with a real mouse (--device hid:); the others know where they are"));
    OverlayWish wish{given.value("--overlay"), {}};
    if (wish.name.empty()) throw Error(Fault::usage, "--overlay", phrase("it is a device such as /dev/input/event5, or auto"));
    if (given.has("--overlay-size")) {
        const auto size = two_lengths(given.value("--overlay-size"), 'x');
        if (!size || !(size->x >= 10 && size->x <= 10'000 && size->y >= 10 && size->y <= 10'000))
            throw Error(Fault::usage, "--overlay-size", phrase("it is a width and a height from 10mm to 10m, such as 600x340mm"));
        wish.place.width = size->x;
        wish.place.height = size->y;
    }
    if (given.has("--map-at")) {
        const auto at = two_lengths(given.value("--map-at"), ',');
        if (!at || !(std::abs(at->x) <= 10'000 && std::abs(at->y) <= 10'000))
            throw Error(Fault::usage, "--map-at",
                        phrase("it is how far to the right and how far down the map begins, such as 50mm,30mm"));
        wish.place.map_at = *at;
    }
    return wish;
}

const DeviceKind& kind_of_device(const std::string& name) {
    const std::string kind = name.substr(0, name.find(':'));
    std::vector<std::string_view> names;
    std::string all;
    for (const DeviceKind* one : device_kinds()) {
        if (one->name == kind && (kind == name || !one->address.empty())) return *one;
        names.push_back(one->name);
        all += (all.empty() ? "" : ", ") + std::string(one->example);
    }
    throw Error(Fault::usage, "--device",
                phrase("there is no device \"{0}\"{1}; it is {2}", name.substr(0, 80), did_you_mean(kind, names), all));
}

MouseSettings machine_of(const Given& given) {
    const bool real = device_of(given).real;
    MouseSettings machine;
    // A finger softer than assumed overshoots the top of a wall; a stiffer one is lifted a little late.
    machine.finger = finger_of(real ? "soft" : "nominal");
    const std::string name = given.value("--lever", "light");
    const auto preset = std::find_if(kLevers.begin(), kLevers.end(), [&](const NamedLever& one) { return one.name == name; });
    if (preset != kLevers.end()) {
        machine.lever = preset->lever;
    } else {
        std::string text;
        // A name without a dot or a slash was meant for one of the presets.
        if (name.find_first_of("./") == std::string::npos && !std::filesystem::exists(name))
            throw Error(Fault::usage, "--lever",
                        phrase("there is no lever \"{0}\"{1}; it is light, heavy, or a file; see tactics help mouse",
                               name.substr(0, 80), did_you_mean(name, {"light", "heavy"})));
        append_file(text, name);
        machine = read_mouse(text, name);
    }
    if (given.has("--finger")) {
        const std::string finger = given.value("--finger");
        machine.lifted = finger == kNoFinger;
        if (!machine.lifted) machine.finger = finger_of(finger);
    }
    if (real && machine.lifted)
        throw Error(Fault::usage, "--finger",
                    phrase("a real mouse has a finger on it, or will have; it is soft, nominal or stiff"));
    // Without a finger, the calculation uses the finger to come.
    if (machine.lifted) machine.finger = finger_of("soft");
    if (real && machine.lever.encoder_step == 0)
        throw Error(
            Fault::usage, name,
            phrase("an encoder of 0 mm is an ideal one, for simulations; give the height of a count, for example lever.encoder "
                   "= 0.0146 mm"));
    if (real && machine.lever.delay == 0) machine.lever.delay = kHidDelay;
    machine.lever.rate_hz = number_value(given, "--rate", machine.lever.rate_hz, 100, kMostRateHz);
    return machine;
}

std::unique_ptr<HapticDevice> open_mouse(const std::string& name, DeviceWish wish, const std::optional<OverlayWish>& overlay) {
    const auto colon = name.find(':');
    if (colon != std::string::npos) wish.where = name.substr(colon + 1);
    const DeviceKind& kind = kind_of_device(name);
    if (kind.axes == 3 && wish.axes == 1)
        throw Error(Fault::usage, "--device", phrase("an arm pushes a finger in space, and a map lifts it only; take a mouse"));
    auto mouse = kind.open(wish);
    return overlay ? overlaid(std::move(mouse), *overlay) : std::move(mouse);
}

std::optional<LearnedPointing> learned_before(const std::string& file, bool own, bool quiet) {
    std::error_code unseen;
    if (file.empty() || !std::filesystem::exists(file, unseen)) return std::nullopt;
    try {
        std::string text;
        append_file(text, file);
        return read_learned(text, file);
    } catch (const Error& error) {
        if (!own) throw;
        if (!quiet) say(error.what());
        return std::nullopt;
    }
}

void keep_learned(const std::string& file, bool own, const Fusion& fusion, bool quiet) {
    const std::optional<LearnedPointing> learned = file.empty() ? std::nullopt : fusion.learned();
    if (!learned) return;
    // A folder that the user has named is theirs to make, as with all outputs.
    std::error_code unmade;
    if (own) std::filesystem::create_directories(std::filesystem::path(file).parent_path(), unmade);
    try {
        write_file(file, to_text(*learned));
    } catch (const Error& error) {
        if (!own) throw;
        if (!quiet) say(phrase("what was learned of the mouse is not kept: {0}", error.what()));
    }
}

}  // namespace tactics
