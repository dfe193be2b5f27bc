// SPDX-License-Identifier: Apache-2.0
#include "cli/verbs/voxel_report.h"

#include <algorithm>
#include <cmath>

#include "cli/report/user_language.h"
#include "tactics/text/json.h"
#include "tactics/text/table.h"
#include "tactics/units.h"

namespace tactics {

namespace {

// What a type of whole numbers has; fractions from the least to the most, those of vectors as far to either side, so that the
// middle level is nothing.
VoxelLevels levels_of(const Voxels& voxels, std::vector<Phrase>& notes) {
    VoxelLevels levels{voxels.components, voxels.lowest, voxels.lowest + voxels.levels - 1, voxels.levels};
    if (voxels.levels > 0) return levels;
    const auto [least, most] = std::minmax_element(voxels.values.begin(), voxels.values.end());
    levels.low = *least;
    levels.high = *most;
    levels.levels = kMostLevels;
    if (voxels.components > 1) {
        levels.high = std::max(std::abs(*least), std::abs(*most));
        levels.low = -levels.high;
        levels.levels = kMostLevels - 1;
    }
    notes.push_back(phrase("its numbers are counted in {0} levels from {1} to {2}", std::to_string(levels.levels),
                           numeral(levels.low), numeral(levels.high)));
    return levels;
}

ForceField field_of(Voxels voxels) {
    ForceField field{voxels.columns, voxels.rows, voxels.slices, 1, {}};
    const auto step = static_cast<std::size_t>(voxels.components);
    field.forces.reserve(voxels.values.size() / step);
    for (std::size_t i = 0; i < voxels.values.size(); i += step) {
        Point3 force{voxels.values[i], 0, 0};
        if (step == 3) force = {voxels.values[i], voxels.values[i + 1], voxels.values[i + 2]};
        field.forces.push_back(force);
    }
    return field;
}

std::string size_of(int columns, int rows, int slices) {
    return std::to_string(columns) + " x " + std::to_string(rows) + " x " + std::to_string(slices);
}

}  // namespace

VoxelReport voxel_report(const std::string& file, Voxels voxels, bool with_details) {
    VoxelReport report{file, voxels.columns, voxels.rows, voxels.slices, {}, {}, {}};
    report.levels = levels_of(voxels, report.notes);
    report.measured = measured(field_of(std::move(voxels)), report.levels, with_details, file);
    return report;
}

std::string text_of(const VoxelReport& report) {
    const MeasuredVoxels& measured = report.measured;
    const double count = static_cast<double>(report.columns) * report.rows * report.slices;
    const std::string size = size_of(report.columns, report.rows, report.slices), levels = std::to_string(report.levels.levels);
    std::string text =
        line_for_user(report.levels.components > 1
                          ? phrase("{0}: NRRD of {1} voxels with three components each, {2} levels", report.file, size, levels)
                          : phrase("{0}: NRRD of {1} voxels, {2} levels", report.file, size, levels));
    text += line_for_user(phrase("bits in it: {0} to {1} ({2} to {3} a voxel); {4} as it is written",
                                 for_user(fixed_count(measured.low)), for_user(fixed_count(measured.high)),
                                 for_user(fixed(measured.low / count, 3)), for_user(fixed(measured.high / count, 3)),
                                 for_user(fixed_count(measured.raw))));
    for (const Measures& along : measured.along)
        text += line_for_user(phrase("of its levels alone: {0} bits a voxel; topology index {1}",
                                     for_user(fixed(along.alone.corrected, 3)), for_user(fixed(along.topology, 3))));
    if (measured.details.empty()) return text;
    std::vector<Row> rows = {in_language(
        {phrase("voxels"), phrase("bits"), phrase("of all"), phrase("error if the rest is interpolated")}, user_language())};
    for (const VoxelDetail& detail : measured.details)
        rows.push_back({size_of(detail.columns, detail.rows, detail.slices), for_user(fixed_count(detail.bits)),
                        for_user(exact_percent(measured.bits > 0 ? detail.bits / measured.bits : 1)),
                        for_user(fixed(detail.error, 3))});
    return text + "\n" + aligned(std::move(rows));
}

std::string json_of(const VoxelReport& report) {
    const MeasuredVoxels& measured = report.measured;
    JsonAnswer json;
    json.add("input", report.file);
    json.add("format", "NRRD");
    json.add("columns", report.columns);
    json.add("rows", report.rows);
    json.add("slices", report.slices);
    json.add("components", report.levels.components);
    json.add("levels", report.levels.levels);
    json.add("raw_bits", measured.raw);
    json.add("low_bits", measured.low);
    json.add("bits", measured.bits);
    json.add("high_bits", measured.high);
    std::vector<std::string> along, details;
    for (const Measures& each : measured.along) {
        JsonObject one;
        one.add("low_bits", each.low);
        one.add("bits", each.bits);
        one.add("high_bits", each.high);
        one.add("levels_alone_bits_a_voxel", each.alone.corrected);
        one.add("topology_index", each.topology);
        along.push_back(one.text());
    }
    for (const VoxelDetail& detail : measured.details) {
        JsonObject one;
        one.add("columns", detail.columns);
        one.add("rows", detail.rows);
        one.add("slices", detail.slices);
        one.add("bits", detail.bits);
        one.add("error", detail.error);
        details.push_back(one.text());
    }
    json.add_raw("along", json_array(along));
    json.add_raw("levels_of_detail", json_array(details));
    json.add_raw("notes", json_text_array(report.notes));
    return json.text() + "\n";
}

}  // namespace tactics
