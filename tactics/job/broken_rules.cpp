// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/broken_rules.h"

#include "tactics/rules/rule.h"

namespace tactics {

std::vector<BrokenRule> broken_hard_rules(const std::vector<Page>& pages, const Medium& medium) {
    std::vector<Demand> demands = demands_of(medium);
    std::erase_if(demands, [](const Demand& demand) { return !demand.rule->hard; });
    std::vector<BrokenRule> broken;
    for (const Demand& demand : demands) broken.push_back({demand.rule->name});
    for (const Page& page : pages) {
        const std::vector<Verdict> verdicts = check_page(page, demands);
        for (std::size_t i = 0; i < verdicts.size(); ++i) broken[i].places += verdicts[i].findings.places.size();
    }
    std::erase_if(broken, [](const BrokenRule& rule) { return rule.places == 0; });
    return broken;
}

}  // namespace tactics
