// SPDX-License-Identifier: Apache-2.0
#include "cli/verbs/play_plan.h"

#include <cstdlib>
#include <span>

#include "cli/request.h"
#include "tactics/error.h"
#include "tactics/information/media.h"
#include "tactics/job/disk.h"
#include "tactics/text/words.h"
#include "tactics/units.h"

namespace tactics {

namespace {

// Options for the pages of charts, passed on to convert.
constexpr std::string_view kPageFlags[] = {"--paper", "--medium", "--margin", "--orientation", "--title", "--braille", "--dpi"};

ForceLaw law_of(const Given& given) {
    ForceLaw law;
    law.stiffness = number_value(given, "--stiffness", law.stiffness, 0.001, 1000);
    law.damping_ns_per_m = number_value(given, "--damping", law.damping_ns_per_m, 0, 100);
    const std::string sign = given.value("--damping-sign", "corrected");
    if (sign != "corrected" && sign != "as_printed")
        throw Error(Fault::usage, "--damping-sign", phrase("it is corrected or as_printed"));
    if (sign == "as_printed") law.sign = DampingSign::as_printed;
    return law;
}

WallMethod wall_of(const Given& given) {
    const std::string name = given.value("--wall", "look-ahead");
    const auto method = wall_method(name);
    if (method) return *method;
    std::vector<std::string_view> names;
    for (const NamedWall& wall : wall_methods()) names.push_back(wall.name);
    throw Error(
        Fault::usage, "--wall",
        phrase("there is no way \"{0}\" into a wall{1}; see tactics help play", name.substr(0, 80), did_you_mean(name, names)));
}

std::optional<Point> part_of(const Given& given) {
    if (!given.has("--part")) return std::nullopt;
    const auto part = two_lengths(given.value("--part"), ',');
    if (!part || !(part->x < part->y))
        throw Error(Fault::usage, "--part", phrase("it is from where to where on the map, such as 70mm,80mm"));
    if (!given.has("--plot")) throw Error(Fault::usage, "--part", phrase("it is of the drawing of --plot; name that, too"));
    return part;
}

// Refuses options that would have no effect but were certainly meant to have one.
void check_company(const Given& given, const DeviceKind& kind) {
    const auto refuse = [&](std::span<const std::string_view> flags, const Phrase& why) {
        for (const std::string_view flag : flags)
            if (given.has(flag)) throw Error(Fault::usage, flag, why);
    };
    constexpr std::string_view kOfAPlay[] = {"--device",    "--csv",     "--plot",   "--track",  "--seconds", "--speed",
                                             "--real-time", "--overlay", "--fusion", "--recipe", "--learned", "--filter",
                                             "--set",       "--detail",  "--page",   "--best"};
    constexpr std::string_view kSpeed[] = {"--speed"}, kFusion[] = {"--fusion", "--learned"}, kTrack[] = {"--track"};
    if (given.words.empty()) refuse(kOfAPlay, phrase("it is about a play; name a height map to be played"));
    if (!kind.has_hand) refuse(kSpeed, phrase("it is that of a simulated hand; this mouse is moved by another"));
    if (!kind.finds_place) refuse(kFusion, phrase("this mouse knows its place; take --device sensed, or hid:"));
    if (kind.real) refuse(kTrack, phrase("a real mouse does not know where its finger truly is; take --device sensed"));
    if (!kind.knows_truth) refuse(kTrack, phrase("this mouse knows its place; take --device sensed"));
}

// The folder for persistent state (XDG Base Directory Specification 0.8). Empty: there is no home folder.
std::string own_learned_file() {
    const char* state = std::getenv("XDG_STATE_HOME");
    if (state != nullptr && state[0] == '/') return std::string(state) + "/tactics/learned-pointing";
    const char* home = std::getenv("HOME");
    return home != nullptr && home[0] == '/' ? std::string(home) + "/.local/state/tactics/learned-pointing" : "";
}

std::vector<std::string> outputs_of(const PlayPlan& plan, bool json) {
    std::vector<std::string> outputs;
    if (json) outputs.push_back("-");
    if (!plan.csv.empty()) outputs.push_back(plan.csv);
    if (!plan.learned.empty()) outputs.push_back(plan.learned);
    for (const auto* charts : {&plan.way, &plan.track, &plan.stable})
        for (const ChartFile& chart : *charts) outputs.push_back(chart.path);
    return outputs;
}

}  // namespace

void check_names(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs, bool json, const Disk& disk) {
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        const auto same = [&](const std::string& other) { return disk.identity(outputs[i]) == disk.identity(other); };
        for (const std::string& input : inputs)
            if (outputs[i] != "-" && !input.empty() && input != "-" && same(input))
                throw Error(Fault::usage, "play",
                            phrase("{0} would be written over, and it is read; choose another name", outputs[i]));
        const Phrase name = outputs[i] == "-" ? phrase("standard output") : Phrase(outputs[i]);
        for (std::size_t k = 0; k < i; ++k)
            if (outputs[i] == "-" ? outputs[k] == "-" : same(outputs[k]))
                throw Error(Fault::usage, "play",
                            json ? phrase("{0} is named for two outputs (--json goes to standard output); choose another name "
                                          "for one of them",
                                          name)
                                 : phrase("{0} is named for two outputs; choose another name for one of them", name));
    }
}

