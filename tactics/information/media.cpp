// SPDX-License-Identifier: Apache-2.0
#include "tactics/information/media.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "print/embosser.h"
#include "print/format.h"
#include "print/page_relief.h"
#include "tactics/error.h"
#include "tactics/units.h"

namespace tactics {

namespace {

constexpr std::string_view kPaper = "a4";  // of a medium by itself

void put_on_paper(MediumChannel& channel, const Paper& paper, double margin) {
    channel.width = paper.width - 2 * margin;
    channel.height = paper.height - 2 * margin;
}

double pitch_of_cells(const CellSize& cell, int dots_down) {
    return std::sqrt(cell.cell_pitch / 2 * cell.line_pitch / dots_down);
}

// What can be told apart on it: with fixed dots, an empty one between two.
void limit_lines(MediumChannel& channel, const Medium& medium) {
    channel.least_apart = has_fixed_dots(medium) ? 2 * channel.pitch : least_apart(medium, medium.line, medium.line);
    channel.shortest = medium.shortest;
}

MediumChannel channel_of(const Medium& medium, const Paper& paper) {
    MediumChannel channel{.name = std::string(medium.name), .kind = "medium"};
    put_on_paper(channel, paper, medium.margin);
    channel.pitch = has_fixed_dots(medium) ? pitch_of_cells(kMarburgMedium, 3) : kMmPerInch / medium.dpi;
    limit_lines(channel, medium);
    return channel;
}

MediumChannel channel_of(const Format& format, const std::optional<Paper>& wished) {
    const Medium& medium = find_medium(format.medium, "");
    MediumChannel channel = channel_of(medium, wished ? *wished : find_paper(format.paper, ""));
    const Settings settings(format.options);
    channel.name = format.name;
    channel.kind = format.embosser == nullptr ? "heights" : format.embosser->display != nullptr ? "display" : "embosser";
    if (format.encode_heights != nullptr) {
        channel.pitch = settings.number(kReliefPitch.name);
        channel.levels = kMostLevels;
    }
    if (format.dots == nullptr) return channel;
    const DotSetting dots = format.dots(settings);
    if (dots.width > 0) {
        channel.width = dots.width;
        channel.height = dots.height;
        channel.kind = "display";
    }
    channel.pitch = dots.bed.raster > 0 ? dots.bed.raster : pitch_of_cells(dots.cell, dots.bed.dots_down);
    channel.levels = dots.heights.levels;
    limit_lines(channel, medium);
    return channel;
}

using Channels = std::vector<MediumChannel>;

// `besides`: what else may be said there.
Channels::const_iterator channel_in(const Channels& all, const std::string& name, std::vector<std::string_view> besides,
                                    const std::string& place) {
    const auto found = std::find_if(all.begin(), all.end(), [&](const MediumChannel& channel) { return channel.name == name; });
    if (found != all.end()) return found;
    const bool takes_lists = !besides.empty();
    std::transform(all.begin(), all.end(), std::back_inserter(besides),
                   [](const MediumChannel& channel) { return std::string_view(channel.name); });
    throw Error(Fault::usage, place,
                !takes_lists
                    ? phrase("there is no medium \"{0}\"{1}; it is a medium, an embosser, a display or a file of heights of "
                             "tactics list, mouse, omni, desktop or phantom",
                             name.substr(0, 80), did_you_mean(name, besides))
                    : phrase("there is no medium \"{0}\"{1}; it is all, or names between commas: a medium, an embosser, "
                             "a display or a file of heights of tactics list, mouse, omni, desktop or phantom",
                             name.substr(0, 80), did_you_mean(name, besides)));
}

}  // namespace

MediumChannel channel_of(std::string_view name, const ArmSettings& arm) {
    return {.name = std::string(name),
            .kind = "arm",
            .width = arm.width,
            .height = std::min(arm.height, arm.depth),
            .pitch = arm.resolution,
            .step = arm.resolution,
            .travel = std::max(arm.height, arm.depth),
            .most_force = arm.most_force};
}

MediumChannel channel_of(const MouseSettings& mouse) {
    return {.name = "mouse",
            .kind = "mouse",
            .pitch = 1 / mouse.sensors.counts_per_mm,
            .step = mouse.lever.encoder_step,
            .travel = mouse.lever.highest - mouse.lever.lowest,
            .most_force = mouse.lever.most_force};
}

std::vector<MediumChannel> channels(const std::optional<Paper>& paper) {
    std::vector<MediumChannel> all;
    for (const Medium& medium : media()) all.push_back(channel_of(medium, paper ? *paper : find_paper(kPaper, "")));
    for (const Format* format : formats())
        if (format->embosser != nullptr || format->encode_heights != nullptr) all.push_back(channel_of(*format, paper));
    all.push_back(channel_of(MouseSettings{}));
    for (const NamedArm& arm : kArms) all.push_back(channel_of(arm.name, arm.arm));
    return all;
}

MediumChannel named_channel(const std::string& name, const std::string& place) {
    const std::vector<MediumChannel> all = channels({});
    return *channel_in(all, name, {}, place);
}

std::vector<MediumChannel> named_channels(const std::string& names, const std::optional<Paper>& paper, const std::string& place) {
    const std::vector<MediumChannel> all = channels(paper);
    if (names == "all") return all;
    std::vector<MediumChannel> chosen;
    for (std::size_t from = 0, comma = 0; comma != std::string::npos; from = comma + 1) {
        comma = names.find(',', from);
        const std::string name = names.substr(from, comma == std::string::npos ? comma : comma - from);
        chosen.push_back(*channel_in(all, name, {"all"}, place));
    }
    return chosen;
}

}  // namespace tactics
