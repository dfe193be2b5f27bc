// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/loop/recorder.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "tactics/units.h"

namespace tactics {

void Recorder::add(const TickRecord& record) noexcept {
    if (records_.empty()) return;
    const std::size_t index = added_.load(std::memory_order_relaxed);
    records_[index % records_.size()] = record;
    added_.store(index + 1, std::memory_order_release);
}

std::vector<TickRecord> Recorder::records() const {
    const std::size_t count = added();
    if (!lost()) return {records_.begin(), records_.begin() + static_cast<std::ptrdiff_t>(count)};
    std::vector<TickRecord> all = records_;
    std::rotate(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count % all.size()), all.end());
    return all;
}

std::string csv_header(const TickColumns& columns) {
    return std::string("time_s,x_mm,y_mm,finger_mm,surface_mm,reference_mm,force_n") +
           (columns.truth ? ",true_x_mm,true_y_mm" : "") + (columns.spatial ? ",force_x_n,force_y_n" : "") + "\n";
}

void add_csv(std::string& text, const TickRecord& one, const TickColumns& columns) {
    const auto number = [](double value, double step) { return to_text(std::round(value / step) * step); };
    text += number(one.time, 1e-6);
    for (const double value : {one.at.x, one.at.y, one.finger, one.surface, one.reference, one.force.z})
        text += "," + number(value, 1e-4);
    if (columns.truth)
        for (const double value : {one.truth.x, one.truth.y}) text += "," + (std::isfinite(value) ? number(value, 1e-4) : "");
    if (columns.spatial)
        for (const double value : {one.force.x, one.force.y}) text += "," + number(value, 1e-4);
    text += "\n";
}

}  // namespace tactics
