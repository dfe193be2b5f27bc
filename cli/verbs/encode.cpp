// SPDX-License-Identifier: Apache-2.0
// `tactics encode`: heights, or what was felt in a play, packed for storing and sending.
#include <algorithm>
#include <cmath>
#include <optional>

#include "cli/choice_value.h"
#include "cli/command.h"
#include "cli/report/say.h"
#include "cli/verbs/ticks_in.h"
#include "print/height_files.h"
#include "tactics/coding/device_filter.h"
#include "tactics/error.h"
#include "tactics/haptics/simulated/arm.h"
#include "tactics/job/disk.h"
#include "tactics/relief/read_heights.h"
#include "tactics/text/json.h"
#include "tactics/transport/file.h"
#include "tactics/units.h"

namespace tactics {

namespace {

// Below it, a hand cannot distinguish forces, regardless of the share; our own choice, of the order of the smallest force that a
// fingertip feels.
constexpr double kFloor = 0.01;  // N
// The energy of 45 g, the mass of an arm at the fingertip (ArmSettings), at 67 mm/s; our own choice.
constexpr double kAllowance = 0.1;  // N mm
constexpr double kMostShare = 0.5;

constexpr Flag kEncodeFlags[] = {
    {"--output", "-o", "OUT.felt", "where to write", false, "files"},
    {"--deadband", "", "SHARE",
     "of a recording: store a force only where the prediction misses it by more than this share (10%, at most 50%) and by more "
     "than 0.01 N; by default every force is kept exactly",
     false, "5% 10% 15% 20%"},
    {"--predict", "", "hold|linear",
     "with --deadband, how forces in between are predicted: hold repeats the last one, linear continues a straight line; "
     "default: hold",
     false, "hold linear"},
    {"--device", "", "omni|desktop|phantom",
     "soft encoding, for this arm alone: places and heights in steps of its resolution, forces in steps of 0.01 N and no larger "
     "than it can give; by default as in the source, for any device",
     false, "omni desktop phantom"},
    {"--json", "", "", "one JSON object on standard output: what was packed, how small and how exactly", false, ""},
    {"--quiet", "-q", "", "nothing but errors", false, ""},
};

struct EncodePlan {
    std::string input, output;
    std::optional<DeviceSteps> device;
    std::string device_name;
    ForceBand band;
};

double share_of(const Given& given) {
    std::string text = given.value("--deadband");
    const bool percent = text.ends_with('%');
    if (percent) text.pop_back();
    const auto number = parse_number(text);
    const double share = number.value_or(-1) / (percent ? 100 : 1);
    if (!(share > 0 && share <= kMostShare))
        throw Error(
            Fault::usage, "--deadband",
            phrase("it cannot be \"{0}\"; it is over 0 and at most 50%, such as 10%", given.value("--deadband").substr(0, 80)));
    return share;
}

EncodePlan plan_encode(const Given& given) {
    if (given.words.size() != 1)
        throw Error(Fault::usage, "encode",
                    phrase("name one recording (play writes it with --csv) or one file of heights; for example: tactics encode "
                           "ticks.csv -o ticks.felt"));
    if (!given.has("--output")) throw Error(Fault::usage, "encode", phrase("say where to write it: -o ticks.felt"));
    EncodePlan plan{given.words[0], given.value("--output"), {}, {}, {}};
    const Disk disk = real_disk();
    if (plan.input != "-" && disk.identity(plan.input) == disk.identity(plan.output))
        throw Error(Fault::usage, "--output", phrase("{0} is the input; choose another name", plan.output));
    if (given.has("--deadband")) plan.band = {share_of(given), kFloor, kAllowance, ForceGuess::hold};
    if (const auto guess = choice_value(given, "--predict", {"hold", "linear"})) {
        if (!given.has("--deadband"))
            throw Error(Fault::usage, "--predict",
                        phrase("without --deadband every force is kept; leave it out, or add --deadband 10%"));
        plan.band.guess = *guess == 0 ? ForceGuess::hold : ForceGuess::linear;
    }
    std::vector<std::string_view> names;
    for (const NamedArm& arm : kArms) names.push_back(arm.name);
    if (const auto arm = choice_value(given, "--device", names)) {
        plan.device = DeviceSteps{kArms[*arm].arm.resolution, kFloor, kArms[*arm].arm.most_force};
        plan.device_name = names[*arm];
    }
    return plan;
}

Phrase in_steps(double value, double step) { return numeral(std::round(value / step) * step); }

void finish(const EncodePlan& plan, const Given& given, const std::string& bytes, const std::vector<Phrase>& notes,
            JsonAnswer object, const Phrase& line) {
    write_file(plan.output, bytes);
    const std::string name = plan.input == "-" ? "standard input" : plan.input;
    if (given.has("--json")) {
        object.add("device", plan.device_name);
        object.add("bytes", static_cast<double>(bytes.size()));
        object.add_raw("notes", json_text_array(notes));
        object.add("output", plan.output);
        print_out(object.text() + "\n");
    } else if (!given.has("--quiet")) {
        for (const Phrase& note : notes) say(phrase("{0}: {1}", name, note));
        say(phrase("{0}: {1}; {2} bytes", name, line, std::to_string(bytes.size())));
    }
}

int encode_ticks(const EncodePlan& plan, const Given& given, TickTable ticks) {
    const Recording truth = plan.device ? for_device(ticks.recording, *plan.device) : std::move(ticks.recording);
    const EncodedRecording encoded = encode_recording(truth, plan.band);
    const ForceLoss loss = loss_of(truth, decode_recording(Container(encoded.bytes, plan.output)), plan.band);
    const auto count = static_cast<double>(truth.times.size());
    const double seconds = static_cast<double>(truth.times.back() - truth.times.front()) / 1e6;
    JsonAnswer object;
    object.add("input", plan.input);
    object.add("kind", "recording");
    object.add("ticks", count);
    object.add("seconds", seconds);
    object.add("touched", static_cast<double>(loss.touched) / count);
    object.add("place_step_mm", truth.place_step);
    object.add("force_step_n", truth.force_step);
    object.add("deadband", plan.band.share);
    object.add("floor_n", plan.band.floor);
    object.add("work_allowed_nmm", plan.band.allowance);
    object.add("predict", plan.band.share > 0 ? plan.band.guess == ForceGuess::hold ? "hold" : "linear" : "none");
    object.add("forces_told", static_cast<double>(encoded.told));
    object.add("told_per_1000", 1000 * static_cast<double>(encoded.told) / count);
    object.add("rms_error_n", loss.rms);
    object.add("most_error_n", loss.most);
    object.add("most_of_threshold", loss.of_threshold);
    object.add("work_added_nmm", loss.work);
    Phrase line = phrase("{0} ticks in {1} s", std::to_string(truth.times.size()), in_steps(seconds, 1e-3));
    if (plan.band.share > 0)
        line = phrase(
            "{0}, of which {1} tell a force ({2} of 1000); forces within {3} % or {4} N, at most {5} % of that; at most "
            "{6} N mm more work than recorded, of {7} allowed",
            std::move(line), std::to_string(encoded.told), in_steps(1000 * static_cast<double>(encoded.told) / count, 0.1),
            in_steps(100 * plan.band.share, 0.1), numeral(plan.band.floor), in_steps(100 * loss.of_threshold, 1),
            in_steps(loss.work, 1e-3), numeral(plan.band.allowance));
    else
        line = phrase("{0}, all forces as they are", std::move(line));
    finish(plan, given, encoded.bytes, ticks.notes, std::move(object), line);
    return 0;
}

int encode_heights(const EncodePlan& plan, const Given& given, Source& source) {
    if (plan.band.share > 0)
        throw Error(Fault::usage, "--deadband", phrase("it is about forces, and {0} holds none; leave it out", source.name));
    const HeightFile file = read_heights(source, {});
    LevelMap map = level_map_of(sheet_of(file.map, file.low, file.high), rows_of(file.map));
    if (plan.device) map = for_device(std::move(map), *plan.device);
    const std::string bytes = encode_levels(map);
    JsonAnswer object;
    object.add("input", plan.input);
    object.add("kind", "heights");
    object.add("columns", map.columns);
    object.add("rows", map.rows);
    object.add("pitch_mm", map.pitch);
    object.add("low_mm", map.low);
    object.add("high_mm", map.high);
    object.add("levels", map.top + 1);
    finish(plan, given, bytes, file.notes, std::move(object),
           phrase("{0} x {1} heights of {2} levels from {3} to {4} mm", std::to_string(map.columns), std::to_string(map.rows),
                  std::to_string(map.top + 1), in_steps(map.low, 1e-3), in_steps(map.high, 1e-3)));
    return 0;
}

int run_encode(const Given& given) {
    const EncodePlan plan = plan_encode(given);
    Source source = open_source(plan.input);
    if (auto ticks = ticks_in(source)) return encode_ticks(plan, given, std::move(*ticks));
    return encode_heights(plan, given, source);
}

}  // namespace

extern const Command encode_command;
const Command encode_command{
    .name = "encode",
    .summary = "pack heights, or the forces and paths of a play, for storing and sending",
    .words = "INPUT -o OUT.felt",
    .details =
        "INPUT is a recording as play --csv writes it (time_s,x_mm,y_mm,finger_mm,force_n and, in space, force_x_n,force_y_n), "
        "or heights: a height map, a picture or a model, as relief reads them. relief has options for these, and also writes "
        ".felt. decode unpacks the file.\n\n"
        "Heights keep all of their up to 65536 levels, and a recording is kept exactly, unless --deadband or --device is given. "
        "--deadband leaves out forces that a hand cannot tell from the predicted ones (Weber's law): at every tick, and "
        "whatever its direction, the decoded force is within the given share of the true one, or within 0.01 N. Over no stretch "
        "of the recording does it give out over 0.1 N mm more work than the true one, so that no decoder makes a device "
        "tremble. tactics measures both afterwards and reports them.\n\n"
        "tactics help felt describes the file.",
    .example =
        "tactics encode ticks.csv -o ticks.felt --deadband 10%\n"
        "tactics encode ticks.csv -o ticks.felt --deadband 10% --predict hold --device omni --json\n"
        "tactics encode terrain.png -o terrain.felt --device omni",
    .flags = kEncodeFlags,
    .offers = "files",
    .run = run_encode,
};

}  // namespace tactics
