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

constexpr Flag kFlags[] = {
    {"--device", "-d", "DEVICE",
     "the mouse: simulated, sensed (simulated, and it has to find its place by sensors that are wrong), recorded:FILE.csv "
     "(time_s,x_mm,y_mm a line; a first line may name the columns, and finger_mm, the finger's own height, among them), hid: or "
     "hid:/dev/hidraw0; or an arm: arm, a simulated one, or one of tactics help arms; simulated if none is named",
     false, ""},
    {"--pitch", "", "LENGTH", "from sample to sample, for a map that does not tell it", false, ""},
    {"--width", "", "LENGTH", "of the map from its left edge to its right, instead of --pitch; of a model on an arm, too", false,
     ""},
    {"--low", "", "LENGTH", "height of black, for a map that does not tell it", false, ""},
    {"--high", "", "LENGTH", "height of white, for a map that does not tell it; of the lines of what is drawn, 0.5 mm", false,
     ""},
    kRecipeFlag,
    kFilterFlag,
    {"--set", "-s", "NAME.OPTION=VALUE", "change a setting in every step of that filter. May be given several times", true,
     "settings"},
    kDetailFlag,
    kPdfPageFlag,
    kAllowFlag,
    {"--radius", "", "LENGTH",
     "radius of the fingertip, which reaches no pit that is narrower; if none is named 0, and 2 mm of a map on an arm, where a "
     "point would be caught at the side of each line",
     false, ""},
    {"--best", "", "",
     "of heights: resample, smooth and compress them so that the machine loses least of them, and tell what was done (tactics "
     "help measure)",
     false, ""},
    {"--wall", "", "METHOD",
     "what is done where the height jumps: look-ahead if none is named; raw, steps (the paper's), rate-limit, governor, slope",
     false, "raw steps rate-limit governor look-ahead slope"},
    {"--stiffness", "", "NUMBER", "of the surface, N/mm; if none is named 1, or what the machine bears", false, ""},
    {"--damping", "", "NUMBER", "of the surface, N s/m; if none is named 1, or more where the machine needs it", false, ""},
    {"--damping-sign", "", "corrected|as_printed",
     "as_printed has the sign of the paper's equation 1, which takes damping away: it is refused where the machine would tremble",
     false, "corrected as_printed"},
    {"--edges", "", "NUMBER",
     "strength of the short swing that is felt at edges, N at 100 mm/s; 0.5 if none is named, 0 for none", false, ""},
    {"--lever", "", "light|heavy|FILE",
     "the machine: 30 g, 100 g, or a file of the numbers of its lever, finger and sensors; light if none is named", false,
     "light heavy files"},
    {"--finger", "", "soft|nominal|stiff|none",
     "the finger that is reckoned with, and simulated; if none is named that of the file, or nominal, or soft on a real mouse. "
     "none: a simulated lever that nobody touches",
     false, "soft nominal stiff none"},
    {"--arm", "", "omni|desktop|phantom|FILE",
     "the machine that pushes a fingertip in space: its workspace, resolution, force and stiffness; omni if none is named", false,
     "omni desktop phantom files"},
    {"--plane", "", "upright|flat|A,B,C,D",
     "where in an arm's workspace a plot or a map is, or a model stands: on a wall before the person, on a table, or on the "
     "plane Ax + By + Cz + D = 0 (x to "
     "the right, y upwards, z towards the person, mm); if none is named upright, surfaces and models flat, and maps of heights "
     "flat, or upright if they are larger so",
     false, "upright flat"},
#include "cli/table_flags.inc"
    {"--feel", "", "PART,PART...",
     "of a plot on an arm only these: wall, axes, grid, curves, points, surface; all if none is named", false,
     "wall axes grid curves points surface"},
    {"--levels", "", "NUMBER|auto",
     "of a surface, a map of heights or a model on an arm, feel lines of equal height instead: so many at most, 3 to 20, at "
     "round heights; auto: as many as a "
     "finger tells, 3 to 8",
     false, "auto"},
    {"--section", "", "y=2,5,8|x=...",
     "of the same, feel it cut open instead: curves of its height along lines across it, at most five", false, ""},
    {"--fixture", "", "r2|r1|linear|rod",
     "how a curve draws a finger to it: by one of two reconstructions of the paper's weighting function, whose formula is lost "
     "(r2, r1), in straight lines, or not at all, as a thin solid rod; r2 if none is named",
     false, "r2 r1 linear rod"},
    {"--speak", "", "VOICE",
     "speak when a key of an arm is pressed, and where the finger was led (tactics help arms has the keys). auto takes "
     "speech-dispatcher or espeak-ng, whichever is there; or speechd, espeak-ng, tcp:HOST:PORT (a text server), recording:FILE "
     "(each utterance a line)",
     false, "auto speechd espeak-ng"},
    {"--language", "", "TAG", "of --speak, such as de; en if none is named", false, ""},
    {"--tones", "", "alsa|FILE.wav",
     "the height of the curve under the finger as a tone, through the loudspeaker or into a file; its side is where the finger "
     "is",
     false, "alsa files"},
    {"--hand", "", "to-and-fro|trace|points|sections|led",
     "what the hand in a simulated arm does: through the middle, from side to side; or finds a curve, follows it to its end and "
     "stops at a tick; or takes down where points are, or how high a surface is along two lines; or lets itself be led; "
     "to-and-fro if none is named",
     false, "to-and-fro trace points sections led"},
    {"--guide", "", "KEY,KEY...",
     "the keys that a simulated hand presses, one after the other, and then lets itself be led: start, follow, extremum, "
     "compare, "
     "or another name in tactics help arms",
     false, "start follow extremum compare"},
    {"--fusion", "", "learning|paper", "how overlay and optical sensors are put together", false, "learning paper"},
    {"--learned", "", "FILE",
     "what was learned of the mouse's sensors and overlay: read if it is there, and written at the end, so that the next play "
     "knows it from its first stroke; of a real mouse kept in ~/.local/state/tactics if none is named; - for none",
     false, "files"},
    {"--speed", "", "NUMBER", "of a simulated hand, mm/s; 50 if none is named", false, ""},
    {"--seconds", "", "NUMBER",
     "how long; 10 if none is named, a recorded way to its end, a real mouse until its stop key or Ctrl-C", false, ""},
    {"--rate", "", "NUMBER", "ticks a second; 1000 if none is named", false, ""},
    {"--real-time", "", "",
     "by the clock on the wall for the simulated mouse, too, and before all other programs if that is permitted", false, ""},
    {"--overlay", "", "FILE",
     "the touch overlay that sees the finger on a real mouse: its device, such as /dev/input/event5, or auto for the only one "
     "that is there; during the play it belongs to the play alone, and moves no pointer",
     false, "files"},
    {"--overlay-size", "", "WIDTHxHEIGHT", "of the field that the overlay sees, such as 600x340mm, if it does not tell that",
     false, ""},
    {"--map-at", "", "X,Y",
     "where on the overlay the upper left corner of the map is, to the right and down, such as 50mm,30mm; its own corner if none "
     "is named",
     false, ""},
    {"--csv", "", "FILE", "write every tick: time, place, heights, force; until the end it is called FILE.part", false, "files"},
    {"--plot", "", "FILE",
     "draw the way of the fingertip, and the profile where the two can be told apart, as a page: .svg, .png, .pdf; of a "
     "simulated hand, which goes to and fro, the first way. May be given several times",
     true, "files"},
    {"--view", "", "both|front|above",
     "of an arm, what --plot draws the way on: as it is seen from the front on one page and from above on another, in a format "
     "of one page way.svg and "
     "way-2.svg; or one of them; both if none is named",
     false, "both front above"},
    {"--part", "", "FROM,TO",
     "of the way that --plot draws: only from here to there on the map, and so larger, such as 70mm,80mm", false, ""},
    {"--track", "", "FILE",
     "draw where the fingertip of a sensed mouse was and where it took it to be, on the last way, over time", true, "files"},
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

std::vector<FingerSettings> any_finger() {
    std::vector<FingerSettings> fingers;
    for (const NamedFinger& one : kFingers) fingers.push_back(one.finger);
    return fingers;
}

// A surface that the machine would make tremble is refused before it is switched on.
void refuse_unstable(const ForceLaw& law, const StableCheck& check) {
    if (check.stable) return;
    throw Error(Fault::usage, law.sign == DampingSign::as_printed ? "--damping-sign" : "--stiffness",
                check.stiffness == 0
                    ? check.reason
                    : check.reason + "; with a tenth to spare this comes to rest: --stiffness " + to_text(check.stiffness) +
                          " --damping " + to_text(std::round(check.damping_ns_per_m * 100) / 100) +
                          (law.sign == DampingSign::as_printed ? " --damping-sign corrected" : ""));
}

// What nobody named is what the machine bears. `law` is left as it is where the user has named what it does not bear.
void take_what_is_borne(ForceLaw& law, StableCheck& check, const Given& given) {
    const bool fits = check.stiffness > 0 && (check.stiffness == law.stiffness || !given.has("--stiffness"));
    if (check.stable || !fits || given.has("--damping") || law.sign == DampingSign::as_printed) return;
    if (!given.has("--quiet"))
        say(check.reason + "; it is played with " + to_text(check.stiffness) + " N/mm and " + to_text(check.damping_ns_per_m) +
            " N s/m");
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

// What the user should know of a map before it is felt. Throws Error(usage) where nothing of it can be.
void check_map(const PlayPlan& plan, const ReliefSurface& surface, bool quiet) {
    const LeverSettings& lever = plan.machine.lever;
    if (!quiet && (surface.lowest() < lever.lowest || surface.highest() > lever.highest))
        say(plan.map + ": it goes from " + to_text(surface.lowest()) + " to " + to_text(surface.highest()) +
            " mm, and the lever from " + to_text(lever.lowest) + " to " + to_text(lever.highest) +
            "; give it other heights with --low and --high, or the lever another way with --lever");
    const double longest = std::max(surface.map().width(), surface.map().height());
    if (plan.part && (plan.part->x >= longest || plan.part->y <= 0))
        throw Error(Fault::usage, "--part", "the map has nothing there; it ends at " + to_text(longest) + " mm");
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
        say(plan.device + ": the finger begins in the middle of the map, as no overlay tells where it is");
    ReliefScene scene(surface, plan.feel);
    const PlayedScene played = play_scene(scene, *device, fusion.get(), std::move(wish));
    tell_figures(played, quiet, json);
    if (!plan.way.empty()) write_chart_files(way_plot(played.records, surface, plan.part, kind.has_hand), plan.way);
    if (!plan.track.empty()) write_chart_files(track_plot(played.records), plan.track);
    if (fusion) keep_learned(plan.learned, plan.own_learned, *fusion, quiet);
    if (played.unlogged) throw *played.unlogged;
    return 0;
}

int run(const Given& given) {
    const int axes = kind_of_device(given.value("--device", std::string(device_kinds().front()->name))).axes;
    if (axes == 3 || (axes == 0 && given.has("--arm"))) return play_on_arm(given);
    for (const std::string_view flag : arm_flags())
        if (given.has(flag)) throw Error(Fault::usage, flag, "it is about an arm; leave it out, or take --device arm");
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
    .summary = "play data, a picture, a height map or a model on a haptic mouse or arm, real or simulated",
    .words = "[MAP] [--device DEVICE]",
    .details =
        "The mouse lifts a finger as it is moved over the map. MAP is a height map of convert or relief, a model (VRML, X3D, "
        "STL, OBJ, PLY, glTF, COLLADA) or a table of heights over x and y, which are played as they are; or a photograph, a "
        "figure (SVG, PDF) or another table, which is drawn first as convert draws it, and its lines are raised. A picture with "
        "--pitch, --width, --low or --high and no --recipe is played by its lightness.\n\n"
        "A thousand times a second it is told a force: that of a surface that gives way by --stiffness, within 8 N, begun "
        "softly, never faster "
        "than 8 N in 2 ms, and none where anything is not a number, the mouse is silent for 3 ms or the stop key is pressed.\n\n"
        "Stiffness and damping that would make the machine tremble, with any finger or with none on it, are refused before it is "
        "switched on, with the nearest that do not; its friction is not counted on. A real mouse is taken to feel a force 1.5 ms "
        "late, if its file (--lever) does not tell its delay. Without a "
        "machine everything runs with a simulated lever, finger and hand, or with the ways of a recorded hand, as quickly as the "
        "processor can.\n\n"
        "On an arm a table is felt in space as its plot (--feel), on a wall or a table; a height map or a picture as a relief, "
        "by the same options as "
        "on a mouse; and a model as a solid, from all sides, as large as the workspace holds it. What is larger is felt smaller, "
        "and told. To feel a model as a map, make "
        "one first (tactics relief).\n\n"
        "What a mouse must send and take, and the file for --lever, is in tactics help mouse; anyone can build one.",
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
    .flags = kFlags,
    .offers = "files",
    .run = run,
};

}  // namespace tactics
