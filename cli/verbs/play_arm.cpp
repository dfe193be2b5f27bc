// SPDX-License-Identifier: Apache-2.0
#include "cli/verbs/play_arm.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "cli/chart_files.h"
#include "cli/report/say.h"
#include "cli/request.h"
#include "cli/table_flags.h"
#include "cli/verbs/play_arm_flags.h"
#include "cli/verbs/play_device.h"
#include "cli/verbs/play_found.h"
#include "cli/verbs/play_frame.h"
#include "cli/verbs/play_scene.h"
#include "cli/verbs/play_speech.h"
#include "tactics/error.h"
#include "tactics/haptics/devices/mounting.h"
#include "tactics/haptics/scenes/plot_part.h"
#include "tactics/haptics/voice/spoken_scene.h"
#include "tactics/job/disk.h"
#include "tactics/job/open_input.h"
#include "tactics/job/table.h"

namespace tactics {

namespace {

constexpr std::string_view kArmFlags[] = {"--arm", "--hand", "--plane", "--feel", "--fixture", "--speak", "--language"};
constexpr std::string_view kMouseFlags[] = {"--pitch",  "--width",  "--low",    "--high",    "--recipe",  "--filter",
                                            "--set",    "--detail", "--page",   "--radius",  "--wall",    "--damping-sign",
                                            "--edges",  "--lever",  "--fusion", "--learned", "--overlay", "--overlay-size",
                                            "--map-at", "--part",   "--track",  "--stable"};

constexpr double kMargin = 8;    // mm of the workspace round the field: an axis is pushed at, and a curve left
constexpr double kAspect = 1.5;  // of the field, where the workspace has room

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
    const PlotFrame frame = frame_of(plot, field, room_over(field, arm.arm, kMargin));
    const PlotFeel feel{plot, frame, arm_law_of(given, arm), fixture_of(given), std::max(arm.arm.resolution, 0.01)};
    const std::unique_ptr<Scene> scene = plot_scene(feel, parts, told);
    if (!quiet)
        for (const std::string& line : told) say(path + ": " + line);

    DeviceWish wish;
    wish.axes = 3;
    wish.arm = arm;
    wish.mounting = field.mounting;
    wish.seconds = number_value(given, "--seconds", 60, 0.001, 86'400);
    HandField hand_field{frame.width, frame.height, frame.depth, number_value(given, "--speed", 40, 1, 2000)};
    const std::unique_ptr<Hand> hand = hand_kind.make(hand_field);
    wish.hand = hand.get();
    std::unique_ptr<HapticDevice> device = open_mouse(device_name, wish, {});
    // A recorded way is one over the plot already.
    if (kind.axes == 3) device = mounted(std::move(device), field.mounting);

    SceneWish played_wish{device_name, {}, std::nullopt, given.has("--real-time"), given.value("--csv"), {}, feel.law};
    if (kind.ends || given.has("--seconds")) played_wish.seconds = wish.seconds;
    played_wish.settings.rate_hz = arm.arm.rate_hz;
    played_wish.settings.safety.most_force = arm.arm.most_force;
    played_wish.columns.spatial = true;
    std::optional<Speaking> speaking = speaking_of(given, plot, frame, quiet);
    std::optional<SpokenScene> spoken;
    if (speaking) spoken.emplace(*scene, *speaking, frame, felt_lines(plot, frame, feel.resolution));
    const PlayedScene played =
        play_scene(spoken ? static_cast<Scene&>(*spoken) : *scene, *device, nullptr, std::move(played_wish));
    if (speaking) tell_voice(*speaking, quiet);
    if (!charts.empty()) write_chart_files(front_plot(plot, played.records, frame), charts);
    const HandReport found = report_of(hand->findings(), played.records, plot, frame);
    tell_figures(played, quiet, given.has("--json"), found.json);
    if (!quiet && !given.has("--json"))
        for (const std::string& line : found.lines) say(line);
    if (played.unlogged) throw *played.unlogged;
    return 0;
}

}  // namespace tactics
