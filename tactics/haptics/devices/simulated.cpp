// SPDX-License-Identifier: Apache-2.0
// Mice without a mouse: a simulated lever under a hand that goes to and fro, or that repeats a way.
#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <utility>
#include <vector>

#include "tactics/error.h"
#include "tactics/haptics/devices/device_kind.h"
#include "tactics/haptics/devices/mouse_devices.h"
#include "tactics/readers/append_file.h"
#include "tactics/units.h"

namespace tactics {

namespace {

constexpr double kRest = 0.5;  // s that the hand rests at the edge while the force begins softly

// A moment of a recorded way.
struct Moment {
    double time = 0;
    Point at;
    double finger = 0;
};

class SimulatedMouse : public HapticDevice {
public:
    SimulatedMouse(const LeverSettings& lever, const std::optional<FingerSettings>& finger, double begin_height, double seconds)
        : lever_(lever, finger, begin_height), seconds_(seconds) {}

    State read(HapticSample& sample, double dt) noexcept override {
        if (time_ > 0 || dt > 0) lever_.advance(std::clamp(dt, 0.0, 1.0));
        time_ += dt;
        if (time_ > seconds_) return State::over;
        sample.knows_place = true;
        sample.place = place_at(time_);
        sample.height = height_at(time_);
        return State::fine;
    }
    bool push(const Point3& force) noexcept override {
        lever_.push(force.z);
        return true;
    }

protected:
    virtual Point place_at(double time) noexcept = 0;
    virtual double height_at(double) noexcept { return lever_.height(); }

private:
    SimulatedLever lever_;
    double time_ = 0, seconds_;
};

class ToAndFro : public SimulatedMouse {
public:
    ToAndFro(const LeverSettings& lever, const std::optional<FingerSettings>& finger, double width, double height,
             double begin_height, double speed, double seconds)
        : SimulatedMouse(lever, finger, begin_height, seconds), width_(width), y_(height / 2), speed_(speed) {}

private:
    Point place_at(double time) noexcept override {
        const double way = std::fmod(std::max(0.0, time - kRest) * speed_, 2 * width_);
        return {way < width_ ? way : 2 * width_ - way, y_};
    }
    double width_, y_, speed_;
};

class Recorded : public SimulatedMouse {
public:
    Recorded(const LeverSettings& lever, const std::optional<FingerSettings>& finger, double begin_height,
             std::vector<Moment> moments, bool has_finger)
        : SimulatedMouse(lever, finger, begin_height, moments.back().time),
          moments_(std::move(moments)),
          has_finger_(has_finger) {}

private:
    // Between which two moments, and how far.
    double find(double time) noexcept {
        while (next_ + 1 < moments_.size() && moments_[next_].time < time) ++next_;
        if (next_ == 0) return 1;
        const Moment &a = moments_[next_ - 1], &b = moments_[next_];
        return b.time > a.time ? std::clamp((time - a.time) / (b.time - a.time), 0.0, 1.0) : 1;
    }
    Point place_at(double time) noexcept override {
        const double share = find(time);
        const Moment &a = moments_[next_ == 0 ? 0 : next_ - 1], &b = moments_[next_];
        return {a.at.x + share * (b.at.x - a.at.x), a.at.y + share * (b.at.y - a.at.y)};
    }
    double height_at(double time) noexcept override {
        if (!has_finger_) return SimulatedMouse::height_at(time);
        const double share = find(time);
        const Moment &a = moments_[next_ == 0 ? 0 : next_ - 1], &b = moments_[next_];
        return a.finger + share * (b.finger - a.finger);
    }
    std::vector<Moment> moments_;
    bool has_finger_;
    std::size_t next_ = 0;
};

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

struct Columns {
    std::size_t time = 0, x = 1, y = 2;
    std::optional<std::size_t> finger;
};

// By the names of a header, in any order; others are passed over.
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
            fail("its first line names the columns, and none of them is " + std::string(name) +
                 "; they are time_s,x_mm,y_mm and perhaps finger_mm, with commas between them");
        *column = *found;
    }
    columns.finger = find("finger_mm");
    return columns;
}

}  // namespace

