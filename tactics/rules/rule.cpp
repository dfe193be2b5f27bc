// SPDX-License-Identifier: Apache-2.0
#include "tactics/rules/rule.h"

#include <algorithm>
#include <cmath>

#include "tactics/rules/page_geometry.h"
#include "tactics/units.h"

namespace tactics {

#define RULE(name) extern const Rule name##_rule;
#include "tactics/rules/list.inc"
#undef RULE

Phrase shown(double measure) { return numeral(std::round(measure * 100) / 100); }

std::span<const Rule* const> rules() {
    static const Rule* const kRules[] = {
#define RULE(name) &name##_rule,
#include "tactics/rules/list.inc"
#undef RULE
    };
    return kRules;
}

const Rule* find_rule(std::string_view name) {
    for (const Rule* rule : rules())
        if (rule->name == name) return rule;
    return nullptr;
}

std::optional<double> limit_of(const Rule& rule, const Medium& medium) {
    return rule.limit_for == nullptr ? rule.limit.fallback : rule.limit_for(medium);
}

std::vector<Demand> demands_of(const Medium& medium) {
    std::vector<Demand> demands;
    for (const Rule* rule : rules())
        if (const auto limit = limit_of(*rule, medium)) demands.push_back({rule, *limit});
    return demands;
}

std::vector<Verdict> check_page(const Page& page, std::span<const Demand> demands) {
    const PageGeometry geometry(page);
    std::vector<Verdict> verdicts;
    for (const Demand& demand : demands) {
        verdicts.push_back({demand, demand.rule->check(geometry, demand.limit)});
        Findings& findings = verdicts.back().findings;
        std::stable_sort(findings.places.begin(), findings.places.end(), [](const Finding& a, const Finding& b) {
            return a.at.y < b.at.y || (a.at.y == b.at.y && a.at.x < b.at.x);
        });
        if (findings.places.size() > kMostPlaces) {
            findings.places.resize(kMostPlaces);
            findings.complete = false;
        }
    }
    return verdicts;
}

}  // namespace tactics
