// SPDX-License-Identifier: Apache-2.0
#include "tactics/units.h"

#include <array>

namespace tactics {

std::optional<double> parse_length(std::string_view text) {
    struct Unit {
        std::string_view name;
        double mm;
    };
    static constexpr std::array<Unit, 7> kUnits{
        {{"mm", 1}, {"cm", 10}, {"km", 1e6}, {"m", 1e3}, {"in", kMmPerInch}, {"ft", 12 * kMmPerInch}, {"pt", kMmPerPoint}}};
    for (const auto& unit : kUnits) {
        if (text.size() > unit.name.size() && text.substr(text.size() - unit.name.size()) == unit.name) {
            const auto value = parse_number(text.substr(0, text.size() - unit.name.size()));
            if (!value) return std::nullopt;
            return *value * unit.mm;
        }
    }
    return parse_number(text);
}

}  // namespace tactics
