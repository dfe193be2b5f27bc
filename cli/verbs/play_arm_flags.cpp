// SPDX-License-Identifier: Apache-2.0
#include "cli/verbs/play_arm_flags.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "cli/request.h"
#include "cli/verbs/play_guidance.h"
#include "tactics/error.h"
#include "tactics/haptics/scenes/stability.h"
#include "tactics/readers/append_file.h"
#include "tactics/text/words.h"
#include "tactics/units.h"

namespace tactics {

ArmFile arm_of(const Given& given) {
    const std::string name = given.value("--arm", std::string(kArms.front().name));
    std::vector<std::string_view> names;
    for (const NamedArm& one : kArms) names.push_back(one.name);
    std::string text = "arm = " + name;
    if (std::find(names.begin(), names.end(), name) == names.end()) {
        if (name.find_first_of("./") == std::string::npos && !std::filesystem::exists(name))
            throw Error(Fault::usage, "--arm",
                        phrase("there is no arm \"{0}\"{1}; it is omni, desktop, phantom, or a file of its numbers",
                               name.substr(0, 80), did_you_mean(name, names)));
        text.clear();
        append_file(text, name);
    }
    ArmFile file = read_arm(text, name);
    if (given.has("--finger")) {
        const std::string finger = given.value("--finger");
        file = read_arm(text + "\nfinger = " + finger, "--finger");
    }
    file.arm.rate_hz = number_value(given, "--rate", file.arm.rate_hz, 100, kMostRateHz);
    return file;
}

std::optional<ScenePlane> plane_of(const Given& given) {
    if (!given.has("--plane")) return std::nullopt;
    const std::string text = given.value("--plane");
    if (text == "upright") return kUpright;
    if (text == "flat") return kFlat;
    std::vector<double> numbers;
    for (std::string_view rest = text; !rest.empty();) {
        const auto comma = std::min(rest.find(','), rest.size());
        if (const auto number = parse_number(rest.substr(0, comma))) numbers.push_back(*number);
        rest.remove_prefix(std::min(comma + 1, rest.size()));
    }
    if (numbers.size() != 4 || std::hypot(numbers[0], numbers[1], numbers[2]) < 1e-9)
        throw Error(
            Fault::usage, "--plane",
            phrase("it is upright, flat, or A,B,C,D of the plane Ax + By + Cz + D = 0, x to the right, y upwards, z towards the "
                   "person, mm; 0,0,1,0 is upright"));
    return ScenePlane{numbers[0], numbers[1], numbers[2], numbers[3]};
}

std::vector<const PlotPart*> parts_of(const Given& given) {
    std::vector<const PlotPart*> parts;
    if (!given.has("--feel")) return {plot_parts().begin(), plot_parts().end()};
    std::vector<std::string_view> names;
    for (const PlotPart* part : plot_parts()) names.push_back(part->name);
    const std::string text = given.value("--feel");
    for (std::string_view rest = text; !rest.empty();) {
        const auto comma = std::min(rest.find(','), rest.size());
        const std::string_view name = rest.substr(0, comma);
        const auto found =
            std::find_if(plot_parts().begin(), plot_parts().end(), [&](const PlotPart* part) { return part->name == name; });
        if (found == plot_parts().end())
            throw Error(Fault::usage, "--feel",
                        phrase("a plot has no \"{0}\"{1}; it has wall, axes, grid, curves, points and surface",
                               name.substr(0, 80), did_you_mean(std::string(name), names)));
        parts.push_back(*found);
        rest.remove_prefix(std::min(comma + 1, rest.size()));
    }
    return parts;
}

FixtureSettings fixture_of(const Given& given) {
    const std::string name = given.value("--fixture", std::string(fixtures().front().name));
    std::vector<std::string_view> names;
    for (const NamedFixture& one : fixtures()) {
        if (one.name == name) return one.settings;
        names.push_back(one.name);
    }
    throw Error(
        Fault::usage, "--fixture",
        phrase("no fixture is called \"{0}\"{1}; it is r2, r1, linear or rod", name.substr(0, 80), did_you_mean(name, names)));
}

const HandKind& hand_of(const Given& given) {
    const std::string name = given.value("--hand", given.has("--guide") ? kLedHand : hands().front().name);
    std::vector<std::string_view> names;
    for (const HandKind& one : hands()) {
        if (one.name == name) return one;
        names.push_back(one.name);
    }
    throw Error(Fault::usage, "--hand",
                phrase("no hand is called \"{0}\"{1}; it is to-and-fro, trace, points, sections or led", name.substr(0, 80),
                       did_you_mean(name, names)));
}

ForceLaw arm_law_of(const Given& given, const ArmFile& file, double share) {
    std::vector<FingerSettings> fingers;
    for (const NamedFinger& one : kFingers) fingers.push_back(one.finger);
    ForceLaw law;
    law.stiffness = number_value(given, "--stiffness", std::floor(100 * share * file.arm.most_stiffness) / 100, 0.001, 1000);
    law.damping_ns_per_m = number_value(given, "--damping", 1, 0, 100);
    // Two parts at once, a wall and a curve on it, are twice as stiff.
    const StableCheck check = check_arm(ForceLaw{law.stiffness / share, law.damping_ns_per_m}, file.arm, fingers);
    if (check.stable) return law;
    const ForceLaw nearest{std::floor(100 * share * check.stiffness) / 100, check.damping_ns_per_m};
    if (check.stiffness == 0 || given.has("--stiffness") || given.has("--damping"))
        throw Error(Fault::usage, "--stiffness",
                    check.stiffness == 0 ? check.reason
                    : share < 1 ? phrase("{0} (twice what is asked for, as two parts can push the same way); this comes to rest: "
                                         "--stiffness {1} --damping {2}",
                                         check.reason, to_text(nearest.stiffness), to_text(nearest.damping_ns_per_m))
                                : phrase("{0}; this comes to rest: --stiffness {1} --damping {2}", check.reason,
                                         to_text(nearest.stiffness), to_text(nearest.damping_ns_per_m)));
    return nearest;
}

}  // namespace tactics
