// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/felt_heights.h"

#include <utility>

#include "print/page_relief.h"
#include "tactics/error.h"
#include "tactics/information/least_loss.h"
#include "tactics/job/holds.h"
#include "tactics/job/open_input.h"
#include "tactics/job/surface_heights.h"
#include "tactics/job/table.h"
#include "tactics/units.h"

namespace tactics {

namespace {

constexpr std::string_view kRaisedAs = "heightmap";

bool is_silent(const HeightWish& wish) { return !wish.pitch && !wish.width && !wish.low && !wish.high; }

// How a page is raised, as its format has it.
Settings relief_settings(const HeightWish& wish) {
    Settings settings(find_format(kRaisedAs)->options);
    const auto set = [&](std::string_view option, std::string_view wished, const std::optional<double>& value) {
        if (value) settings.set(option, to_text(*value), spelled(wished), kRaisedAs);
    };
    set("pitch", "pitch", wish.pitch);
    set("height", "high", wish.high);
    if (wish.low && *wish.low != 0)
        throw Error(Fault::usage, spelled("low"), phrase("the lines of a drawing stand on a ground of 0 mm; leave it out"));
    return settings;
}

FeltHeights draw(Source source, const HeightWish& heights, Wishes wishes) {
    const Settings settings = relief_settings(heights);
    wishes.sheet.bare = true;
    if (heights.width) wishes.sheet.drawing_width = heights.width;
    const Job job{{source.name, {{find_format(kRaisedAs), "", ""}}}, std::move(wishes)};
    FeltHeights felt;
    felt.drawn = make_pages(std::move(source), job);
    if (!felt.drawn->error.empty()) throw Error(felt.drawn->fault, "", felt.drawn->error);
    const Layout& layout = felt.drawn->layouts.front();
    if (layout.empty)
        throw Error(Fault::failed, job.input,
                    phrase("nothing is drawn of it that could be felt; take another {0}", spelled("recipe")));
    PageRelief relief(layout.shown.front(), settings, kRaisedAs);
    felt.file = {relief.map(), relief.sheet().low, relief.sheet().high, "drawing", {}};
    return felt;
}

}  // namespace

FeltHeights felt_heights(Source source, const std::string& path, const HeightWish& heights, Wishes wishes) {
    std::vector<Phrase> notes;
    const Holds holds = look_at(source);
    if (holds == Holds::model) return {read_heights(source, heights), {}};
    if (holds == Holds::table && !asks_for_a_way(wishes.chain) && is_of_heights(source, wishes.table)) {
        if (auto surface = surface_in(source, wishes.table, notes)) {
            FeltHeights felt{surface_heights(*surface, heights), {}};
            felt.file.notes.insert(felt.file.notes.begin(), notes.begin(), notes.end());
            return felt;
        }
        notes.clear();
    }
    if (holds == Holds::picture && !asks_for_a_way(wishes.chain)) {
        if (!is_silent(heights)) return {read_heights(source, heights), {}};
        if (auto told = read_told_heights(source, heights)) return {std::move(*told), {}};
    }
    source = page_of_input(std::move(source), path, page_wish(wishes), notes);
    FeltHeights felt = draw(std::move(source), heights, std::move(wishes));
    felt.drawn->notes.insert(felt.drawn->notes.begin(), notes.begin(), notes.end());
    return felt;
}

void fit_heights(HeightFile& file, const MediumChannel& channel, const std::string& name) {
    MeasuredScene scene =
        scene_of(grid_of(file.map, file.low, file.high, kMostLevels, name), file.map.pitch, file.low, file.high, name);
    const LeastLoss least = least_loss(scene, channel);
    if (least.plain > 0) file.map = transformed_heights(scene, least.best, least.levels);
    file.notes.push_back(phrase("for {0}: {1}", channel.name, explained(least, scene.pyramid.whole())));
}

}  // namespace tactics
