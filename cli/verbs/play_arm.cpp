// SPDX-License-Identifier: Apache-2.0
#include "cli/verbs/play_arm.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <utility>

#include "cli/chart_files.h"
#include "cli/report/say.h"
#include "cli/request.h"
#include "cli/table_flags.h"
#include "cli/verbs/play_device.h"
#include "cli/verbs/play_found.h"
#include "cli/verbs/play_guidance.h"
#include "cli/verbs/play_scene.h"
#include "filters/ticks.h"
#include "tactics/error.h"
#include "tactics/haptics/devices/mounting.h"
#include "tactics/haptics/scenes/plot_part.h"
#include "tactics/haptics/scenes/stability.h"
#include "tactics/job/disk.h"
#include "tactics/job/open_input.h"
#include "tactics/job/table.h"
#include "tactics/readers/append_file.h"
#include "tactics/text/words.h"
#include "tactics/units.h"

namespace tactics {

namespace {

constexpr std::string_view kArmFlags[] = {"--arm",   "--hand",     "--plane", "--feel", "--fixture",
                                          "--speak", "--language", "--guide", "--tones"};
constexpr std::string_view kMouseFlags[] = {"--pitch",  "--width",  "--low",    "--high",    "--recipe",  "--filter",
                                            "--set",    "--detail", "--page",   "--radius",  "--wall",    "--damping-sign",
                                            "--edges",  "--lever",  "--fusion", "--learned", "--overlay", "--overlay-size",
                                            "--map-at", "--part",   "--track",  "--stable"};

constexpr int kMostTicks = 6;    // of an axis, as on paper
constexpr double kMargin = 8;    // mm of the workspace round the field: an axis is pushed at, and a curve left
constexpr double kAspect = 1.5;  // of the field, where the workspace has room
constexpr double kInset = 0.06;  // of the values' range, between points and the sides of the field
constexpr double kSteep = 0.4;   // of the field that a surface is high
constexpr double kShare = 0.5;   // of what the arm can be stiff: two parts may push the same way

ArmFile arm_of(const Given& given) {
    const std::string name = given.value("--arm", std::string(kArms.front().name));
    std::vector<std::string_view> names;
    for (const NamedArm& one : kArms) names.push_back(one.name);
    std::string text = "arm = " + name;
    if (std::find(names.begin(), names.end(), name) == names.end()) {
        if (name.find_first_of("./") == std::string::npos && !std::filesystem::exists(name))
            throw Error(Fault::usage, "--arm",
                        "there is no arm \"" + name.substr(0, 80) + "\"" + did_you_mean(name, names) +
                            "; it is omni, desktop, phantom, or a file of its numbers");
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

// A surface lies on a table, as a relief does; curves are on a wall, as in the paper.
ScenePlane plane_of(const Given& given, const Plot& plot) {
    const std::string text = given.value("--plane", plot.surfaces.empty() ? "upright" : "flat");
    if (text == "upright") return kUpright;
    if (text == "flat") return kFlat;
    std::vector<double> numbers;
    for (std::string_view rest = text; !rest.empty();) {
        const auto comma = std::min(rest.find(','), rest.size());
        if (const auto number = parse_number(rest.substr(0, comma))) numbers.push_back(*number);
        rest.remove_prefix(std::min(comma + 1, rest.size()));
    }
    if (numbers.size() != 4 || std::hypot(numbers[0], numbers[1], numbers[2]) < 1e-9)
        throw Error(Fault::usage, "--plane",
                    "it is upright, flat, or A,B,C,D of the plane Ax + By + Cz + D = 0, x to the right, y upwards, z towards the "
                    "person, mm; 0,0,1,0 is upright");
    return {numbers[0], numbers[1], numbers[2], numbers[3]};
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
                        "a plot has no \"" + std::string(name.substr(0, 80)) + "\"" + did_you_mean(std::string(name), names) +
                            "; it has wall, axes, grid, curves, points and surface");
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
        "no fixture is called \"" + name.substr(0, 80) + "\"" + did_you_mean(name, names) + "; it is r2, r1, linear or rod");
}

const HandKind& hand_of(const Given& given) {
    const std::string name = given.value("--hand", given.has("--guide") ? kLedHand : hands().front().name);
    std::vector<std::string_view> names;
    for (const HandKind& one : hands()) {
        if (one.name == name) return one;
        names.push_back(one.name);
    }
    throw Error(Fault::usage, "--hand",
                "no hand is called \"" + name.substr(0, 80) + "\"" + did_you_mean(name, names) +
                    "; it is to-and-fro, trace, points, sections or led");
}

struct Extent {
    double low = INFINITY, high = -INFINITY;
    void take(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
    void widen(double share, bool logarithmic) {
        const double by = share * (logarithmic ? std::log(high / low) : high - low);
        low = logarithmic ? low / std::exp(by) : low - by;
        high = logarithmic ? high * std::exp(by) : high + by;
    }
};

// `exact`: from the least value to the largest, and no round one beyond.
FeltAxis felt_axis(const Axis& axis, const Extent& extent, bool exact) {
    Ticks ticks = ticks_for(extent.low, extent.high, axis.logarithmic, kMostTicks);
    if (exact && extent.high > extent.low) {
        ticks.low = extent.low;
        ticks.high = extent.high;
        std::erase_if(ticks.at, [&](double tick) { return tick < extent.low || tick > extent.high; });
    }
    return {ticks.low, ticks.high, axis.logarithmic, ticks.at};
}

PlotFrame frame_of(const Plot& plot, const MountedField& field, double room) {
    Extent x, y, z;
    for (const PlotMark& mark : plot.marks) {
        x.take(mark.x);
        y.take(mark.y);
        if (plot.spatial) z.take(mark.z);
    }
    for (const PlotCurve& curve : plot.curves)
        for (const PlotPoint& point : curve.points) {
            x.take(point.x);
            y.take(point.y);
        }
    for (const PlotSurface& surface : plot.surfaces) {
        for (const double at : surface.x) x.take(at);
        for (const double at : surface.y) y.take(at);
        for (const double height : surface.z)
            if (std::isfinite(height)) z.take(height);
    }
    const bool solid = !plot.surfaces.empty();
    // A point on an axis would be behind its wall.
    if (!plot.marks.empty())
        for (auto [extent, axis] : {std::pair(&x, &plot.x), std::pair(&y, &plot.y)}) extent->widen(kInset, axis->logarithmic);
    PlotFrame frame;
    frame.x = felt_axis(plot.x, x, solid);
    frame.y = felt_axis(plot.y, y, solid);
    frame.width = field.width;
    frame.height = field.height;
    if (z.low <= z.high) {
        frame.z = felt_axis(plot.z, z, solid);
        frame.depth = std::min(kSteep * std::min(field.width, field.height), room);
    }
    return frame;
}

// mm that the workspace has over the plane, on the finger's side, less the margin.
double room_over(const MountedField& field, const ArmSettings& arm) {
    const Mounting& mounting = field.mounting;
    const Point3 middle = mounting.to_device({field.width / 2, field.height / 2, 0});
    double room = INFINITY;
    const auto bound = [&](double at, double out, double half) {
        if (std::abs(out) > 1e-9) room = std::min(room, (half - std::copysign(1.0, out) * at) / std::abs(out));
    };
    bound(middle.x, mounting.out.x, arm.width / 2);
    bound(middle.y, mounting.out.y, arm.height / 2);
    bound(middle.z, mounting.out.z, arm.depth / 2);
    return std::max(0.0, room - kMargin);
}

// What nobody named is what the arm bears.
ForceLaw law_of(const Given& given, const ArmFile& file) {
    std::vector<FingerSettings> fingers;
    for (const NamedFinger& one : kFingers) fingers.push_back(one.finger);
    ForceLaw law;
    law.stiffness = number_value(given, "--stiffness", std::floor(100 * kShare * file.arm.most_stiffness) / 100, 0.001, 1000);
    law.damping_ns_per_m = number_value(given, "--damping", 1, 0, 100);
    // Two parts at once, a wall and a curve on it, are twice as stiff.
    const StableCheck check = check_arm(ForceLaw{law.stiffness / kShare, law.damping_ns_per_m}, file.arm, fingers);
    if (check.stable) return law;
    const ForceLaw nearest{std::floor(100 * kShare * check.stiffness) / 100, check.damping_ns_per_m};
    if (check.stiffness == 0 || given.has("--stiffness") || given.has("--damping"))
        throw Error(Fault::usage, "--stiffness",
                    check.reason + (check.stiffness == 0
                                        ? ""
                                        : " (twice what is asked for, as two parts can push the same way); this comes "
                                          "to rest: --stiffness " +
                                              to_text(nearest.stiffness) + " --damping " + to_text(nearest.damping_ns_per_m)));
    return nearest;
}

Plot plot_in(const std::string& path, const TableWish& wish, std::vector<std::string>& notes) {
    Source source = open_input(path, 0, notes);
    return plot_of(source, wish, notes);
}

}  // namespace

std::span<const std::string_view> arm_flags() { return kArmFlags; }
std::span<const std::string_view> mouse_flags() { return kMouseFlags; }

int play_on_arm(const Given& given) {
    for (const std::string_view flag : kMouseFlags)
        if (given.has(flag)) throw Error(Fault::usage, flag, "it is about a mouse; leave it out, or take another --device");
    if (given.words.size() != 1)
        throw Error(Fault::usage, "play", "name one table of figures; for example: tactics play data.csv --device arm");
    const std::string &device_name = given.value("--device"), &path = given.words[0];
    const DeviceKind& kind = kind_of_device(device_name);
    const ArmFile arm = arm_of(given);
    const std::vector<const PlotPart*> parts = parts_of(given);
    const HandKind& hand_kind = hand_of(given);
    const bool quiet = given.has("--quiet");
    std::vector<ChartFile> charts;
    if (given.has("--plot")) charts = plan_chart_files(given, "--plot", real_disk());

    std::vector<std::string> told;
    const Plot plot = plot_in(path, table_wish(given), told);
    const MountedField field = mount(plane_of(given, plot), {arm.arm.width, arm.arm.height, arm.arm.depth}, kAspect, kMargin);
    if (!(field.width >= 30))
        throw Error(Fault::usage, "--plane", "the plane leaves a field of less than 30 mm in the workspace; take another");
    const PlotFrame frame = frame_of(plot, field, room_over(field, arm.arm));
    const PlotFeel feel{plot, frame, law_of(given, arm), fixture_of(given), std::max(arm.arm.resolution, 0.01)};
    const std::unique_ptr<Scene> scene = plot_scene(feel, parts, told);
    if (!quiet)
        for (const std::string& line : told) say(path + ": " + line);

    DeviceWish wish;
    wish.axes = 3;
    wish.arm = arm;
    wish.mounting = field.mounting;
    wish.seconds = number_value(given, "--seconds", 60, 0.001, 86'400);
    HandField hand_field{frame.width, frame.height, frame.depth, number_value(given, "--speed", 40, 1, 2000),
                         keys_to_press(given, hand_kind)};
    const std::unique_ptr<Hand> hand = hand_kind.make(hand_field);
    wish.hand = hand.get();
    std::unique_ptr<HapticDevice> device = open_mouse(device_name, wish, {});
    // A recorded way is one over the plot already.
    if (kind.axes == 3) device = mounted(std::move(device), field.mounting);

    PlotLayers layers(given, plot, frame, {*scene, feel.law, arm.arm.most_force, feel.resolution});
    SceneWish played_wish{device_name,          {}, std::nullopt, given.has("--real-time") || layers.are_heard(),
                          given.value("--csv"), {}, feel.law};
    if (kind.ends || given.has("--seconds")) played_wish.seconds = wish.seconds;
    played_wish.settings.rate_hz = arm.arm.rate_hz;
    played_wish.settings.safety.most_force = arm.arm.most_force;
    played_wish.columns.spatial = true;
    layers.begin(played_wish.by_wall || device->is_real());
    const PlayedScene played = play_scene(layers.scene(), *device, nullptr, std::move(played_wish));
    layers.finish();
    if (!charts.empty()) write_chart_files(front_plot(plot, played.records, frame), charts);
    HandReport found = report_of(hand->findings(), played.records, plot, frame);
    layers.tell_ways(played, found);
    tell_figures(played, quiet, given.has("--json"), found.json);
    if (!quiet && !given.has("--json"))
        for (const std::string& line : found.lines) say(line);
    if (played.unlogged) throw *played.unlogged;
    return 0;
}

}  // namespace tactics
