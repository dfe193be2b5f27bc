// `tactics play`: a relief on a haptic mouse.
#include <algorithm>
#include <cmath>
#include <optional>

#include "cli/chart_files.h"
#include "cli/command.h"
#include "cli/disk.h"
#include "cli/interrupt_count.h"
#include "cli/json.h"
#include "cli/page_flags.h"
#include "cli/play_device.h"
#include "cli/play_report.h"
#include "cli/request.h"
#include "cli/say.h"
#include "cli/tick_log.h"
#include "tactics/error.h"
#include "tactics/haptics/mouse_loop.h"
#include "tactics/haptics/stability.h"
#include "tactics/read_heights.h"
#include "tactics/units.h"
#include "tactics/words.h"

namespace tactics {

namespace {

constexpr std::string_view kPageFlags[] = {"--paper", "--medium", "--margin", "--orientation", "--title", "--braille", "--dpi"};

constexpr Flag kFlags[] = {
    {"--device", "-d", "DEVICE", "the mouse: simulated, sensed (simulated, and it has to find its place by sensors that are wrong), recorded:FILE.csv (time_s,x_mm,y_mm a line), hid: or hid:/dev/hidraw0; simulated if none is named", false, ""},
    {"--pitch", "", "LENGTH", "from sample to sample, for a map that does not tell it", false, ""},
    {"--width", "", "LENGTH", "of the map from its left edge to its right, instead of --pitch", false, ""},
    {"--low", "", "LENGTH", "height of black, for a map that does not tell it", false, ""},
    {"--high", "", "LENGTH", "height of white, for a map that does not tell it", false, ""},
    {"--radius", "", "LENGTH", "radius of the fingertip, which reaches no pit that is narrower; 0 if none is named", false, ""},
    {"--wall", "", "METHOD", "what is done where the height jumps: look-ahead if none is named; raw, steps (the paper's), rate-limit, governor, slope", false,
     "raw steps rate-limit governor look-ahead slope"},
    {"--stiffness", "", "NUMBER", "of the surface, N/mm; 1 if none is named", false, ""},
    {"--damping", "", "NUMBER", "of the surface, N s/m; 1 if none is named", false, ""},
    {"--damping-sign", "", "corrected|as_printed", "as_printed has the sign of the paper's equation 1, which is refused, as it is unstable", false, "corrected as_printed"},
    {"--edges", "", "NUMBER", "strength of the short swing that is felt at edges, N at 100 mm/s; 0.5 if none is named, 0 for none", false, ""},
    {"--lever", "", "light|heavy|FILE", "the machine: 30 g, 100 g, or a file of the numbers of its lever, finger and sensors; light if none is named", false, "light heavy files"},
    {"--finger", "", "soft|nominal|stiff", "the finger that is reckoned with, and simulated; if none is named that of the file, or nominal, or soft on a real mouse", false, "soft nominal stiff"},
    {"--fusion", "", "learning|paper", "how overlay and optical sensors are put together", false, "learning paper"},
    {"--speed", "", "NUMBER", "of the simulated hand, mm/s; 50 if none is named", false, ""},
    {"--seconds", "", "NUMBER", "how long; 10 if none is named, and for a real mouse until the stop key or Ctrl-C", false, ""},
    {"--rate", "", "NUMBER", "ticks a second; 1000 if none is named", false, ""},
    {"--real-time", "", "", "by the clock on the wall for the simulated mouse, too, and before all other programs if that is permitted", false, ""},
    {"--overlay", "", "FILE", "the touch overlay that sees the finger on a real mouse: its device, such as /dev/input/event5, or auto for the only one that is there", false, "files"},
    {"--overlay-size", "", "WIDTHxHEIGHT", "of the field that the overlay sees, such as 600x340mm, if it does not tell that", false, ""},
    {"--map-at", "", "X,Y", "where on the overlay the upper left corner of the map is, to the right and down, such as 50mm,30mm; its own corner if none is named", false, ""},
    {"--csv", "", "FILE", "write every tick: time, place, heights, force; until the end it is called FILE.part", false, "files"},
    {"--plot", "", "FILE", "draw the way of the fingertip over the profile, as a page: .svg, .png, .pdf. May be given several times", true, "files"},
    {"--track", "", "FILE", "draw where the fingertip was and where the mouse took it to be, on the last way, over time", true, "files"},
    {"--stable", "", "FILE", "draw which stiffness and damping this machine bears; a MAP is not needed for it", true, "files"},
    {"--paper", "-p", "PAPER", "paper of --plot, --track and --stable", false, "papers"},
    {"--medium", "-m", "MEDIUM", "what they are printed on", false, "media"},
    kMarginFlag,
    kOrientationFlag,
    {"--title", "", "TEXT", "title of them", false, ""},
    kBrailleFlag,
    {"--dpi", "", "NUMBER", "dots per inch of their .png and .tif", false, ""},
    {"--quiet", "-q", "", "say nothing but errors", false, ""},
    {"--json", "", "", "tell the figures on standard output, as a JSON object", false, ""},
};

ForceLaw law_of(const Given& given) {
    ForceLaw law;
    law.stiffness = number_value(given, "--stiffness", law.stiffness, 0.001, 1000);
    law.damping_ns_per_m = number_value(given, "--damping", law.damping_ns_per_m, 0, 1000);
    const std::string sign = given.value("--damping-sign", "corrected");
    if (sign != "corrected" && sign != "as_printed") throw Error(Fault::usage, "--damping-sign", "it is corrected or as_printed");
    if (sign == "as_printed") law.sign = DampingSign::as_printed;
    return law;
}

std::vector<FingerSettings> any_finger() {
    std::vector<FingerSettings> fingers;
    for (const NamedFinger& one : kFingers) fingers.push_back(one.finger);
    return fingers;
}

// A surface that the machine would make tremble is refused before it is switched on.
void check_law(const ForceLaw& law, const LeverSettings& lever) {
    const StableCheck check = check_stable(law, lever, any_finger());
    if (check.stable) return;
    throw Error(Fault::usage, law.sign == DampingSign::as_printed ? "--damping-sign" : "--stiffness",
                check.reason + ": --stiffness " + to_text(std::floor(check.stiffness * 100) / 100) + " --damping " + to_text(std::round(check.damping_ns_per_m * 100) / 100) +
                    (law.sign == DampingSign::as_printed ? " --damping-sign corrected" : ""));
}

WallMethod wall_of(const Given& given) {
    const std::string name = given.value("--wall", "look-ahead");
    const auto method = wall_method(name);
    if (method) return *method;
    std::vector<std::string_view> names;
    for (const NamedWall& wall : wall_methods()) names.push_back(wall.name);
    throw Error(Fault::usage, "--wall", "there is no way \"" + name.substr(0, 80) + "\" into a wall" + did_you_mean(name, names) + "; see tactics help play");
}

HeightMap map_of(const Given& given) {
    HeightWish wish;
    const auto length = [&](std::string_view flag, std::optional<double>& value) {
        if (!given.has(flag)) return;
        value = parse_length(given.value(flag));
        if (!value) throw Error(Fault::usage, flag, "it is a length such as 0.5mm");
    };
    length("--pitch", wish.pitch);
    length("--width", wish.width);
    length("--low", wish.low);
    length("--high", wish.high);
    HeightFile file = read_heights(given.words[0], wish);
    if (!given.has("--quiet"))
        for (const std::string& note : file.notes) say(given.words[0] + ": " + note);
    return std::move(file.map);
}

double radius_of(const Given& given) {
    const double radius = given.has("--radius") ? parse_length(given.value("--radius")).value_or(-1) : 0;
    if (!(radius >= 0 && radius <= 20)) throw Error(Fault::usage, "--radius", "it is a length from 0 to 20mm");
    return radius;
}

std::unique_ptr<Fusion> fusion_of(const Given& given, const MouseGeometry& geometry) {
    const std::string name = given.value("--fusion", "learning");
    if (name != "learning" && name != "paper") throw Error(Fault::usage, "--fusion", "it is learning or paper");
    return name == "paper" ? paper_fusion(geometry) : learning_fusion(geometry);
}

// The files of the charts, planned before anything moves.
struct Charts {
    std::vector<ChartFile> way, track, stable;
};

Charts charts_of(const Given& given) {
    const auto plan = [&](std::string_view flag) { return given.has(flag) ? plan_chart_files(given, flag, kPageFlags, real_disk()) : std::vector<ChartFile>{}; };
    return {plan("--plot"), plan("--track"), plan("--stable")};
}

int play(const Given& given, const MouseSettings& machine, PlaySettings settings, const Charts& charts) {
    const double rate = machine.lever.rate_hz, radius = radius_of(given);
    const std::optional<OverlayWish> overlay = overlay_of(given);
    const auto fusion = fusion_of(given, geometry_of(machine.sensors));
    const std::string name = given.value("--device", "simulated");
    const bool real = is_real_mouse(given);
    const double speed = number_value(given, "--speed", 50, 1, 2000);
    const std::optional<double> seconds =
        given.has("--seconds") || !real ? std::optional(number_value(given, "--seconds", 10, 0.001, 86'400)) : std::nullopt;
    HeightMap map = map_of(given);
    if (radius > 0) map = dilated(map, radius);
    const ReliefSurface surface(std::move(map));
    const std::unique_ptr<MouseDevice> device = open_mouse({name, machine, surface, speed, seconds.value_or(0), overlay});
    settings.most_records = static_cast<std::size_t>(std::clamp(rate * seconds.value_or(600), 1000.0, 2e6));
    settings.begin = {name == "sensed" ? 0 : surface.map().width() / 2, surface.map().height() / 2};
    if (real && !overlay && !given.has("--quiet")) say(name + ": the finger begins in the middle of the map, as no overlay tells where it is");
    MousePlay play(surface, fusion.get(), settings);
    std::optional<TickLog> log;
    if (given.has("--csv")) log.emplace(given.value("--csv"), play.recorder(), name == "sensed");
    count_interrupts();
    const bool by_wall = device->is_real() || given.has("--real-time");
    if (log && by_wall) log->write_beside();
    const auto ended = [&] {
        if (log && !by_wall) log->keep_up();
        return interrupts() > 0;
    };
    const MouseLoop loop{rate, seconds, ended, [&](MouseNews news, const std::string& why) {
                             const std::string place = name == "hid:" ? "hid" : name;
                             if (news == MouseNews::gone) say(place + ": the mouse is gone; plug it in again, or end with Ctrl-C");
                             else if (news == MouseNews::silent) say(place + ": the mouse says nothing, its force is off; unplug it and plug it in again, or end with Ctrl-C");
                             else say(news == MouseNews::back ? place + ": there again" : why);
                         }};
    // By the clock on the wall where something moves by it; else as quickly as the processor can.
    StepClock stepped;
    std::optional<MonotonicClock> punctual;
    if (by_wall) punctual.emplace(true);
    const MouseLoopReport played = run_mouse(loop, punctual ? static_cast<Clock&>(*punctual) : stepped, *device, play);
    const bool before_others = punctual && punctual->goes_before_others();
    punctual.reset();

    const std::vector<TickRecord> records = play.recorder().records();
    if (log) log->finish();
    if (!charts.way.empty()) write_chart_files(way_plot(records, surface), charts.way);
    if (!charts.track.empty()) write_chart_files(track_plot(records), charts.track);
    const PlayFigures figures = figures_of(records, played.loop, play.safety(), fusion->resets(), played.gone, before_others, by_wall);
    if (given.has("--json")) print_out(figures_json(figures) + "\n");
    else if (!given.has("--quiet"))
        for (const std::string& line : figure_lines(figures, play.recorder().lost())) say(line);
    return 0;
}

int run(const Given& given) {
    if (given.words.size() > 1 || (given.words.empty() && !given.has("--stable")))
        throw Error(Fault::usage, "play", "name one height map; for example: tactics play relief.png --device simulated");
    if (given.has("--track") && is_real_mouse(given))
        throw Error(Fault::usage, "--track", "a real mouse does not know where its finger truly is; take --device sensed");
    const Charts charts = charts_of(given);
    const MouseSettings machine = machine_of(given);
    PlaySettings settings;
    settings.wall.method = wall_of(given);
    settings.wall.law = law_of(given);
    settings.wall.lever = machine.lever;
    settings.wall.finger = machine.finger;
    settings.edges.force_per_speed = number_value(given, "--edges", 100 * settings.edges.force_per_speed, 0, 5) / 100;
    settings.safety.most_force = machine.lever.most_force;
    if (!charts.stable.empty()) write_chart_files(stable_plot(settings.wall.law, machine.lever, any_finger()), charts.stable);
    if (given.words.empty()) return 0;
    check_law(settings.wall.law, machine.lever);
    return play(given, machine, settings, charts);
}

}  // namespace

extern const Command play_command;
const Command play_command{
    .name = "play",
    .summary = "play a height map on a haptic mouse, real or simulated",
    .words = "[MAP] [--device DEVICE]",
    .details =
        "The mouse lifts a finger as it is moved over the map: a height map of convert or relief, or any grey picture with --pitch, --low and --high. "
        "A thousand times a second it is told a force: that of a surface that gives way by --stiffness, within 8 N, begun softly, never faster "
        "than 8 N in 2 ms, and none where anything is not a number, the mouse is silent for 3 ms or the stop key is pressed.\n\n"
        "Stiffness and damping that would make the machine tremble are refused before it is switched on, with the nearest that do not. A real mouse is taken to feel a force 1.5 ms late, if its file (--lever) does not tell its delay. Without a "
        "machine everything runs with a simulated lever, finger and hand, or with the ways of a recorded hand, as quickly as the processor can.\n\n"
        "What a mouse must send and take is in tactics/haptics/mouse_report.h; anyone can build one.",
    .example =
        "tactics play relief.png --csv ticks.csv --plot way.svg\n"
        "tactics play terrain.png --pitch 0.5mm --low 0mm --high 20mm --device recorded:hand.csv --wall steps\n"
        "tactics play relief.png --device sensed --fusion paper --speed 250 --track figure9.svg\n"
        "tactics play --stable region.svg --lever heavy\n"
        "tactics play relief.png --device hid: --radius 4mm",
    .flags = kFlags,
    .offers = "files",
    .run = run,
};

}  // namespace tactics
