#include "tactics/haptics/recorder.h"

#include <algorithm>
#include <cmath>

#include "tactics/units.h"

namespace tactics {

void Recorder::add(const TickRecord& record) noexcept {
    if (records_.empty()) return;
    records_[added_ % records_.size()] = record;
    ++added_;
}

std::vector<TickRecord> Recorder::records() const {
    if (!lost()) return {records_.begin(), records_.begin() + static_cast<std::ptrdiff_t>(added_)};
    std::vector<TickRecord> all = records_;
    std::rotate(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(added_ % all.size()), all.end());
    return all;
}

std::string csv_of(const std::vector<TickRecord>& records) {
    const auto number = [](double value, double step) { return to_text(std::round(value / step) * step); };
    std::string text = "time_s,x_mm,y_mm,finger_mm,surface_mm,reference_mm,force_n\n";
    for (const TickRecord& one : records)
        text += number(one.time, 1e-6) + "," + number(one.at.x, 1e-4) + "," + number(one.at.y, 1e-4) + "," + number(one.finger, 1e-4) + "," + number(one.surface, 1e-4) +
                "," + number(one.reference, 1e-4) + "," + number(one.force, 1e-4) + "\n";
    return text;
}

}  // namespace tactics
