// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/loop/tick_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>

#include "tactics/error.h"
#include "tactics/readers/read_table.h"
#include "tactics/text/number.h"

namespace tactics {

namespace {

constexpr double kMostTime = 1e7, kMostLength = 1e5, kMostForce = 1e4;  // s, mm, N
constexpr double kMicroseconds = 1e6;
constexpr std::array<double, 7> kPerUnit{1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6};  // steps

// The possible columns of a row, in reading order.
enum Column : std::size_t { kTime, kX, kY, kHeight, kForce, kForceX, kForceY, kColumns };
constexpr std::array<std::string_view, kColumns> kNames{"time_s",  "x_mm",      "y_mm",     "finger_mm",
                                                        "force_n", "force_x_n", "force_y_n"};
constexpr std::array<double, kColumns> kMost{kMostTime,  kMostLength, kMostLength, kMostLength,
                                             kMostForce, kMostForce,  kMostForce};

using Row = std::array<double, kColumns>;

std::optional<std::size_t> column_of(const TableHead& head, std::string_view name) {
    const auto found = std::find(head.columns.begin(), head.columns.end(), name);
    return found == head.columns.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - head.columns.begin()));
}

// By what is read of a row; some are not there.
std::array<std::optional<std::size_t>, kColumns> columns_of(const TableHead& head) {
    std::array<std::optional<std::size_t>, kColumns> columns;
    for (std::size_t i = 0; i < kColumns; ++i) columns[i] = column_of(head, kNames[i]);
    if (!columns[kHeight]) columns[kHeight] = column_of(head, "z_mm");
    for (const std::size_t needed : {kTime, kX, kY})
        if (!columns[needed])
            throw Error(
                Fault::failed, head.name,
                phrase("has no column {0}; a recording has time_s,x_mm,y_mm and perhaps finger_mm and force_n, as play writes it",
                       kNames[needed]));
    return columns;
}

std::vector<Row> rows_of(Source& table, const TableHead& head, const std::array<std::optional<std::size_t>, kColumns>& columns) {
    std::vector<std::size_t> wanted, places;
    for (std::size_t i = 0; i < kColumns; ++i)
        if (columns[i]) {
            wanted.push_back(*columns[i]);
            places.push_back(i);
        }
    std::vector<Row> rows;
    read_rows(table, head, wanted, [&](std::size_t line, std::span<const std::string_view> cells, bool) {
        const auto fail = [&](const Phrase& what) { throw Error(Fault::failed, place_of_row(head, line), what); };
        Row row{};
        for (std::size_t i = 0; i < places.size(); ++i) {
            const auto value = parse_number(cells[i]);
            const std::size_t place = places[i];
            if (!value) fail(phrase("\"{0}\" is no number; {1} needs one in each line", cells[i].substr(0, 80), kNames[place]));
            if (!(std::abs(*value) <= kMost[place]))
                fail(phrase("{0} is beyond {1}; times are in s, lengths in mm and forces in N", cells[i].substr(0, 80),
                            numeral(kMost[place])));
            row[place] = *value;
        }
        if (!rows.empty() && row[kTime] < rows.back()[kTime]) fail(phrase("time goes back here; sort the lines by their time"));
        if (rows.size() == kMostTicks) fail(phrase("there are over 10 million ticks; take fewer at a time"));
        rows.push_back(row);
    });
    if (rows.empty()) throw Error(Fault::failed, head.name, phrase("has no ticks; a line is time_s,x_mm,y_mm"));
    return rows;
}

// The number of steps per unit for which all numbers of some columns are whole.
double steps_per_unit(const std::vector<Row>& rows, std::initializer_list<Column> columns, bool& exact) {
    std::size_t step = 0;
    for (const Row& row : rows)
        for (const Column column : columns)
            while (step + 1 < kPerUnit.size()) {
                const double steps = row[column] * kPerUnit[step];
                if (std::abs(steps - std::round(steps)) <= 1e-7) break;
                ++step;
            }
    for (const Row& row : rows)
        for (const Column column : columns) {
            const double steps = row[column] * kPerUnit[step];
            exact = exact && std::abs(steps - std::round(steps)) <= 1e-3;
        }
    return kPerUnit[step];
}

}  // namespace

bool has_ticks(Source& table) { return column_of(table_head(table), kNames[kTime]).has_value(); }

TickTable read_ticks(Source& table) {
    const TableHead head = table_head(table);
    const auto columns = columns_of(head);
    const std::vector<Row> rows = rows_of(table, head, columns);
    TickTable ticks;
    bool exact = true;
    const double per_mm = steps_per_unit(rows, {kX, kY, kHeight}, exact);
    const double per_newton = steps_per_unit(rows, {kForce, kForceX, kForceY}, exact);
    Recording& recording = ticks.recording;
    recording.place_step = 1 / per_mm;
    recording.force_step = 1 / per_newton;
    recording.has_height = columns[kHeight].has_value();
    recording.spatial = columns[kForceX] || columns[kForceY];
    for (const Row& row : rows) {
        recording.times.push_back(std::llround(row[kTime] * kMicroseconds));
        recording.places.push_back(
            {std::llround(row[kX] * per_mm), std::llround(row[kY] * per_mm), std::llround(row[kHeight] * per_mm)});
        recording.forces.push_back({std::llround(row[kForceX] * per_newton), std::llround(row[kForceY] * per_newton),
                                    std::llround(row[kForce] * per_newton)});
    }
    if (!columns[kForce] && !recording.spatial)
        ticks.notes.push_back(phrase("it has no column force_n: a way is kept, and no forces"));
    if (!exact) ticks.notes.push_back(phrase("numbers with more than six decimals are rounded to these"));
    std::vector<std::string> left_out;
    for (std::size_t i = 0; i < head.columns.size(); ++i)
        if (std::find(columns.begin(), columns.end(), std::optional(i)) == columns.end()) left_out.push_back(head.columns[i]);
    if (!left_out.empty()) {
        std::string names;
        for (const std::string& name : left_out) names += (names.empty() ? "" : ", ") + name;
        ticks.notes.push_back(phrase("left out: {0}", names));
    }
    return ticks;
}

std::string ticks_csv(const Recording& recording) {
    std::string text = "time_s,x_mm,y_mm";
    if (recording.has_height) text += ",finger_mm";
    text += ",force_n";
    if (recording.spatial) text += ",force_x_n,force_y_n";
    text += "\n";
    const auto add = [&](std::int64_t steps, double step) { text += "," + to_text(static_cast<double>(steps) * step); };
    for (std::size_t i = 0; i < recording.times.size(); ++i) {
        text += to_text(static_cast<double>(recording.times[i]) / kMicroseconds);
        const Steps3 &place = recording.places[i], &force = recording.forces[i];
        add(place.x, recording.place_step);
        add(place.y, recording.place_step);
        if (recording.has_height) add(place.z, recording.place_step);
        add(force.z, recording.force_step);
        if (recording.spatial) {
            add(force.x, recording.force_step);
            add(force.y, recording.force_step);
        }
        text += "\n";
    }
    return text;
}

}  // namespace tactics
