// SPDX-License-Identifier: Apache-2.0
// `tactics decode`: what `encode` has packed, or a part of it.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "cli/command.h"
#include "cli/report/say.h"
#include "print/format.h"
#include "tactics/error.h"
#include "tactics/haptics/loop/tick_table.h"
#include "tactics/job/disk.h"
#include "tactics/readers/felt_file.h"
#include "tactics/relief/read_heights.h"
#include "tactics/text/json.h"
#include "tactics/transport/file.h"
#include "tactics/units.h"

namespace tactics {

namespace {

constexpr Flag kDecodeFlags[] = {
    {"--output", "-o", "OUT",
     "where to write: .csv for a recording; .png, .tif, .exr, .stl or .felt for heights. Without it, tactics only says what the "
     "file holds",
     false, "files"},
    {"--part", "", "FROM,TO|LEFT,TOP,RIGHT,BOTTOM",
     "unpack only this part: of a recording, from one time to another, in s; of heights, a rectangle in mm from the upper left "
     "corner. Nothing else is unpacked",
     false, ""},
    {"--json", "", "", "one JSON object on standard output", false, ""},
    {"--quiet", "-q", "", "nothing but errors", false, ""},
};

// The numbers of --part: none, or `count` of them that ascend in pairs.
std::vector<double> part_of_decode(const Given& given, std::size_t count, const Phrase& form) {
    std::vector<double> numbers;
    if (!given.has("--part")) return numbers;
    const std::string text = given.value("--part");
    std::string_view left = text;
    for (std::string_view word; numbers.size() < count; left.remove_prefix(std::min(left.size(), word.size() + 1))) {
        word = left.substr(0, left.find(','));
        const auto number = count == 2 ? parse_number(word) : parse_length(word);
        if (!number) break;
        numbers.push_back(*number);
    }
    bool fits = numbers.size() == count && std::count(text.begin(), text.end(), ',') + 1 == static_cast<long>(count);
    for (std::size_t i = 0; fits && i < count / 2; ++i) fits = numbers[i] < numbers[i + count / 2];
    if (!fits) throw Error(Fault::usage, "--part", phrase("it cannot be \"{0}\"; it is {1}", text.substr(0, 80), form));
    return numbers;
}

Phrase thousandths(double value) { return numeral(std::round(value / 0.001) * 0.001); }

struct DecodeTold {
    JsonAnswer object;
    Phrase line;
    std::string bytes;
};

DecodeTold told_ticks(const Container& container, const Given& given) {
    const std::string output = given.value("--output");
    if (!output.empty() && !output.ends_with(".csv") && output != "-")
        throw Error(Fault::usage, "--output", phrase("\"{0}\" must end in .csv: it holds a recording", output.substr(0, 80)));
    const RecordingFacts facts = recording_facts(container);
    const auto part = part_of_decode(given, 2, phrase("FROM,TO in s, such as 2,5"));
    const auto microseconds = [](double seconds) { return std::llround(std::clamp(seconds, -1e7, 1e7) * 1e6); };
    const Recording recording =
        part.empty() ? decode_recording(container) : decode_recording(container, microseconds(part[0]), microseconds(part[1]));
    if (recording.times.empty())
        throw Error(Fault::usage, "--part", phrase("there is no tick between {0} and {1} s", to_text(part[0]), to_text(part[1])));
    const double seconds = static_cast<double>(recording.times.back() - recording.times.front()) / 1e6;
    DecodeTold told;
    told.object.add("kind", "recording");
    told.object.add("ticks", static_cast<double>(recording.times.size()));
    told.object.add("seconds", seconds);
    told.object.add("place_step_mm", facts.place_step);
    told.object.add("force_step_n", facts.force_step);
    told.object.add("deadband", facts.band.share);
    told.object.add("floor_n", facts.band.floor);
    told.object.add("work_allowed_nmm", facts.band.allowance);
    told.line = phrase("a recording of {0} ticks in {1} s", std::to_string(recording.times.size()), thousandths(seconds));
    if (facts.band.share > 0)
        told.line = phrase("{0}, its forces within {1} % or {2} N", std::move(told.line), thousandths(100 * facts.band.share),
                           numeral(facts.band.floor));
    told.bytes = ticks_csv(recording);
    return told;
}

DecodeTold told_heights(const Container& container, const Given& given) {
    const std::string output = given.value("--output");
    const Format* format = output.empty() ? nullptr : heights_format_of_path(output);
    if (!output.empty() && format == nullptr)
        throw Error(Fault::usage, "--output",
                    phrase("\"{0}\" must end in .png, .tif, .exr, .felt or .stl: it holds heights", output.substr(0, 80)));
    const LevelMap facts = map_facts(container);
    LevelWindow window{0, 0, facts.columns, facts.rows};
    if (const auto part = part_of_decode(given, 4, phrase("LEFT,TOP,RIGHT,BOTTOM, such as 10mm,20mm,60mm,50mm")); !part.empty()) {
        const auto place = [&](double length, int most) {
            return static_cast<int>(std::lround(std::clamp(length / facts.pitch, 0.0, static_cast<double>(most))));
        };
        window.left = place(part[0], facts.columns);
        window.top = place(part[1], facts.rows);
        window.columns = place(part[2], facts.columns) - window.left;
        window.rows = place(part[3], facts.rows) - window.top;
        if (window.columns < 1 || window.rows < 1)
            throw Error(Fault::usage, "--part",
                        phrase("the map has nothing there; it is {0} x {1} mm", thousandths(facts.columns * facts.pitch),
                               thousandths(facts.rows * facts.pitch)));
    }
    const LevelMap map = decode_levels(container, window, kMostHeights);
    DecodeTold told;
    told.object.add("kind", "heights");
    told.object.add("columns", map.columns);
    told.object.add("rows", map.rows);
    told.object.add("pitch_mm", map.pitch);
    told.object.add("low_mm", map.low);
    told.object.add("high_mm", map.high);
    told.object.add("levels", map.top + 1);
    told.line = phrase("{0} x {1} heights {2} mm apart, of {3} levels from {4} to {5} mm", std::to_string(map.columns),
                       std::to_string(map.rows), numeral(map.pitch), std::to_string(map.top + 1), thousandths(map.low),
                       thousandths(map.high));
    if (format != nullptr) {
        const HeightSheet sheet{map.columns, map.rows, map.pitch, map.low, map.high, map.profile};
        const HeightRows rows = [&map](int row, std::span<float> heights) {
            const auto first = map.levels.begin() + static_cast<std::ptrdiff_t>(row) * map.columns;
            std::transform(first, first + map.columns, heights.begin(),
                           [&map](Level level) { return static_cast<float>(std::min(map.high, map.low + map.rise * level)); });
        };
        told.bytes = format->encode_heights(sheet, rows, Settings(format->options));
    }
    return told;
}

int run_decode(const Given& given) {
    if (given.words.size() != 1) throw Error(Fault::usage, "decode", phrase("name one .felt file, or - for standard input"));
    const std::string input = given.words[0], output = given.value("--output");
    if (given.has("--output") && output.empty())
        throw Error(Fault::usage, "--output", phrase("name a file, for example ticks.csv"));
    const Disk disk = real_disk();
    if (input != "-" && !output.empty() && disk.identity(input) == disk.identity(output))
        throw Error(Fault::usage, "--output", phrase("{0} is the input; choose another name", output));
    Source source = open_source(input);
    const std::string bytes = felt_bytes(source);
    const Container container(bytes, source.name);
    DecodeTold told =
        container.kind() == ContainerKind::recording ? told_ticks(container, given) : told_heights(container, given);
    if (!output.empty()) write_file(output, told.bytes);
    if (given.has("--json")) {
        told.object.add("input", input);
        told.object.add("parts", static_cast<double>(container.parts()));
        told.object.add("output", output);
        print_out(told.object.text() + "\n");
    } else if (!given.has("--quiet")) {
        say(phrase("{0}: {1}", source.name, told.line));
    }
    return 0;
}

}  // namespace

extern const Command decode_command;
const Command decode_command{
    .name = "decode",
    .summary = "unpack heights or a recording that encode packed, or a part of them",
    .words = "IN.felt [-o OUT]",
    .details =
        "A recording becomes the table that play writes. To replay it as the path of a hand, there is no need to unpack it: "
        "tactics play MAP --device recorded:ticks.felt. Heights become any file of heights; convert, check, relief and play "
        "also read them packed.\n\n"
        "A truncated or altered file is refused: the head and each part have their own checksum (tactics help felt).",
    .example =
        "tactics decode ticks.felt -o ticks.csv\n"
        "tactics decode ticks.felt --part 20,25 -o five-seconds.csv\n"
        "tactics decode terrain.felt --part 10mm,10mm,60mm,40mm -o corner.png",
    .flags = kDecodeFlags,
    .offers = "files",
    .run = run_decode,
};

}  // namespace tactics
