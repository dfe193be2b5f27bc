// SPDX-License-Identifier: Apache-2.0
// `tactics relief`: a picture of heights, a height map or a model as another file of heights.
#include <algorithm>
#include <cmath>
#include <optional>

#include "cli/command.h"
#include "cli/page_flags.h"
#include "cli/report/say.h"
#include "cli/request.h"
#include "cli/table_flags.h"
#include "print/format.h"
#include "tactics/error.h"
#include "tactics/information/media.h"
#include "tactics/job/disk.h"
#include "tactics/job/felt_heights.h"
#include "tactics/job/holds.h"
#include "tactics/job/surface_heights.h"
#include "tactics/job/table.h"
#include "tactics/relief/read_heights.h"
#include "tactics/text/json.h"
#include "tactics/text/rounded.h"
#include "tactics/transport/file.h"
#include "tactics/units.h"

namespace tactics {

namespace {

Phrase in_thousandths(double value) { return numeral(std::round(value / 0.001) * 0.001); }

constexpr Flag kReliefFlags[] = {
    {"--output", "-o", "OUT",
     "where to write; the ending chooses the format: .png (16 bits), .tif, .exr, .felt, .stl. May be given several times", true,
     "files"},
    {"--pitch", "", "LENGTH", "distance between two samples; default: the file's own", false, ""},
    {"--width", "", "LENGTH", "width of the picture or the model; for a picture, instead of --pitch. Default: the file's own",
     false, ""},
    {"--low", "", "LENGTH", "height of black, or of the lowest place of a model; default: the file's own, or 0", false, ""},
    {"--high", "", "LENGTH",
     "height of white, or of the highest place; default: the file's own, or for a picture 10 mm above "
     "the lowest",
     false, ""},
    {"--invert", "", "", "swap low and high: for a mould, or a drawing of black lines on white", false, ""},
    {"--samples", "", "16|decimal",
     "what a .tif holds: 16-bit whole numbers from black to white, or 32-bit numbers in mm; default: 16", false, "16 decimal"},
    {"--for", "", "MEDIUM",
     "resample, smooth and compress the heights so that this medium loses the least of them, and report what was done: a "
     "display, an embosser, mouse, omni, desktop or phantom, as for measure --media",
     false, "media embossers displays"},
    {"--base", "", "LENGTH", "thickness of an STL's plate below the lowest place; default: 2 mm", false, ""},
    kTableXFlag,
    kTableYFlag,
    kTableZFlag,
    kTableMatrixFlag,
    kTableDecimalFlag,
    kTableDatesFlag,
    kAllowFlag,
    {"--json", "", "", "one JSON object on standard output: size, pitch, heights, files", false, ""},
    {"--quiet", "-q", "", "nothing but errors", false, ""},
};

// Heights may be below zero.
std::optional<double> length_of(const Given& given, std::string_view name, bool positive) {
    if (!given.has(name)) return std::nullopt;
    const std::string text = given.value(name);
    const auto length = parse_length(text);
    if (!length || (positive && !(*length > 0)))
        throw Error(Fault::usage, name,
                    positive ? phrase("it cannot be \"{0}\"; it is a length such as 12mm or 0.5in, over 0", text.substr(0, 80))
                             : phrase("it cannot be \"{0}\"; it is a length such as 12mm or 0.5in", text.substr(0, 80)));
    return length;
}

constexpr std::string_view kReliefTableFlags[] = {"--x", "--y", "--z", "--matrix", "--decimal", "--dates"};

// The settings of formats that have options of their own here.
constexpr SourceWords kOfTif = "only a .tif can hold either; leave it out";
constexpr SourceWords kOfStl = "only an .stl has a plate; leave it out";
struct OwnFlag {
    std::string_view flag;
    SourceWords alone;
};
constexpr OwnFlag kSettings[] = {{"--samples", kOfTif}, {"--base", kOfStl}};

struct HeightOutput {
    std::string path;
    const Format* format = nullptr;
    Settings settings;
};

HeightOutput output_of(const std::string& path) {
    const Format* format = heights_format_of_path(path);
    if (format == nullptr)
        throw Error(
            Fault::usage, "--output",
            phrase("\"{0}\" must end in .png, .tif, .exr, .felt or .stl; write for example -o relief.png", path.substr(0, 80)));
    return {path, format, Settings(format->options)};
}

struct ReliefPlan {
    std::string input;
    std::vector<HeightOutput> outputs;
    HeightWish wish;
    std::optional<MediumChannel> medium = {};  // that is to lose least
};

ReliefPlan plan_relief(const Given& given) {
    if (given.words.size() != 1)
        throw Error(Fault::usage, "relief", phrase("name one picture, height map or model, or - for standard input"));
    if (!given.has("--output")) throw Error(Fault::usage, "relief", phrase("say where to write it: -o relief.png"));
    ReliefPlan plan{given.words[0],
                    {},
                    {length_of(given, "--pitch", true), length_of(given, "--width", true), length_of(given, "--low", false),
                     length_of(given, "--high", false), given.has("--invert")}};
    if (given.has("--for")) plan.medium = named_channel(given.value("--for"), "--for");
    const Disk disk = real_disk();
    for (const std::string& path : given.all("--output")) {
        plan.outputs.push_back(output_of(path));
        const auto same = [&](const std::string& other) { return disk.identity(path) == disk.identity(other); };
        if (plan.input != "-" && same(plan.input))
            throw Error(Fault::usage, "--output", phrase("{0} is the input; choose another name", path));
        for (std::size_t i = 0; i + 1 < plan.outputs.size(); ++i)
            if (same(plan.outputs[i].path))
                throw Error(Fault::usage, "--output", phrase("{0} is named twice; leave one out", path));
    }
    for (const auto& [flag, alone] : kSettings) {
        if (!given.has(flag)) continue;
        bool taken = false;
        for (HeightOutput& output : plan.outputs) {
            const std::string_view name = flag.substr(2);
            const auto& options = output.format->options;
            if (std::none_of(options.begin(), options.end(), [&](const Option& option) { return option.name == name; })) continue;
            output.settings.set(name, given.value(flag), flag, output.format->name);
            taken = true;
        }
        if (!taken) throw Error(Fault::usage, flag, phrase(alone));
    }
    return plan;
}

HeightFile heights_in(Source& source, const Given& given, const HeightWish& wish) {
    if (look_at(source) != Holds::table) {
        for (const std::string_view flag : kReliefTableFlags)
            if (given.has(flag))
                throw Error(Fault::usage, flag, phrase("it is about a table, and {0} is none; leave it out", source.name));
        return read_heights(source, wish);
    }
    std::vector<Phrase> notes;
    const auto surface = surface_in(source, table_wish(given), notes);
    if (!surface)
        throw Error(Fault::failed, source.name,
                    phrase("it has no heights over a grid of x and y; name the column of heights with --z, or take --matrix for "
                           "rows of heights; lines of a chart are raised by chart or convert, for example tactics convert "
                           "data.csv -o data.height.png"));
    HeightFile file = surface_heights(*surface, wish);
    file.notes.insert(file.notes.begin(), notes.begin(), notes.end());
    return file;
}

int run_relief(const Given& given) {
    const ReliefPlan plan = plan_relief(given);
    const std::string name = plan.input == "-" ? "standard input" : plan.input;
    Source source = open_source(plan.input);
    source.allowed = allowed_formats(given);
    HeightFile file = heights_in(source, given, plan.wish);
    if (plan.medium) fit_heights(file, *plan.medium, name);
    const HeightMap& map = file.map;
    const bool told = !given.has("--quiet") && !given.has("--json");
    for (const Phrase& note : file.notes)
        if (told) say(phrase("{0}: {1}", name, note));
    std::vector<std::string> written, paths;
    for (const HeightOutput& output : plan.outputs) {
        written.push_back(output.format->encode_heights(sheet_of(map, file.low, file.high), rows_of(map), output.settings));
        paths.push_back(output.path);
    }
    std::vector<NewFile> files;
    for (std::size_t i = 0; i < written.size(); ++i) files.push_back({paths[i], written[i]});
    write_files(files);
    const auto [least, most] = std::minmax_element(map.heights.begin(), map.heights.end());
    if (given.has("--json")) {
        JsonAnswer object;
        object.add("input", plan.input);
        object.add("format", file.format);
        object.add("columns", map.columns);
        object.add("rows", map.rows);
        object.add("pitch_mm", map.pitch);
        object.add("width_mm", map.width());
        object.add("height_mm", map.height());
        object.add("low_mm", file.low);
        object.add("high_mm", file.high);
        object.add("lowest_mm", static_cast<double>(*least));
        object.add("highest_mm", static_cast<double>(*most));
        object.add_raw("notes", json_text_array(file.notes));
        object.add_raw("outputs", json_text_array(paths));
        print_out(object.text() + "\n");
    }
    if (told)
        say(phrase(
            "{0}: {1} of {2} x {3} samples {4} mm apart, {5} x {6} mm; heights {7} to {8} mm, black is {9} and white {10} mm",
            name, format_in_words(file.format), std::to_string(map.columns), std::to_string(map.rows), numeral(map.pitch),
            in_thousandths(map.width()), in_thousandths(map.height()), in_thousandths(static_cast<double>(*least)),
            in_thousandths(static_cast<double>(*most)), in_thousandths(file.low), in_thousandths(file.high)));
    return 0;
}

}  // namespace

extern const Command relief_command;
const Command relief_command{
    .name = "relief",
    .summary = "make a height map or a solid from a picture, a height map, a model or a table of heights",
    .words = "INPUT -o OUT",
    .details =
        "INPUT is one of these: a picture, whose black is low and white is high, linear in the picture's own values; a height "
        "map that gives its pitch and heights (16-bit PNG or TIFF, floating-point TIFF or EXR, .felt, as convert and this "
        "command write them); a model (VRML, X3D, STL, OBJ, PLY, glTF, COLLADA), seen straight from above, z towards the eye; "
        "or a table of heights over x and y (--z, or rows of heights), whose surface is by default 150 mm wide, 10 mm high and "
        "sampled every 0.5 mm. Options supply what the file does not give; otherwise a default is used and reported.\n\n"
        "To make raised lines, use convert: tactics convert drawing.svg -o page.height.png, or -o page.stl.\n\n"
        "--for NAME tries 30 ways to resample, smooth and compress the heights, and takes the one that this medium carries best "
        "(tactics help measure).\n\n"
        "An STL is a closed solid with a flat bottom and upright sides, as large as the map from edge to edge.",
    .example =
        "tactics relief terrain.png --width 150mm --high 12mm -o terrain.stl\n"
        "tactics relief chair.stl --width 120mm --pitch 0.2mm -o chair.png\n"
        "tactics relief terrain.csv --z height --width 120mm -o terrain.stl\n"
        "tactics relief terrain.png --for omni -o felt.png\n"
        "tactics relief page.height.png --json -o page.tif -o page.exr",
    .flags = kReliefFlags,
    .offers = "files",
    .run = run_relief,
};

}  // namespace tactics
