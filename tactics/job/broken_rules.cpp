// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/broken_rules.h"

#include "tactics/rules/rule.h"

namespace tactics {

std::vector<BrokenRule> rules_broken_by(const std::vector<Page>& pages, const Medium& medium) {
    const std::vector<Demand> demands = demands_of(medium);
    std::vector<BrokenRule> broken;
    for (const Demand& demand : demands) broken.push_back({demand.rule->name, demand.rule->hard});
    for (const Page& page : pages) {
        const std::vector<Verdict> verdicts = check_page(page, demands);
        for (std::size_t i = 0; i < verdicts.size(); ++i) {
            broken[i].places += verdicts[i].findings.places.size();
            broken[i].complete = broken[i].complete && verdicts[i].findings.complete;
        }
    }
    std::erase_if(broken, [](const BrokenRule& rule) { return rule.places == 0 && rule.complete; });
    return broken;
}

}  // namespace tactics
