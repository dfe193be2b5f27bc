// SPDX-License-Identifier: Apache-2.0
#include "cli/verbs/voxel_report.h"

#include <algorithm>
#include <cmath>

#include "tactics/text/json.h"
#include "tactics/text/rounded.h"
#include "tactics/text/table.h"
#include "tactics/units.h"

namespace tactics {

namespace {

// What a type of whole numbers has; fractions from the least to the most, those of vectors as far to either side, so that the
// middle level is nothing.
VoxelLevels levels_of(const Voxels& voxels, std::vector<std::string>& notes) {
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
    notes.push_back("its numbers are counted in " + std::to_string(levels.levels) + " levels from " + to_text(levels.low) +
                    " to " + to_text(levels.high));
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
    std::string text = report.file + ": NRRD of " + size_of(report.columns, report.rows, report.slices) + " voxels" +
                       (report.levels.components > 1 ? " with three components each, " : ", ") +
                       std::to_string(report.levels.levels) + " levels\n";
    text += "bits in it: " + fixed_count(measured.low) + " to " + fixed_count(measured.high) + " (" +
            fixed(measured.low / count, 3) + " to " + fixed(measured.high / count, 3) + " a voxel); " +
            fixed_count(measured.raw) + " as it is written\n";
    for (const Measures& along : measured.along)
        text += "of its levels alone: " + fixed(along.alone.corrected, 3) + " bits a voxel; topology index " +
                fixed(along.topology, 3) + "\n";
    if (measured.details.empty()) return text;
    std::vector<Row> rows = {{"voxels", "bits", "of all", "error if the rest is interpolated"}};
    for (const VoxelDetail& detail : measured.details)
        rows.push_back({size_of(detail.columns, detail.rows, detail.slices), fixed_count(detail.bits),
                        exact_percent(measured.high > 0 ? detail.bits / measured.high : 1), fixed(detail.error, 3)});
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
    json.add("high_bits", measured.high);
    std::vector<std::string> along, details;
    for (const Measures& each : measured.along) {
        JsonObject one;
        one.add("low_bits", each.low);
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
