#include "tactics/haptics/recorder.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

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

bool tells_truth(const std::vector<TickRecord>& records) noexcept {
    return std::any_of(records.begin(), records.end(), [](const TickRecord& one) { return std::isfinite(one.truth.x) && distance(one.truth, one.at) > 0; });
}

std::string csv_of(const std::vector<TickRecord>& records) {
    const auto number = [](double value, double step) { return to_text(std::round(value / step) * step); };
    const bool truth = tells_truth(records);
    std::string text = std::string("time_s,x_mm,y_mm,finger_mm,surface_mm,reference_mm,force_n") + (truth ? ",true_x_mm,true_y_mm" : "") + "\n";
    for (const TickRecord& one : records) {
        text += number(one.time, 1e-6);
        for (const double value : {one.at.x, one.at.y, one.finger, one.surface, one.reference, one.force}) text += "," + number(value, 1e-4);
        if (truth)
            for (const double value : {one.truth.x, one.truth.y}) text += "," + (std::isfinite(value) ? number(value, 1e-4) : "");
        text += "\n";
    }
    return text;
}

}  // namespace tactics
