// SPDX-License-Identifier: Apache-2.0
// `tactics measure`: how much of a file a medium carries.
#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/command.h"
#include "cli/page_flags.h"
#include "cli/report/say.h"
#include "cli/request.h"
#include "cli/table_flags.h"
#include "cli/verbs/measure_report.h"
#include "cli/verbs/play_map.h"
#include "cli/verbs/stream_report.h"
#include "cli/verbs/ticks_in.h"
#include "cli/verbs/voxel_report.h"
#include "tactics/error.h"
#include "tactics/information/media.h"
#include "tactics/job/disk.h"
#include "tactics/medium.h"

namespace tactics {

namespace {

constexpr Flag kMeasureFlags[] = {
    {"--media", "", "all|NAME,NAME...",
     "say what each of these carries: media, embossers, displays and height formats from tactics list, or mouse, omni, desktop, "
     "phantom",
     false, "all media embossers displays"},
    {"--paper", "-p", "PAPER", "paper of the media that use paper; default: a4, or what an embosser is made for", false,
     "papers"},
    {"--best", "", "",
     "for each of --media, look for the size, the smoothing and the compression of heights with which it loses least", false, ""},
    {"--levels-of-detail", "", "", "say how much is left with half as many cells each way, a quarter, and so on", false, ""},
    {"--pitch", "", "LENGTH", "distance from cell to cell, for a file that does not give it", false, ""},
    {"--width", "", "LENGTH", "instead of --pitch, the width from the left edge to the right", false, ""},
    {"--low", "", "LENGTH", "height of black, for a file that does not give it", false, ""},
    {"--high", "", "LENGTH", "height of white, for a file that does not give it", false, ""},
    kRecipeFlag,
    kFilterFlag,
    {"--set", "-s", "NAME.OPTION=VALUE", "change a setting in every step of a filter. May be given several times", true,
     "settings"},
    kDetailFlag,
    kPdfPageFlag,
    kAllowFlag,
#include "cli/table_flags.inc"
#include "cli/table_flags_of_bars.inc"
    {"--quiet", "-q", "", "no notes about values assumed where the file gives none", false, ""},
    {"--json", "", "", "one JSON object on standard output", false, ""},
};

std::vector<DetailLevel> levels_of_detail(MeasuredScene& scene) {
    const LevelGrid& whole = scene.pyramid.whole();
    std::vector<DetailLevel> levels;
    for (int longest = std::max(whole.columns, whole.rows);; longest /= 2) {
        const LevelGrid& there = scene.pyramid.at(longest);
        DetailLevel level{there.columns, there.rows, scene.pyramid.bits(longest, whole.levels)};
        level.bits = std::min(level.bits, levels.empty() ? level.bits : levels.back().bits);
        level.mutual = joint_entropy(whole, enlarged(there, whole.columns, whole.rows)).mutual();
        if (!scene.is_drawn()) level.error = scene.pyramid.error(longest, whole.levels) * scene.step();
        levels.push_back(level);
        if (longest < 16) return levels;
    }
}

// The requested media that push back. Throws Error(usage) if none does.
std::vector<StreamMedium> media_of(const Recording& recording, const MeasuredStream& stream,
                                   const std::vector<MediumChannel>& channels) {
    std::vector<StreamMedium> media;
    for (const MediumChannel& channel : channels)
        if (channel.most_force > 0) media.push_back({channel, carried_by(recording, stream, channel)});
    if (media.empty() && !channels.empty())
        throw Error(Fault::usage, "--media",
                    phrase("a recording is of forces, which only mouse, omni, desktop and phantom have"));
    return media;
}

int measure_stream(const Given& given, const std::string& name, const TickTable& ticks,
                   const std::vector<MediumChannel>& channels) {
    for (const std::string_view flag : {"--best", "--levels-of-detail", "--pitch", "--width", "--low", "--high"})
        if (given.has(flag))
            throw Error(Fault::usage, flag, phrase("it is about heights and drawings, and {0} is a recording", name));
    StreamReport report{name, measured(ticks.recording, name), {}, ticks.notes};
    report.media = media_of(ticks.recording, report.stream, channels);
    if (!given.has("--quiet") && !given.has("--json"))
        for (const Phrase& note : report.notes) say(phrase("{0}: {1}", name, note));
    print_out(given.has("--json") ? json_of(report) : text_of(report));
    return 0;
}

int measure_voxels(const Given& given, const std::string& name, Source& source) {
    for (const std::string_view flag : {"--media", "--best", "--pitch", "--width", "--low", "--high"})
        if (given.has(flag))
            throw Error(Fault::usage, flag, phrase("it is about heights and drawings, and {0} is voxels; leave it out", name));
    const VoxelReport report = voxel_report(name, read_nrrd(source), given.has("--levels-of-detail"));
    if (!given.has("--quiet") && !given.has("--json"))
        for (const Phrase& note : report.notes) say(phrase("{0}: {1}", name, note));
    print_out(given.has("--json") ? json_of(report) : text_of(report));
    return 0;
}

int run_measure(const Given& given) {
    if (given.words.size() != 1)
        throw Error(Fault::usage, "measure",
                    phrase("name one file, or - for standard input; for example: tactics measure photo.jpg --media all"));
    if (given.has("--best") && !given.has("--media"))
        throw Error(Fault::usage, "--best", phrase("it is about media; name some with --media, or all"));
    std::optional<Paper> paper;
    if (given.has("--paper")) paper = find_paper(given.value("--paper"), "--paper");
    std::vector<MediumChannel> channels;
    if (given.has("--media")) channels = named_channels(given.value("--media"), paper, "--media");
    const MapWish wish = map_wish(given, real_disk());
    const std::string name = given.words[0] == "-" ? "standard input" : given.words[0];
    Source source = open_source(given.words[0]);
    source.allowed = wish.drawing.allowed;
    if (is_nrrd(source)) return measure_voxels(given, name, source);
    if (!asks_for_a_way(wish.drawing.chain))
        if (const auto ticks = ticks_in(source)) return measure_stream(given, name, *ticks, channels);
    MeasureReport report{name, scene_of_file(std::move(source), given.words[0], wish.heights, wish.drawing), {}, {}};
    MeasuredScene& scene = report.found.scene;
    for (const MediumChannel& channel : channels) {
        MeasuredMedium medium{channel, carried_by(scene, channel), {}};
        if (given.has("--best")) {
            const auto known = std::find_if(report.media.begin(), report.media.end(),
                                            [&](const MeasuredMedium& other) { return other.channel.holds_the_same(channel); });
            medium.least = known != report.media.end() ? known->least : least_loss(scene, channel);
        }
        report.media.push_back(std::move(medium));
    }
    if (given.has("--levels-of-detail")) report.levels = levels_of_detail(scene);
    if (!given.has("--quiet") && !given.has("--json"))
        for (const Phrase& note : report.found.notes) say(phrase("{0}: {1}", name, note));
    print_out(given.has("--json") ? json_of(report) : text_of(report));
    return 0;
}

}  // namespace

extern const Command measure_command;
const Command measure_command{
    .name = "measure",
    .summary = "measure how much information a file holds, and how much of it each medium carries",
    .words = "FILE [--media all|NAME,...]",
    .details =
        "FILE is anything that convert or play reads. A height map, a model or a table of heights is measured by its heights; a "
        "picture by its lightness, black low and white high, or, with --recipe, --filter or --detail, by the drawing made from "
        "it; figures, pages and other tables are drawn first. A recording (.felt, or the table of play --csv) is measured by "
        "its forces, of which arms and the mouse carry what they can push. Voxels (NRRD, raw, ascii or gzip) are measured by "
        "their numbers, or as forces of three components each, between which the field is trilinear.\n\n"
        "The amount cannot be known exactly, so an interval is given. Several codes predict each cell from those before it. The "
        "interval begins at the least that one of them finds and ends at what the shortest code needs, with the cost of learning "
        "it; both ends leave room for chance. It holds the entropy where each cell is a matter of chance and of a few cells next "
        "to it; a file that was made by another rule may hold less. Of large pictures some rows are counted, and the interval is "
        "wider. The bits of the levels alone ignore where each level is; the topology index is 1 - code / levels alone: near 1 "
        "where neighbours determine "
        "everything, 0 or a little below where they determine nothing, as in noise.\n\n"
        "A medium is described by its workspace, the distance between its places, and its heights. The scene is laid out as "
        "large as the medium holds; details smaller than one place or level are merged. Bits carried are C = min(capacity, what "
        "is left, all), ratio is C / H and loss max(H - C, 0) / H, with H the bits of the shortest code (K. Moustakas, Handling "
        "haptics as a stand-alone medium, "
        "2013). A finer medium never counts as a poorer one. How far apart two lines must be for a finger to feel them as two "
        "is stated in words.",
    .example =
        "tactics measure relief.png --media all\n"
        "tactics measure plan.svg --media swell,index-v4,graphiti\n"
        "tactics measure photo.jpg --recipe photo --media all --json\n"
        "tactics measure ticks.felt --media omni,desktop\n"
        "tactics measure terrain.tif --media omni,desktop --best --levels-of-detail",
    .flags = kMeasureFlags,
    .offers = "files",
    .run = run_measure,
};

}  // namespace tactics
