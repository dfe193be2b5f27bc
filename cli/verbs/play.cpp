// SPDX-License-Identifier: Apache-2.0
// `tactics play`: a relief on a haptic mouse.
#include <algorithm>
#include <cmath>
#include <optional>

#include "cli/command.h"
#include "cli/page_flags.h"
#include "cli/report/report.h"
#include "cli/report/say.h"
#include "cli/table_flags.h"
#include "cli/verbs/play_arm.h"
#include "cli/verbs/play_plan.h"
#include "cli/verbs/play_report.h"
#include "cli/verbs/play_scene.h"
#include "tactics/error.h"
#include "tactics/haptics/scenes/stability.h"
#include "tactics/units.h"

namespace tactics {

namespace {

constexpr Flag kPlayFlags[] = {
    {"--device", "-d", "DEVICE",
     "the mouse: simulated, sensed (simulated, finding its place by imperfect sensors), recorded:FILE.csv (time_s,x_mm,y_mm per "
     "line; a first line may name the columns, including finger_mm, the finger's own height), hid: or hid:/dev/hidraw0; or an "
     "arm: arm, a simulated one, or one of tactics help arms. Default: simulated",
     false, ""},
    {"--pitch", "", "LENGTH", "distance from sample to sample, for a map that does not give it", false, ""},
    {"--width", "", "LENGTH", "width of the map from its left edge to its right, instead of --pitch; also of a model on an arm",
     false, ""},
    {"--low", "", "LENGTH", "height of black, for a map that does not give it", false, ""},
    {"--high", "", "LENGTH",
     "height of white, for a map that does not give it; or height of the lines of a drawing, by default "
     "0.5 mm",
     false, ""},
    kRecipeFlag,
    kFilterFlag,
    {"--set", "-s", "NAME.OPTION=VALUE", "change a setting in every step of a filter. May be given several times", true,
     "settings"},
    kDetailFlag,
    kPdfPageFlag,
    kAllowFlag,
    {"--radius", "", "LENGTH",
     "radius of the fingertip, which does not enter narrower pits. Default: 0, and 2 mm for a map on an arm, where a point "
     "would catch at the side of each line",
     false, ""},
    {"--best", "", "",
     "resample, smooth and compress heights so that the machine loses the least of them, and report what was done (tactics help "
     "measure)",
     false, ""},
    {"--wall", "", "METHOD",
     "how to treat jumps in height: look-ahead, raw, steps (the paper's), rate-limit, governor or slope; default: look-ahead",
     false, "raw steps rate-limit governor look-ahead slope"},
    {"--stiffness", "", "NUMBER", "stiffness of the surface, N/mm; default: 1, or what the machine can hold stably", false, ""},
    {"--damping", "", "NUMBER", "damping of the surface, N s/m; default: 1, or more if the machine needs it", false, ""},
    {"--damping-sign", "", "corrected|as_printed",
     "as_printed uses the sign in the paper's equation 1, which removes damping; it is refused where the machine would tremble",
     false, "corrected as_printed"},
    {"--edges", "", "NUMBER", "strength of the short vibration felt at edges, N at 100 mm/s; 0 for none, default: 0.5", false,
     ""},
    {"--lever", "", "light|heavy|FILE",
     "the machine: light (30 g), heavy (100 g), or a file that describes its lever, finger and sensors; default: light", false,
     "light heavy files"},
    {"--finger", "", "soft|nominal|stiff|none",
     "the finger to simulate and to stay stable with; none is a simulated lever that nobody touches. Default: that of the file, "
     "else nominal, or soft on a real mouse",
     false, "soft nominal stiff none"},
    {"--arm", "", "omni|desktop|phantom|FILE",
     "the machine that pushes a fingertip in space: its workspace, resolution, force and stiffness; default: omni", false,
     "omni desktop phantom files"},
    {"--plane", "", "upright|flat|A,B,C,D",
     "where a plot, a map or a model stands in an arm's workspace: on a wall in front of the person (upright), on a table "
     "(flat), or on the plane Ax + By + Cz + D = 0 (x to the right, y upwards, z towards the person, mm). Default: plots "
     "upright, surfaces and models flat, and height maps whichever way is larger, flat if equal",
     false, "upright flat"},
#include "cli/table_flags.inc"
    {"--feel", "", "PART,PART...",
     "feel only these parts of a plot on an arm: wall, axes, grid, curves, points, surface; default: all", false,
     "wall axes grid curves points surface"},
    {"--levels", "", "NUMBER|auto",
     "feel lines of equal height instead of a surface, a height map or a model on an arm: at most this many, 3 to 20, at round "
     "heights; auto: as many as a finger can tell apart, 3 to 8",
     false, "auto"},
    {"--section", "", "y=2,5,8|x=...",
     "feel the same things cut open instead: curves of their height along lines across them, at most five", false, ""},
    {"--fixture", "", "r2|r1|linear|rod",
     "how a curve attracts a finger: by one of two reconstructions of the paper's weighting function, whose formula is lost "
     "(r2, r1), linearly (linear), or not at all, as a thin solid rod (rod); default: r2",
     false, "r2 r1 linear rod"},
    {"--speak", "", "VOICE",
     "speak when a key of an arm is pressed, and say where the finger was led (tactics help arms lists the keys). auto takes "
     "speech-dispatcher or espeak-ng, whichever is there; or speechd, espeak-ng, tcp:HOST:PORT (a text server), recording:FILE "
     "(one line per utterance)",
     false, "auto speechd espeak-ng"},
    {"--language", "", "TAG", "language of --speak, such as de; default: en", false, ""},
    {"--tones", "", "alsa|FILE.wav",
     "play the height of the curve under the finger as a tone, on the loudspeaker or into a file; its stereo position follows "
     "the finger",
     false, "alsa files"},
    {"--hand", "", "to-and-fro|trace|points|sections|led",
     "what the hand on a simulated arm does: it moves through the middle, from side to side (to-and-fro); finds a curve, "
     "follows it to its end and stops at a tick (trace); notes where points are (points), or how high a surface is along two "
     "lines (sections); or lets itself be led (led). Default: to-and-fro",
     false, "to-and-fro trace points sections led"},
    {"--guide", "", "KEY,KEY...",
     "the keys that a simulated hand presses in turn, after each of which it lets itself be led: start, follow, extremum, "
     "compare, or another name in tactics help arms",
     false, "start follow extremum compare"},
    {"--fusion", "", "learning|paper", "how data from the overlay and the optical sensors are combined", false, "learning paper"},
    {"--learned", "", "FILE",
     "a file for what was learned about the mouse's sensors and overlay: it is read if it exists, and written at the end, so "
     "that the next play knows it from the first stroke; - for none. Default for a real mouse: a file in ~/.local/state/tactics",
     false, "files"},
    {"--speed", "", "NUMBER", "speed of a simulated hand, mm/s; default: 50", false, ""},
    {"--seconds", "", "NUMBER",
     "how long to play; default: 10, a recorded path to its end, a real mouse until its stop key or Ctrl-C", false, ""},
    {"--rate", "", "NUMBER", "ticks per second; default: 1000", false, ""},
    {"--real-time", "", "", "run in real time with the simulated mouse, too, and ahead of all other programs if permitted", false,
     ""},
    {"--overlay", "", "FILE",
     "the touch overlay that sees the finger on a real mouse: its device, such as /dev/input/event5, or auto for the only one "
     "attached; during the play only tactics reads it, so it moves no pointer",
     false, "files"},
    {"--overlay-size", "", "WIDTHxHEIGHT",
     "size of the field that the overlay sees, such as 600x340mm, if it does not report "
     "that",
     false, ""},
    {"--map-at", "", "X,Y",
     "where the map's upper left corner lies on the overlay, to the right and down, such as 50mm,30mm; default: the overlay's "
     "own corner",
     false, ""},
    {"--csv", "", "FILE",
     "write every tick to this file: time, place, heights, force; until the play ends it is called "
     "FILE.part",
     false, "files"},
    {"--plot", "", "FILE",
     "draw the fingertip's path, and the profile of the surface where the two can be told apart, as a page: .svg, .png, .pdf. "
     "Of a simulated hand, which goes to and fro, only the first pass is drawn. May be given several times",
     true, "files"},
    {"--view", "", "both|front|above",
     "views in which --plot draws the path on an arm: from the front, from above, or each on its own page (both); a format of "
     "one page writes way.svg and way-2.svg. Default: both",
     false, "both front above"},
    {"--part", "", "FROM,TO",
     "let --plot draw only this stretch of the path, from one place on the map to another, and thus larger, such as 70mm,80mm",
     false, ""},
    {"--track", "", "FILE",
     "draw over time where the fingertip of a sensed mouse was, and where the mouse assumed it, on the last pass", true, "files"},
    {"--stable", "", "FILE", "draw which stiffness and damping this machine can hold stably; needs no MAP", true, "files"},
    {"--paper", "-p", "PAPER", "paper of --plot, --track and --stable", false, "papers"},
    {"--medium", "-m", "MEDIUM", "what these pages are made on", false, "media"},
    kMarginFlag,
    kOrientationFlag,
    {"--title", "", "TEXT", "title of them", false, ""},
    kBrailleFlag,
    {"--dpi", "", "NUMBER", "dots per inch of these pages as .png and .tif", false, ""},
    {"--quiet", "-q", "", "say nothing but errors", false, ""},
    {"--json", "", "", "write the figures to standard output, as a JSON object", false, ""},
};

std::vector<FingerSettings> any_finger() {
    std::vector<FingerSettings> fingers;
    for (const NamedFinger& one : kFingers) fingers.push_back(one.finger);
    return fingers;
}

// A surface that the machine would make tremble is refused before it is switched on.
void refuse_unstable(const ForceLaw& law, const StableCheck& check) {
    if (check.stable) return;
    throw Error(
        Fault::usage, law.sign == DampingSign::as_printed ? "--damping-sign" : "--stiffness",
        check.stiffness == 0 ? check.reason
        : law.sign == DampingSign::as_printed
            ? phrase("{0}; with a tenth to spare this comes to rest: --stiffness {1} --damping {2} --damping-sign corrected",
                     check.reason, to_text(check.stiffness), to_text(std::round(check.damping_ns_per_m * 100) / 100))
            : phrase("{0}; with a tenth to spare this comes to rest: --stiffness {1} --damping {2}", check.reason,
                     to_text(check.stiffness), to_text(std::round(check.damping_ns_per_m * 100) / 100)));
}

// The default is the largest stable value. `law` is unchanged if the user named an unstable one.
void take_what_is_borne(ForceLaw& law, StableCheck& check, const Given& given) {
    const bool fits = check.stiffness > 0 && (check.stiffness == law.stiffness || !given.has("--stiffness"));
    if (check.stable || !fits || given.has("--damping") || law.sign == DampingSign::as_printed) return;
    if (!given.has("--quiet"))
        say(phrase("{0}; it is played with {1} N/mm and {2} N s/m", check.reason, numeral(check.stiffness),
                   numeral(check.damping_ns_per_m)));
    law = {check.stiffness, check.damping_ns_per_m, law.sign};
    check.stable = true;
}

HeightMap map_of(const PlayPlan& plan, bool quiet) {
    Source source = open_source(plan.map);
    source.allowed = plan.wish.drawing.allowed;
    FeltHeights felt = felt_map(std::move(source), plan.map, plan.wish, quiet);
    const double radius = plan.wish.radius.value_or(0);
    return radius > 0 ? dilated(felt.file.map, radius) : std::move(felt.file.map);
}

// Notes on a map before it is felt. Throws Error(usage) if nothing of it can be felt.
void check_map(const PlayPlan& plan, const ReliefSurface& surface, bool quiet) {
    const LeverSettings& lever = plan.machine.lever;
    if (!quiet && (surface.lowest() < lever.lowest || surface.highest() > lever.highest))
        say(phrase(
            "{0}: it goes from {1} to {2} mm, and the lever from {3} to {4}; give it other heights with --low and --high, or the "
            "lever another way with --lever",
            plan.map, numeral(surface.lowest()), numeral(surface.highest()), numeral(lever.lowest), numeral(lever.highest)));
    const double longest = std::max(surface.map().width(), surface.map().height());
    if (plan.part && (plan.part->x >= longest || plan.part->y <= 0))
        throw Error(Fault::usage, "--part", phrase("the map has nothing there; it ends at {0} mm", numeral(longest)));
}

int play_map(const PlayPlan& plan, bool by_wall, bool quiet, bool json) {
    const ReliefSurface surface(map_of(plan, quiet));
    check_map(plan, surface, quiet);
    const std::unique_ptr<HapticDevice> device =
        open_mouse(plan.device, {{}, plan.machine, &surface, 1, plan.speed, plan.seconds.value_or(0)}, plan.overlay);
    const MouseGeometry geometry = geometry_of(plan.machine.sensors);
    // Those that know their place need none.
    const DeviceKind& kind = kind_of_device(plan.device);
    std::unique_ptr<Fusion> fusion;
    if (kind.finds_place)
        fusion = plan.paper_fusion ? paper_fusion(geometry)
                                   : learning_fusion(geometry, learned_before(plan.learned, plan.own_learned, quiet));
    SceneWish wish{plan.device, plan.settings, plan.seconds, by_wall, plan.csv, {}, plan.feel.wall.law};
    wish.columns.truth = kind.knows_truth;
    wish.settings.begin = {kind.knows_truth ? 0 : surface.map().width() / 2, surface.map().height() / 2};
    if (device->is_real() && !plan.overlay && !quiet)
        say(phrase("{0}: the finger begins in the middle of the map, as no overlay tells where it is", plan.device));
    ReliefScene scene(surface, plan.feel);
    const PlayedScene played = play_scene(scene, *device, fusion.get(), std::move(wish));
    tell_figures(played, quiet, json);
    if (!plan.way.empty()) write_chart_files(way_plot(played.records, surface, plan.part, kind.has_hand), plan.way);
    if (!plan.track.empty()) write_chart_files(track_plot(played.records), plan.track);
    if (fusion) keep_learned(plan.learned, plan.own_learned, *fusion, quiet);
    if (played.unlogged) throw *played.unlogged;
    return 0;
}

int run_play(const Given& given) {
    const int axes = kind_of_device(given.value("--device", std::string(device_kinds().front()->name))).axes;
    if (axes == 3 || (axes == 0 && given.has("--arm"))) return play_on_arm(given);
    for (const std::string_view flag : arm_flags())
        if (given.has(flag)) throw Error(Fault::usage, flag, phrase("it is about an arm; leave it out, or take --device arm"));
    PlayPlan plan = plan_play(given);
    ForceLaw& law = plan.feel.wall.law;
    const std::vector<FingerSettings> fingers = any_finger();
    StableCheck check = check_stable(law, plan.machine.lever, fingers);
    take_what_is_borne(law, check, given);
    if (!plan.stable.empty()) {
        const StableFigures stable = stable_figures(law, plan.machine.lever, fingers, check.stable);
        write_chart_files(stable_plot(stable), plan.stable);
        if (plan.map.empty() && given.has("--json")) print_out(stable_json(stable) + "\n");
    }
    if (plan.map.empty()) return 0;
    refuse_unstable(law, check);
    return play_map(plan, given.has("--real-time"), given.has("--quiet"), given.has("--json"));
}

}  // namespace

extern const Command play_command;
const Command play_command{
    .name = "play",
    .summary = "let a finger feel data, a picture, a height map or a model on a haptic mouse or arm, real or simulated",
    .words = "[MAP] [--device DEVICE]",
    .details =
        "The mouse lifts a finger as it moves over the map. MAP may be a height map from convert or relief, a model (VRML, X3D, "
        "STL, OBJ, PLY, glTF, COLLADA) or a table of heights over x and y; these are played as they are. It may also be a "
        "photograph, a figure (SVG, PDF) or another table; these are first drawn as convert draws them, with raised lines. A "
        "picture with --pitch, --width, --low or --high and without --recipe is played by its lightness.\n\n"
        "A thousand times a second, tactics sends the mouse a force: that of a surface that gives way by --stiffness. The force "
        "stays within 8 N, begins softly and changes no faster than 8 N in 2 ms. It is zero if any value is not a number, if "
        "the mouse is silent for 3 ms or when the stop key is pressed.\n\n"
        "Stiffness and damping that would make the machine tremble, with any finger on it or with none, are refused before it "
        "is switched on, and the nearest stable values are named; the machine's friction is not relied on. A real mouse is "
        "assumed to apply a force 1.5 ms late, unless its file (--lever) gives its delay. Without a machine, everything runs "
        "with a simulated lever, finger and hand, or with the path of a recorded hand, as fast as the processor allows.\n\n"
        "On an arm, a table of data is felt in space as its plot (--feel), on a wall or on a table; a height map or a picture "
        "as a relief, with the same options as on a mouse; and a model as a solid, from all sides, as large as the workspace "
        "holds. Anything larger is scaled down, and tactics says so. To feel a model as a map, make the map first (tactics "
        "relief).\n\n"
        "tactics help mouse describes what a mouse must send and receive, and the file for --lever; anyone can build one.",
    .example =
        "tactics play photo.jpg\n"
        "tactics play relief.png --csv ticks.csv --plot way.svg\n"
        "tactics play terrain.png --pitch 0.5mm --low 0mm --high 20mm --device recorded:hand.csv --wall steps\n"
        "tactics play relief.png --device sensed --fusion paper --speed 250 --track figure9.svg\n"
        "tactics play --stable region.svg --lever heavy\n"
        "tactics play chair.glb --device arm --hand sections --plot way.pdf\n"
        "tactics play terrain.csv --z height --device arm --levels auto\n"
        "tactics play relief.png --device hid: --radius 4mm\n"
        "tactics play data.csv --device arm --guide start,follow --speak auto --tones way.wav",
    .flags = kPlayFlags,
    .offers = "files",
    .run = run_play,
};

}  // namespace tactics