void check_page_flags(const Given& given) {
    if (given.has("--plot") || given.has("--track") || given.has("--stable")) return;
    for (const std::string_view flag : kPageFlags)
        if (given.has(flag))
            throw Error(Fault::usage, flag, phrase("it is about a drawing; name one with --plot, --track or --stable"));
}

PlayPlan plan_play(const Given& given) {
    if (given.words.size() > 1 || (given.words.empty() && !given.has("--stable")))
        throw Error(
            Fault::usage, "play",
            phrase("name one picture, drawing, model or height map; for example: tactics play relief.png --device simulated"));
    const Disk disk = real_disk();
    PlayPlan plan;
    plan.device = given.value("--device", std::string(device_kinds().front()->name));
    const DeviceKind& kind = kind_of_device(plan.device);
    check_company(given, kind);
    check_page_flags(given);
    if (!given.words.empty()) plan.map = given.words[0];
    plan.wish = map_wish(given, disk);
    plan.overlay = overlay_of(given);
    plan.machine = machine_of(given);
    if (given.has("--best")) plan.wish.best_for = channel_of(plan.machine);
    plan.feel.wall.method = wall_of(given);
    plan.feel.wall.law = law_of(given);
    plan.feel.wall.lever = plan.machine.lever;
    plan.feel.wall.finger = plan.machine.finger;
    plan.feel.edges.force_per_speed = number_value(given, "--edges", 100 * plan.feel.edges.force_per_speed, 0, 5) / 100;
    plan.settings.rate_hz = plan.machine.lever.rate_hz;
    plan.settings.safety.most_force = plan.machine.lever.most_force;
    const std::string fusion = given.value("--fusion", "learning");
    if (fusion != "learning" && fusion != "paper") throw Error(Fault::usage, "--fusion", phrase("it is learning or paper"));
    plan.paper_fusion = fusion == "paper";
    if (plan.paper_fusion && given.has("--learned"))
        throw Error(Fault::usage, "--learned", phrase("the paper's way learns nothing; leave out --fusion paper"));
    plan.own_learned = !given.has("--learned");
    if (kind.finds_place && !plan.paper_fusion)
        plan.learned = plan.own_learned ? (kind.real ? own_learned_file() : "") : given.value("--learned");
    if (plan.learned == "-") plan.learned.clear();
    plan.speed = number_value(given, "--speed", plan.speed, 1, 2000);
    if (given.has("--seconds") || kind.ends) plan.seconds = number_value(given, "--seconds", 10, 0.001, 86'400);
    if (given.has("--csv")) plan.csv = given.value("--csv");
    const auto charts = [&](std::string_view flag) {
        return given.has(flag) ? plan_chart_files(given, flag, disk) : std::vector<ChartFile>{};
    };
    plan.way = charts("--plot");
    plan.track = charts("--track");
    plan.stable = charts("--stable");
    plan.part = part_of(given);
    const auto colon = plan.device.find(':');
    const std::string where = kind.real || colon == std::string::npos ? "" : plan.device.substr(colon + 1);
    check_names(outputs_of(plan, given.has("--json")), {plan.map, where, given.value("--lever")}, given.has("--json"), disk);
    return plan;
}

}  // namespace tactics
