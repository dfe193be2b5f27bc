#include "tactics/rules/ink_way.h"

#include <algorithm>

namespace tactics {

namespace {

// In a thicket of lines the way is given up: then the two places count as not joined, and the gap between them is told.
constexpr std::size_t kMostSteps = 100;
constexpr std::size_t kMostWork = 10'000'000;  // contacts looked at, for all questions

constexpr auto kLonger = [](const auto& a, const auto& b) { return a.way > b.way; };

}  // namespace

InkWays::InkWays(const PageGeometry& geometry)
    : geometry_(geometry), ways_(2 * geometry.contacts.size()), asked_(2 * geometry.contacts.size()), work_(kMostWork) {}

bool InkWays::joined_within(const Station& from, const Station& to, double most) {
    if (geometry_.figure_of[from.chain] != geometry_.figure_of[to.chain]) return false;
    const Chain& last = geometry_.chains[to.chain];
    if (from.chain == to.chain && geometry_.way(last, from.along, to.along) <= most) return true;
    ++question_;
    open_.clear();
    const Point goal = geometry_.point_at(to);
    go_on(from, 0, most, goal);
    for (std::size_t steps = 1; !open_.empty() && steps < kMostSteps && !exhausted(); ++steps) {
        std::pop_heap(open_.begin(), open_.end(), kLonger);
        const Step step = open_.back();
        open_.pop_back();
        if (step.way > ways_[2 * step.contact + (step.turned ? 1 : 0)]) continue;  // a shorter one was found since
        const Contact& contact = geometry_.contacts[step.contact];
        const Station& at = step.turned ? contact.one : contact.other;
        if (at.chain == to.chain && step.way + geometry_.way(last, at.along, to.along) <= most) return true;
        go_on(at, step.way, most, goal);
    }
    return false;
}

void InkWays::go_on(const Station& at, double way, double most, Point goal) {
    const Chain& chain = geometry_.chains[at.chain];
    const auto& meetings = geometry_.contacts_of[at.chain];
    const double reach = most - way;
    std::size_t work = 10;
    // Round a closed chain its beginning is also behind its end.
    for (const double lap : {0.0, -chain.length, chain.length}) {
        if (lap != 0 && !chain.closed) continue;
        auto here = std::lower_bound(meetings.begin(), meetings.end(), at.along + lap - reach,
                                     [](const PageGeometry::Meets& m, double along) { return m.along < along; });
        for (; here != meetings.end() && here->along <= at.along + lap + reach; ++here, ++work) {
            const Contact& contact = geometry_.contacts[here->contact];
            const double on = way + geometry_.way(chain, at.along, here->along) + contact.apart;
            // No way is shorter than the straight one.
            if (on - contact.apart + distance(contact.at, goal) - contact.apart > most || on > most) continue;
            const std::size_t side = 2 * here->contact + (here->turned ? 1 : 0);
            if (asked_[side] == question_ && ways_[side] <= on) continue;
            asked_[side] = question_;
            ways_[side] = on;
            open_.push_back({on, here->contact, here->turned});
            std::push_heap(open_.begin(), open_.end(), kLonger);
        }
    }
    work_ -= std::min(work_, work);
}

}  // namespace tactics
