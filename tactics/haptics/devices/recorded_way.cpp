// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/devices/recorded_way.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <utility>

#include "tactics/coding/recording.h"
#include "tactics/error.h"
#include "tactics/haptics/devices/arm_devices.h"
#include "tactics/units.h"

namespace tactics {

namespace {

std::vector<std::string_view> cells_of_line(std::string_view line) {
    std::vector<std::string_view> cells;
    for (;;) {
        const auto comma = line.find(',');
        std::string_view cell = line.substr(0, comma);
        while (!cell.empty() && (cell.front() == ' ' || cell.front() == '\t')) cell.remove_prefix(1);
        while (!cell.empty() && (cell.back() == ' ' || cell.back() == '\t' || cell.back() == '\r')) cell.remove_suffix(1);
        cells.push_back(cell);
        if (comma == std::string_view::npos) return cells;
        line.remove_prefix(comma + 1);
    }
}

constexpr double kMostTime = 1e7, kMostLength = 1e5;  // s, mm
constexpr std::size_t kMostLines = 10'000'000;

struct Columns {
    std::size_t time = 0, x = 1, y = 2;
    std::optional<std::size_t> height;
};

// By the names in a header, in any order; other columns are ignored.
template <typename Fail>
Columns columns_of(const std::vector<std::string_view>& cells, const Fail& fail) {
    const auto find = [&](std::string_view name) -> std::optional<std::size_t> {
        const auto found = std::find(cells.begin(), cells.end(), name);
        return found == cells.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - cells.begin()));
    };
    Columns columns;
    for (const auto& [name, column] :
         {std::pair<std::string_view, std::size_t*>{"time_s", &columns.time}, {"x_mm", &columns.x}, {"y_mm", &columns.y}}) {
        const auto found = find(name);
        if (!found)
            fail(
                phrase("its first line names the columns, and none of them is {0}; they are time_s,x_mm,y_mm and perhaps z_mm or "
                       "finger_mm, with commas between them",
                       name));
        *column = *found;
    }
    columns.height = find("z_mm");
    const auto finger = find("finger_mm");
    if (columns.height && finger) fail(phrase("z_mm and finger_mm are both the height of the finger; leave out one of them"));
    if (!columns.height) columns.height = finger;
    return columns;
}

// The places of a recording in the container; its forces were those of another play.
RecordedWay packed_way(std::string_view bytes, const std::string& name) {
    const Recording recording = decode_recording(Container(bytes, name));
    if (recording.times.size() < 2)
        throw Error(Fault::failed, name, phrase("a way has at least two moments; record a longer one"));
    std::vector<WayMoment> moments;
    moments.reserve(recording.times.size());
    const auto mm = [&](std::int64_t steps) { return static_cast<double>(steps) * recording.place_step; };
    for (std::size_t i = 0; i < recording.times.size(); ++i) {
        const Steps3& place = recording.places[i];
        moments.push_back(
            {static_cast<double>(recording.times[i] - recording.times.front()) / 1e6, {mm(place.x), mm(place.y), mm(place.z)}});
    }
    return {std::move(moments), recording.has_height};
}

class RecordedArm : public HapticDevice {
public:
    explicit RecordedArm(RecordedWay way) : way_(std::move(way)) {}
    State read(HapticSample& sample, double dt) noexcept override {
        time_ += dt;
        if (time_ > way_.end()) return State::over;
        const Point3 at = way_.at(time_);
        sample.knows_place = true;
        sample.place = {at.x, at.y};
        sample.height = at.z;
        return State::fine;
    }
    bool push(const Point3&) noexcept override { return true; }

private:
    RecordedWay way_;
    double time_ = 0;
};

}  // namespace

Point3 RecordedWay::at(double time) noexcept {
    while (next_ + 1 < moments_.size() && moments_[next_].time < time) ++next_;
    if (next_ == 0) return moments_[0].at;
    const WayMoment &a = moments_[next_ - 1], &b = moments_[next_];
    const double share = b.time > a.time ? std::clamp((time - a.time) / (b.time - a.time), 0.0, 1.0) : 1;
    return a.at + share * (b.at - a.at);
}

RecordedWay read_way(std::string_view csv, const std::string& name) {
    if (csv.starts_with(kContainerMagic)) return packed_way(csv, name);
    if (csv.starts_with("\xEF\xBB\xBF")) csv.remove_prefix(3);  // what some programs put before UTF-8
    std::vector<WayMoment> moments;
    std::size_t line_number = 0;
    Columns columns;
    bool headed = false;
    while (!csv.empty()) {
        const std::string_view line = csv.substr(0, csv.find('\n'));
        csv.remove_prefix(std::min(csv.size(), line.size() + 1));
        ++line_number;
        if (line.find_first_not_of(" \t\r") == std::string_view::npos || line[0] == '#') continue;
        const auto cells = cells_of_line(line);
        const auto fail = [&](const Phrase& what) { throw Error(Fault::failed, name + ":" + std::to_string(line_number), what); };
        if (moments.empty() && !headed && !parse_number(cells[0])) {
            headed = true;
            columns = columns_of(cells, fail);
            continue;
        }
        const auto number = [&](std::size_t column, double most) {
            const auto value = column < cells.size() ? parse_number(cells[column]) : std::nullopt;
            if (!value) fail(phrase("a line is time_s,x_mm,y_mm, all of them numbers, for example 0.001,12.5,40"));
            if (!(std::abs(*value) <= most))
                fail(phrase("{0} is beyond {1}; times are in s and lengths in mm", cells[column], numeral(most)));
            return *value;
        };
        const WayMoment moment{number(columns.time, kMostTime),
                               {number(columns.x, kMostLength), number(columns.y, kMostLength),
                                columns.height ? number(*columns.height, kMostLength) : 0}};
        if (!moments.empty() && moment.time < moments.back().time)
            fail(phrase("time goes back here; sort the lines by their time"));
        if (moments.size() == kMostLines) fail(phrase("there are over 10 million lines; take fewer at a time"));
        moments.push_back(moment);
    }
    if (moments.size() < 2)
        throw Error(Fault::failed, name, phrase("a way has at least two moments; a line is time_s,x_mm,y_mm"));
    const double begin = moments.front().time;
    for (WayMoment& moment : moments) moment.time -= begin;
    return {std::move(moments), columns.height.has_value()};
}

std::unique_ptr<HapticDevice> recorded_arm(std::string_view csv, const std::string& name) {
    RecordedWay way = read_way(csv, name);
    if (!way.has_height())
        throw Error(Fault::failed, name,
                    phrase("for an arm a way has three coordinates; its first line is time_s,x_mm,y_mm,z_mm"));
    return std::make_unique<RecordedArm>(std::move(way));
}

}  // namespace tactics
