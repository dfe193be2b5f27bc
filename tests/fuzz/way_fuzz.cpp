// SPDX-License-Identifier: Apache-2.0
// Any bytes as the recorded way of a hand. A second reader, as plain as it can be, says which files are ways and where the hand
// is at each moment; the mouse refuses the others with one line, follows it, and ends with it.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "tactics/error.h"
#include "tactics/haptics/devices/mouse_devices.h"
#include "tactics/text/number.h"

namespace {

using namespace tactics;

void require(bool holds) {
    if (!holds) std::abort();
}

struct Row {
    double time, x, y, finger;
};

std::vector<std::string> cells_of(const std::string& line) {
    std::vector<std::string> cells(1);
    for (const char c : line)
        if (c == ',')
            cells.emplace_back();
        else
            cells.back() += c;
    for (std::string& cell : cells) {
        cell.erase(0, std::min(cell.find_first_not_of(" \t"), cell.size()));
        cell.erase(cell.find_last_not_of(" \t\r") + 1);
    }
    return cells;
}

// Nothing: the file is no way. Times as they stand there.
std::optional<std::vector<Row>> rows_of(std::string text, bool& has_finger) {
    if (text.rfind("\xEF\xBB\xBF", 0) == 0) text.erase(0, 3);
    std::vector<std::string> names{"time_s", "x_mm", "y_mm"};
    std::vector<Row> rows;
    std::istringstream lines(text);
    bool first = true;
    for (std::string line; std::getline(lines, line);) {
        if (line.find_first_not_of(" \t\r") == std::string::npos || line[0] == '#') continue;
        const std::vector<std::string> cells = cells_of(line);
        const bool header = first && !parse_number(cells[0]);
        first = false;
        const auto column = [&](const char* name) { return std::find(names.begin(), names.end(), name) - names.begin(); };
        if (header) {
            names = cells;
            for (const char* name : {"time_s", "x_mm", "y_mm"})
                if (column(name) == std::ssize(names)) return std::nullopt;
            // The height of the finger has two names, of which there may be one.
            if (column("z_mm") < std::ssize(names) && column("finger_mm") < std::ssize(names)) return std::nullopt;
            continue;
        }
        const auto value = [&](const char* name, double most) -> std::optional<double> {
            if (column(name) >= std::ssize(cells)) return std::nullopt;
            const auto found = parse_number(cells[static_cast<std::size_t>(column(name))]);
            return found && std::abs(*found) <= most ? found : std::nullopt;
        };
        const char* const height = column("z_mm") < std::ssize(names) ? "z_mm" : "finger_mm";
        has_finger = column(height) < std::ssize(names);
        const auto time = value("time_s", 1e7), x = value("x_mm", 1e5), y = value("y_mm", 1e5),
                   finger = has_finger ? value(height, 1e5) : std::optional(0.0);
        if (!time || !x || !y || !finger || (!rows.empty() && *time < rows.back().time)) return std::nullopt;
        rows.push_back({*time, *x, *y, *finger});
    }
    if (rows.size() < 2) return std::nullopt;
    return rows;
}

bool close(double a, double b) { return std::abs(a - b) <= 1e-6 * std::max({1.0, std::abs(a), std::abs(b)}); }

// On the straight between the two rows that stand around that time, within both.
void check_place(const HapticSample& sample, const std::vector<Row>& rows, double time, bool has_finger) {
    std::size_t i = 0;
    while (i + 1 < rows.size() && rows[i].time - rows[0].time < time) ++i;
    const Row &a = rows[i == 0 ? 0 : i - 1], &b = rows[i];
    const double from = a.time - rows[0].time, to = b.time - rows[0].time;
    const double share = to > from ? (time - from) / (to - from) : 1;
    require(share >= 0 && share <= 1);
    const auto between = [&](double is, double first, double last) {
        require(is >= std::min(first, last) - 1e-6 && is <= std::max(first, last) + 1e-6);
        require(close(is, first + share * (last - first)));
    };
    between(sample.place.x, a.x, b.x);
    between(sample.place.y, a.y, b.y);
    if (has_finger) between(sample.height, a.finger, b.finger);
    require(std::isfinite(sample.height));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    bool has_finger = false;
    const auto rows = rows_of(text, has_finger);
    std::unique_ptr<HapticDevice> mouse;
    try {
        mouse = recorded_mouse(text, "way.csv", {}, {}, 0);
    } catch (const Error& error) {
        require(!rows && error.what()[0] != '\0');
        return 0;
    }
    require(rows.has_value());
    // To its end in that many steps of different length, and beyond it.
    constexpr int kSteps = 50;
    const double whole = rows->back().time - rows->front().time;
    double time = 0;
    for (int step = 0; step <= 2 * kSteps; ++step) {
        const double dt = step == 0 ? 0 : whole / kSteps * (step % 3 == 0 ? 0.25 : 1.1) + (step > kSteps ? 1e-3 : 0);
        time += dt;
        HapticSample sample;
        const HapticDevice::State state = mouse->read(sample, dt);
        require(state == (time > whole ? HapticDevice::State::over : HapticDevice::State::fine));
        if (state == HapticDevice::State::over) return 0;
        require(sample.knows_place);
        check_place(sample, *rows, time, has_finger);
        mouse->push({0, 0, 0.5});
    }
    require(false);  // it never ended
    return 0;
}
