// SPDX-License-Identifier: Apache-2.0
#include "cli/verbs/play_arm.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "cli/chart_files.h"
#include "cli/report/say.h"
#include "cli/request.h"
#include "cli/table_flags.h"
#include "cli/verbs/arm_cut.h"
#include "cli/verbs/arm_model.h"
#include "cli/verbs/arm_plot.h"
#include "cli/verbs/arm_relief.h"
#include "cli/verbs/arm_views.h"
#include "cli/verbs/map_plot.h"
#include "cli/verbs/play_arm_flags.h"
#include "cli/verbs/play_device.h"
#include "cli/verbs/play_found.h"
#include "cli/verbs/play_frame.h"
#include "cli/verbs/play_guidance.h"
#include "cli/verbs/play_map.h"
#include "cli/verbs/play_plan.h"
#include "cli/verbs/play_scene.h"
#include "tactics/error.h"
#include "tactics/information/media.h"
#include "tactics/job/holds.h"
#include "tactics/job/table.h"
#include "tactics/readers/model.h"
#include "tactics/units.h"

namespace tactics {

namespace {

constexpr std::string_view kArmFlags[] = {"--arm",      "--hand",   "--plane",   "--feel", "--fixture", "--speak",
                                          "--language", "--levels", "--section", "--view", "--guide",   "--tones"};
constexpr std::string_view kMouseFlags[] = {"--wall",    "--damping-sign", "--edges",  "--lever", "--fusion", "--learned",
                                            "--overlay", "--overlay-size", "--map-at", "--part",  "--track",  "--stable"};
constexpr std::string_view kPlotFlags[] = {"--feel", "--fixture"};
constexpr std::string_view kRadius[] = {"--radius"};
constexpr std::string_view kTableFlags[] = {"--x",         "--y",      "--z",     "--group", "--points",  "--steps",
                                            "--histogram", "--matrix", "--log-x", "--log-y", "--decimal", "--dates"};
constexpr std::string_view kModelFlags[] = {"--width", "--radius"};
constexpr std::string_view kMapFlags[] = {"--pitch", "--low",    "--high", "--recipe", "--filter",
                                          "--set",   "--detail", "--page", "--best"};

// A point would be caught at the upright side of each line, however low; a ball of that radius rolls over 0.5 mm as over a slope
// of 41 degrees. Ours.
constexpr double kFingertip = 2;  // mm

void refuse(const Given& given, std::span<const std::string_view> flags, const Phrase& why) {
    for (const std::string_view flag : flags)
        if (given.has(flag)) throw Error(Fault::usage, flag, why);
}

ArmScene scene_in(const std::string& path, const Given& given, const ArmFile& arm, std::vector<Phrase>& told) {
    Source source = open_source(path);
    source.allowed = allowed_formats(given);
    const Holds holds = look_at(source);
    const CutWish cut = cut_wish(given);
    const Point field = most_of_plane(plane_of(given).value_or(kUpright), arm.arm);
    const auto whole_or_cut = [&](Plot plot) {
        if (!cut.any()) return plot_on_arm(std::move(plot), given, arm, told);
        ArmScene scene = plot_on_arm(cut_of(plot, cut, field, path, told), given, arm, told);
        if (cut.levels) scene.contoured = std::move(plot.surfaces.front());
        return scene;
    };
    if (holds == Holds::table) {
        refuse(given, kModelFlags,
               phrase("it is about maps and models, and a table is felt on an arm as its plot; leave it out"));
        refuse(given, kMapFlags, phrase("it is about maps, and a table is felt on an arm as its plot; leave it out"));
        return whole_or_cut(plot_of(source, table_wish(given), told));
    }
    refuse(given, kTableFlags, phrase("it is about the plot of a table, and {0} is none; leave it out", path));
    if (!cut.any()) refuse(given, kPlotFlags, phrase("it is about a plot; a surface is one with --levels or --section, too"));
    if (holds == Holds::model && !cut.any()) {
        refuse(
            given, kMapFlags,
            phrase(
                "a model is felt on an arm as it is, from all sides; leave it out, or make a map of it first: tactics relief"));
        const Mesh mesh = read_mesh(source, told);
        return model_on_arm(mesh, path, given, arm, told);
    }
    MapWish wish = map_wish(given, real_disk());
    take_arm_as_paper(wish.drawing, given, arm);
    if (given.has("--best")) wish.best_for = channel_of(given.value("--arm", std::string(kArms.front().name)), arm.arm);
    FeltHeights felt = felt_map(std::move(source), path, wish, given.has("--quiet"));
    if (!cut.any()) return relief_on_arm(std::move(felt), wish.radius.value_or(kFingertip), given, arm, told);
    refuse(given, kRadius, phrase("lines are felt by a point; leave it out"));
    if (felt.drawn)
        throw Error(
            Fault::usage, cut.levels ? "--levels" : "--section",
            phrase("{0} is drawn as lines, which are no surface; take its lightness as heights, for example --high 10mm", path));
    return whole_or_cut(plot_of_map(felt.file.map, kMostSamples));
}

// Checks the request as far as possible before anything is read.
struct ArmPlan {
    std::string device, path, csv;
    const DeviceKind* kind;
    ArmFile arm;
    const HandKind* hand;
    std::vector<ChartFile> charts;
    ArmView view;
    bool quiet, json;
};

ArmPlan plan_arm(const Given& given) {
    refuse(given, kMouseFlags, phrase("it is about a mouse; leave it out, or take another --device"));
    if (given.words.size() != 1)
        throw Error(Fault::usage, "play",
                    phrase("name one table, picture, height map or model; for example: tactics play data.csv --device arm"));
    check_page_flags(given);
    if (given.has("--view") && !given.has("--plot"))
        throw Error(Fault::usage, "--view", phrase("it is of the drawing of --plot; name that, too"));
    const Disk disk = real_disk();
    ArmPlan plan{given.value("--device"), given.words[0],       given.value("--csv"), nullptr, arm_of(given), &hand_of(given), {},
                 view_of(given),          given.has("--quiet"), given.has("--json")};
    plan.kind = &kind_of_device(plan.device);
    if (given.has("--plot")) plan.charts = plan_chart_files(given, "--plot", disk);
    std::vector<std::string> outputs;
    if (plan.json) outputs.push_back("-");
    if (!plan.csv.empty()) outputs.push_back(plan.csv);
    if (given.value("--tones").ends_with(".wav")) outputs.push_back(given.value("--tones"));
    for (const ChartFile& chart : plan.charts)
        for (std::string& name : file_names(chart, pages_of(plan.view), disk)) outputs.push_back(std::move(name));
    const auto colon = plan.device.find(':');
    const std::string where = plan.kind->real || colon == std::string::npos ? "" : plan.device.substr(colon + 1);
    check_names(outputs, {plan.path, where, given.value("--arm")}, plan.json, disk);
    return plan;
}

}  // namespace

std::span<const std::string_view> arm_flags() { return kArmFlags; }

int play_on_arm(const Given& given) {
    const auto called = std::chrono::steady_clock::now();
    const ArmPlan plan = plan_arm(given);
    const ArmSettings& arm = plan.arm.arm;
    std::vector<Phrase> told;
    const ArmScene scene = scene_in(plan.path, given, plan.arm, told);
    if (!plan.quiet)
        for (const Phrase& line : told) say(phrase("{0}: {1}", plan.path, line));
    const PlotFrame& frame = scene.frame;
    if (scene.solid && plan.hand->of_plots)
        throw Error(Fault::usage, "--hand",
                    phrase("a relief and a model have no curves and no points; take to-and-fro or sections"));

    DeviceWish wish;
    wish.axes = 3;
    wish.arm = plan.arm;
    wish.mounting = scene.mounting;
    wish.seconds = number_value(given, "--seconds", 60, 0.001, 86'400);
    const std::unique_ptr<Hand> hand = plan.hand->make(
        {frame.width, frame.height, frame.depth, number_value(given, "--speed", 40, 1, 2000), keys_to_press(given, *plan.hand)});
    wish.hand = hand.get();
    std::unique_ptr<HapticDevice> device = open_mouse(plan.device, wish, {});
    // A recorded way is one over the scene already.
    if (plan.kind->axes == 3) device = mounted(std::move(device), scene.mounting);

    PlotLayers layers(given, scene.plot, frame, {*scene.scene, scene.law, arm.most_force, scene.resolution});
    SceneWish played_wish{plan.device, {}, std::nullopt, given.has("--real-time") || layers.are_heard(), plan.csv, {}, scene.law};
    if (plan.kind->ends || given.has("--seconds")) played_wish.seconds = wish.seconds;
    played_wish.settings.rate_hz = arm.rate_hz;
    played_wish.settings.safety.most_force = arm.most_force;
    played_wish.columns.spatial = true;
    layers.begin(played_wish.by_wall || device->is_real());
    const double ready = std::chrono::duration<double>(std::chrono::steady_clock::now() - called).count();
    const PlayedScene played = play_scene(layers.scene(), *device, nullptr, std::move(played_wish));
    layers.finish();
    if (!plan.charts.empty()) write_chart_pages(arm_views(scene, played.records, plan.view), plan.charts);
    HandReport found;
    if (plan.kind->has_hand) found = report_of(*plan.hand, *hand, played.records, scene.plot, frame);
    layers.tell_ways(played, found);
    // The same input has the same figures, unless they are those of a clock.
    if (played.figures.real) {
        found.lines.push_back(phrase("it could be felt {0} s after it was asked for", numeral(std::round(ready * 100) / 100)));
        found.json += (found.json.empty() ? "" : ",") + std::string("\"ready_s\":") + to_text(ready);
    }
    found.json = frame_json(frame, scene.mounting) + (found.json.empty() ? "" : ",") + found.json;
    tell_figures(played, plan.quiet, plan.json, found.json);
    if (!plan.quiet && !plan.json)
        for (const Phrase& line : found.lines) say(line);
    if (played.unlogged) throw *played.unlogged;
    return 0;
}

}  // namespace tactics