std::unique_ptr<HapticDevice> simulated_mouse(const LeverSettings& lever, const std::optional<FingerSettings>& finger,
                                              double width, double height, double begin_height, double speed, double seconds) {
    return std::make_unique<ToAndFro>(lever, finger, width, height, begin_height, speed, seconds);
}

std::unique_ptr<HapticDevice> recorded_mouse(std::string_view csv, const std::string& name, const LeverSettings& lever,
                                             const std::optional<FingerSettings>& finger, double begin_height) {
    constexpr std::size_t kMostLines = 10'000'000;
    if (csv.starts_with("\xEF\xBB\xBF")) csv.remove_prefix(3);  // what some programs put before UTF-8
    std::vector<Moment> moments;
    std::size_t line_number = 0;
    Columns columns;
    bool headed = false;
    while (!csv.empty()) {
        const std::string_view line = csv.substr(0, csv.find('\n'));
        csv.remove_prefix(std::min(csv.size(), line.size() + 1));
        ++line_number;
        if (line.find_first_not_of(" \t\r") == std::string_view::npos || line[0] == '#') continue;
        const auto cells = cells_of_line(line);
        const auto fail = [&](const std::string& what) {
            throw Error(Fault::failed, name + ":" + std::to_string(line_number), what);
        };
        if (moments.empty() && !headed && !parse_number(cells[0])) {
            headed = true;
            columns = columns_of(cells, fail);
            continue;
        }
        const auto number = [&](std::size_t column, double most) {
            const auto value = column < cells.size() ? parse_number(cells[column]) : std::nullopt;
            if (!value) fail("a line is time_s,x_mm,y_mm, all of them numbers, for example 0.001,12.5,40");
            if (!(std::abs(*value) <= most))
                fail(std::string(cells[column]) + " is beyond " + to_text(most) + "; times are in s and lengths in mm");
            return *value;
        };
        const Moment moment{number(columns.time, kMostTime),
                            {number(columns.x, kMostLength), number(columns.y, kMostLength)},
                            columns.finger ? number(*columns.finger, kMostLength) : 0};
        if (!moments.empty() && moment.time < moments.back().time) fail("time goes back here; sort the lines by their time");
        if (moments.size() == kMostLines) fail("there are over 10 million lines; take fewer at a time");
        moments.push_back(moment);
    }
    if (moments.size() < 2) throw Error(Fault::failed, name, "a way has at least two moments; a line is time_s,x_mm,y_mm");
    const double begin = moments.front().time;
    for (Moment& moment : moments) moment.time -= begin;
    return std::make_unique<Recorded>(lever, finger, begin_height, std::move(moments), columns.finger.has_value());
}

namespace {

double begin_height(const ReliefSurface& surface) { return surface.height({0, surface.map().height() / 2}); }

std::unique_ptr<HapticDevice> open_simulated(const DeviceWish& wish) {
    const HeightMap& map = wish.surface->map();
    return simulated_mouse(wish.machine.lever, wish.machine.on_it(), map.width(), map.height(), begin_height(*wish.surface),
                           wish.speed, wish.seconds);
}

std::unique_ptr<HapticDevice> open_recorded(const DeviceWish& wish) {
    if (wish.where.empty()) throw Error(Fault::usage, spelled("device"), "name the file of the way: recorded:hand.csv");
    std::string csv;
    append_file(csv, wish.where);
    return recorded_mouse(csv, wish.where, wish.machine.lever, wish.machine.on_it(), wish.surface->lowest());
}

}  // namespace

extern const DeviceKind simulated_device;
const DeviceKind simulated_device{
    .name = "simulated", .example = "simulated", .has_hand = true, .ends = true, .open = open_simulated};

extern const DeviceKind recorded_device;
const DeviceKind recorded_device{
    .name = "recorded", .address = "FILE.csv", .example = "recorded:FILE.csv", .open = open_recorded};

}  // namespace tactics
