// SPDX-License-Identifier: Apache-2.0
#include "filters/chart_axis.h"

#include <algorithm>
#include <utility>

#include "filters/date_ticks.h"
#include "tactics/units.h"

namespace tactics {

AxisTicks axis_ticks(const Axis& axis, const AxisExtent& extent, int most) {
    if (axis.dates) {
        DateTicks dates = date_ticks(extent.low, extent.high, most);
        return {std::move(dates.ticks), std::move(dates.words), std::move(dates.since)};
    }
    AxisTicks all{ticks_for(extent.low, extent.high, axis.logarithmic, most), {}};
    for (const double tick : all.ticks.at) all.words.push_back(number_text(axis, tick));
    return all;
}

std::string number_text(const Axis& axis, double value) {
    std::string text = to_text(value);
    if (axis.comma) std::replace(text.begin(), text.end(), '.', ',');
    return text;
}

AxisTicks axis_ends(const Axis& axis, const AxisExtent& extent) {
    if (axis.dates) {
        DateTicks dates = date_ends(extent.low, extent.high);
        return {std::move(dates.ticks), std::move(dates.words), std::move(dates.since)};
    }
    AxisTicks ends = axis_ticks(axis, extent, kFewestTicks);
    ends.ticks.at = {ends.ticks.at.front(), ends.ticks.at.back()};
    ends.words = {ends.words.front(), ends.words.back()};
    return ends;
}

void AxisScale::keep_ends() {
    ticks_.ticks.at = {ticks_.ticks.at.front(), ticks_.ticks.at.back()};
    ticks_.words = {ticks_.words.front(), ticks_.words.back()};
    before_.resize(2);
}

std::string told_value(const Axis& axis, double value) {
    if (axis.dates) return axis.name + (axis.name.empty() ? "" : " = ") + date_text(value);
    std::string name = axis.name, unit;
    const auto bracket = name.rfind(" (");
    const auto comma = name.rfind(", ");
    if (bracket != std::string::npos && name.back() == ')') {
        unit = " " + name.substr(bracket + 2, name.size() - bracket - 3);
        name.erase(bracket);
    } else if (comma != std::string::npos) {
        unit = " " + name.substr(comma + 2);
        name.erase(comma);
    }
    return name + (name.empty() ? "" : " = ") + number_text(axis, value) + unit;
}

}  // namespace tactics
