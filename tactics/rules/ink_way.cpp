// The shortest way from one place to another through ink.
#include <algorithm>
#include <functional>
#include <queue>
#include <utility>

#include "tactics/rules/page_geometry.h"

namespace tactics {

namespace {

// In a thicket of lines the way is given up: then the two places count as not joined, and the gap between them is told.
constexpr std::size_t kMostSteps = 100;

struct Step {
    double way;
    Station at;
    std::uint32_t by;  // the contact that led here
    bool operator>(const Step& other) const { return way > other.way; }
};

}  // namespace

bool PageGeometry::joined_within(const Station& from, const Station& to, double most, std::size_t& budget) const {
    constexpr std::uint32_t kNone = ~std::uint32_t{0};
    if (figure_of[from.chain] != figure_of[to.chain]) return false;
    std::priority_queue<Step, std::vector<Step>, std::greater<>> open;
    std::vector<std::uint32_t> passed;  // contacts
    open.push({0, from, kNone});
    for (std::size_t steps = 0; !open.empty() && steps < kMostSteps; ++steps) {
        const Step step = open.top();
        open.pop();
        if (std::find(passed.begin(), passed.end(), step.by) != passed.end()) continue;
        if (step.by != kNone) passed.push_back(step.by);
        if (step.at.chain == to.chain && step.way + way(chains[to.chain], step.at.along, to.along) <= most) return true;
        const auto& meetings = contacts_of[step.at.chain];
        const std::size_t work = 10 + passed.size() + meetings.size();
        if (budget < work) {
            budget = 0;
            return false;
        }
        budget -= work;
        for (const std::uint32_t index : meetings) {
            const Contact& contact = contacts[index];
            for (const bool turned : {false, true}) {
                const Station &here = turned ? contact.other : contact.one, &there = turned ? contact.one : contact.other;
                if (here.chain != step.at.chain) continue;
                const double on = step.way + way(chains[here.chain], step.at.along, here.along) + contact.apart;
                if (on <= most) open.push({on, there, index});
            }
        }
    }
    return false;
}

}  // namespace tactics
