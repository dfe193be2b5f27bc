// SPDX-License-Identifier: Apache-2.0
#include "cli/verbs/measure_report.h"

#include <cmath>
#include <string_view>

#include "cli/report/user_language.h"
#include "tactics/information/felt_rate.h"
#include "tactics/information/stream.h"
#include "tactics/text/json.h"
#include "tactics/text/rounded.h"
#include "tactics/text/table.h"
#include "tactics/text/words.h"
#include "tactics/units.h"

namespace tactics {

namespace {

std::string ratio(double of) { return for_user(fixed(of, of < 0.01 ? 6 : 4)); }
// "488201 to 489030", or once where both are the same.
Phrase interval(const Measures& measures) {
    const std::string low = for_user(fixed_count(measures.low)), high = for_user(fixed_count(measures.high));
    return low == high ? Phrase(high) : phrase("{0} to {1}", low, high);
}

Phrase length(double mm) { return numeral(std::round(mm / 0.001) * 0.001); }

std::string scene_lines(const MeasureReport& report) {
    const MeasuredScene& scene = report.found.scene;
    const LevelGrid& grid = scene.pyramid.whole();
    const Measures& measures = scene.measures;
    const auto cells = static_cast<double>(grid.count());
    const Phrase heights = scene.is_drawn() ? phrase("lines")
                                            : phrase("{0} levels from {1} to {2} mm", std::to_string(grid.levels),
                                                     length(scene.low), length(scene.high));
    std::string text = line_for_user(phrase("{0}: {1} of {2} x {3} cells, {4} x {5} mm, {6}", report.file,
                                            format_in_words(report.found.format), std::to_string(grid.columns),
                                            std::to_string(grid.rows), length(scene.width), length(scene.height), heights));
    text += line_for_user(phrase("bits in it: {0} ({1} to {2} a cell), {3} by the shortest code; {4} as it is written",
                                 interval(measures), for_user(fixed(measures.low / cells, 3)),
                                 for_user(fixed(measures.high / cells, 3)), for_user(fixed_count(measures.bits)),
                                 for_user(fixed_count(measures.raw))));
    text += line_for_user(phrase("of its levels alone: {0} bits a cell; topology index {1}",
                                 for_user(fixed(measures.alone.corrected, 3)), for_user(fixed(measures.topology, 3))));
    if (measures.counted < 1)
        text += line_for_user(phrase("counted in {0} of its rows, which stand for the rest", percent(measures.counted)));
    if (measures.felt)
        text += line_for_user(phrase("enough for a finger that feels {0} mm: {1} bits", length(kFeltHeight),
                                     for_user(fixed_count(*measures.felt))));
    return text;
}

Row heads(const std::vector<Phrase>& heads) { return in_language(heads, user_language()); }

std::string media_table(const MeasureReport& report) {
    std::vector<Row> rows = {heads({phrase("medium"), phrase("cells"), phrase("levels"), phrase("bits in"),
                                    phrase("bits carried"), phrase("ratio"), phrase("loss"), phrase("what is lost")})};
    for (const MeasuredMedium& medium : report.media) {
        const Carried& carried = medium.carried;
        const std::vector<std::string> lost = in_language(carried.lost, user_language());
        rows.push_back({medium.channel.name, std::to_string(carried.columns) + "x" + std::to_string(carried.rows),
                        std::to_string(carried.fit.levels), for_user(fixed_count(report.found.scene.measures.bits)),
                        for_user(fixed_count(carried.bits)), ratio(carried.ratio), for_user(exact_percent(carried.loss)),
                        joined({lost.begin(), lost.end()}, "; ", "; ")});
        if (carried.lost.empty()) rows.back().back() = phrase("nothing").in(user_language());
    }
    return aligned(std::move(rows));
}

std::string least_lines(const MeasureReport& report) {
    std::string text;
    for (const MeasuredMedium& medium : report.media)
        if (medium.least)
            text += line_for_user(
                phrase("{0}: {1}", medium.channel.name, explained(*medium.least, report.found.scene.pyramid.whole())));
    return text;
}

std::string level_table(const MeasureReport& report) {
    std::vector<Row> rows = {
        heads({phrase("cells"), phrase("bits"), phrase("of all"), phrase("bits a cell in common"), phrase("error in mm")})};
    for (const DetailLevel& level : report.levels)
        rows.push_back({std::to_string(level.columns) + "x" + std::to_string(level.rows), for_user(fixed_count(level.bits)),
                        for_user(exact_percent(level.bits / report.found.scene.measures.bits)), for_user(fixed(level.mutual, 3)),
                        report.found.scene.is_drawn() ? "" : for_user(fixed(level.error, 3))});
    return aligned(std::move(rows));
}

std::string medium_json(const MeasuredMedium& medium) {
    const MediumChannel& channel = medium.channel;
    const Carried& carried = medium.carried;
    JsonObject json;
    json.add("medium", channel.name);
    json.add("kind", channel.kind);
    json.add("workspace_mm", channel.width > 0 ? rounded(channel.width, 0.001) + "x" + rounded(channel.height, 0.001) : "");
    json.add("pitch_mm", channel.pitch);
    json.add("columns", carried.columns);
    json.add("rows", carried.rows);
    json.add("levels", carried.fit.levels);
    json.add("scale", carried.fit.scale);
    if (channel.most_force > 0) {
        json.add("most_force_n", channel.most_force);
        json.add("force_levels", weber_levels(kLeastForce, channel.most_force));
    }
    json.add("capacity_bits", std::round(carried.capacity));
    json.add("carried_bits", std::round(carried.bits));
    json.add("ratio", carried.ratio);
    json.add("loss", carried.loss);
    json.add_raw("lost", json_text_array(carried.lost));
    if (medium.least) {
        json.add("least_loss", medium.least->loss);
        json.add("least_longest", medium.least->best.longest);
        json.add("least_smoothing", medium.least->best.smoothing);
        json.add("least_evenness", medium.least->best.evenness);
    }
    return json.text();
}

std::string level_json(const DetailLevel& level) {
    JsonObject json;
    json.add("columns", level.columns);
    json.add("rows", level.rows);
    json.add("bits", std::round(level.bits));
    json.add("mutual_bits_a_cell", level.mutual);
    json.add("error_mm", level.error);
    return json.text();
}

}  // namespace

std::string text_of(const MeasureReport& report) {
    std::string text = scene_lines(report);
    if (!report.media.empty()) text += "\n" + media_table(report) + least_lines(report);
    if (!report.levels.empty()) text += "\n" + level_table(report);
    return text;
}

std::string json_of(const MeasureReport& report) {
    const MeasuredScene& scene = report.found.scene;
    const Measures& measures = scene.measures;
    JsonAnswer json;
    json.add("input", report.file);
    json.add("format", report.found.format);
    json.add("columns", scene.pyramid.whole().columns);
    json.add("rows", scene.pyramid.whole().rows);
    json.add("levels", scene.pyramid.whole().levels);
    json.add("width_mm", scene.width);
    json.add("height_mm", scene.height);
    json.add("low_mm", scene.low);
    json.add("high_mm", scene.high);
    json.add("raw_bits", std::round(measures.raw));
    json.add("low_bits", std::round(measures.low));
    json.add("bits", std::round(measures.bits));
    json.add("counted", measures.counted);
    json.add("high_bits", std::round(measures.high));
    if (measures.felt) json.add("felt_bits", std::round(*measures.felt));
    json.add("levels_alone_bits_a_cell", measures.alone.corrected);
    json.add("topology_index", measures.topology);
    std::vector<std::string> media, levels;
    for (const MeasuredMedium& medium : report.media) media.push_back(medium_json(medium));
    for (const DetailLevel& level : report.levels) levels.push_back(level_json(level));
    json.add_raw("media", json_array(media));
    json.add_raw("levels_of_detail", json_array(levels));
    json.add_raw("notes", json_text_array(report.found.notes));
    return json.text() + "\n";
}

}  // namespace tactics
