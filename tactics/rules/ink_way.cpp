// SPDX-License-Identifier: Apache-2.0
#include "tactics/rules/ink_way.h"

#include <algorithm>
#include <iterator>

namespace tactics {

namespace {

// In a dense group of lines the search is abandoned: the two places count as not joined, and the gap between them is reported.
constexpr std::size_t kMostSteps = 1000;

// Ways are sums of many lengths; a rounded one may be shorter than the straight way by so much.
constexpr double kStraight = 1e-9;

// Ways that are kept, by their chains; one takes the place of another.
constexpr std::size_t kMostKnown = 1024;

// Number of negative results cached, by the queried places, rounded to this many mm.
constexpr std::size_t kMostDenied = 2048;
constexpr double kBeside = 4;

constexpr auto kLonger = [](const auto& a, const auto& b) { return a.way > b.way; };

}  // namespace

InkWays::InkWays(const PageGeometry& geometry)
    : geometry_(geometry),
      known_(kMostKnown),
      denied_(kMostDenied),
      ways_(2 * geometry.contacts.size()),
      asked_(2 * geometry.contacts.size()) {
    find_contacts_of_pieces();
    find_touching();
}

void InkWays::find_contacts_of_pieces() {
    to_contact_.assign(geometry_.pieces.size(), kNowhere);
    for (std::size_t c = 0; c < geometry_.chains.size(); ++c) {
        const Chain& chain = geometry_.chains[c];
        const auto& meetings = geometry_.contacts_of[c];
        if (meetings.empty()) continue;
        std::size_t next = 0;  // contact at or after the beginning of a piece
        for (std::size_t i = chain.first; i < chain.first + chain.count; ++i) {
            const Piece& piece = geometry_.pieces[i];
            const double end = piece.along + distance(piece.line.a, piece.line.b);
            while (next < meetings.size() && meetings[next].along < piece.along) ++next;
            // Round a closed chain its last contact is also before its beginning, and its first behind its end.
            const double lap = chain.closed ? chain.length : kNowhere;
            const double before = next > 0 ? meetings[next - 1].along : meetings.back().along - lap;
            const double behind = next < meetings.size() ? meetings[next].along : meetings.front().along + lap;
            to_contact_[i] = std::max(0.0, std::min(piece.along - before, behind - end));
        }
    }
}

void InkWays::find_touching() {
    constexpr int kLeast = 6, kMost = 16;  // powers of two
    int size = kLeast;
    while (size < kMost && (std::size_t{1} << size) < geometry_.contacts.size()) ++size;
    touching_.resize(std::size_t{1} << size);
    touching_shift_ = 64 - size;
    for (const Contact& contact : geometry_.contacts) {
        const bool turned = contact.one.chain > contact.other.chain;
        const Station &one = turned ? contact.other : contact.one, &other = turned ? contact.one : contact.other;
        touching_[touching_at(one.chain, other.chain)] = {static_cast<std::uint32_t>(one.chain),
                                                          static_cast<std::uint32_t>(other.chain), one.along, other.along,
                                                          contact.apart};
    }
}

bool InkWays::touch_within(const Station& from, const Station& to, double most) const {
    const bool turned = from.chain > to.chain;
    const Station &one = turned ? to : from, &other = turned ? from : to;
    const Touching& touching = touching_[touching_at(one.chain, other.chain)];
    if (touching.first != one.chain || touching.last != other.chain || touching.first == touching.last) return false;
    return geometry_.way(geometry_.chains[one.chain], one.along, touching.departs) + touching.between +
               geometry_.way(geometry_.chains[other.chain], touching.arrives, other.along) <=
           most;
}

bool InkWays::may_join(std::size_t piece, std::size_t other, double most) const {
    return to_contact_[piece] + to_contact_[other] <= most + kStraight;
}

bool InkWays::known_within(const Station& from, const Station& to, double most) {
    const Chain& last = geometry_.chains[to.chain];
    if (from.chain == to.chain && geometry_.way(last, from.along, to.along) <= most) return true;
    // Queries for one place are usually followed by queries for its neighbours.
    const Known& before = known(from, to);
    if (before.first != from.chain || before.last != to.chain) return false;
    const double on = geometry_.way(geometry_.chains[from.chain], from.along, before.departs);
    return on + before.between + geometry_.way(last, before.arrives, to.along) <= most;
}

bool InkWays::joined_within(const Station& from, const Station& to, double most) {
    if (geometry_.figure_of[from.chain] != geometry_.figure_of[to.chain]) return false;
    if (known_within(from, to, most)) return true;
    if (exhausted()) return false;
    Denied& no = denied(from, to);
    if (no.excludes(geometry_, from, to, most)) return false;
    ++question_;
    open_.clear();
    been_.clear();
    const Goal goal{from, to, most};
    find_gates(to);
    if (go_on(from, nullptr, goal)) return true;
    while (!open_.empty() && been_.size() < kMostSteps && !exhausted()) {
        std::pop_heap(open_.begin(), open_.end(), kLonger);
        const Step step = open_.back();
        open_.pop_back();
        if (step.way > ways_[2 * step.contact + (step.turned ? 1 : 0)]) continue;  // a shorter one was found since
        const Contact& contact = geometry_.contacts[step.contact];
        const Station& at = step.turned ? contact.one : contact.other;
        if (!is_detour(at, step.way) && go_on(at, &step, goal)) return true;
    }
    if (open_.empty()) no = {from, to, most};
    return false;
}

InkWays::Denied& InkWays::denied(const Station& from, const Station& to) {
    const auto place = [](const Station& station) {
        return station.chain * 1'000'003 + static_cast<std::size_t>(std::max(0.0, station.along) / kBeside);
    };
    return denied_[(place(from) * 31 + place(to)) % kMostDenied];
}

// From the one place to the other it is no less than from those beside them, less the ways to those.
bool InkWays::Denied::excludes(const PageGeometry& geometry, const Station& one, const Station& other, double way) const {
    return one.chain == from.chain && other.chain == to.chain &&
           way + geometry.way(geometry.chains[from.chain], from.along, one.along) +
                   geometry.way(geometry.chains[to.chain], to.along, other.along) <=
               most;
}

InkWays::Known& InkWays::known(const Station& from, const Station& to) {
    return known_[(from.chain * 31 + to.chain) % kMostKnown];
}

// Every path to the goal from another chain comes through a contact, and past the nearest one on that side. Round a closed chain
// its last contact is also before its beginning, and its first behind its end.
void InkWays::find_gates(const Station& goal) {
    gates_.clear();
    const Chain& chain = geometry_.chains[goal.chain];
    const auto& meetings = geometry_.contacts_of[goal.chain];
    if (meetings.empty()) return;
    const auto add = [&](double along) {
        gates_.push_back({geometry_.point_at({goal.chain, along}), geometry_.way(chain, along, goal.along)});
    };
    const auto behind = std::lower_bound(meetings.begin(), meetings.end(), goal.along,
                                         [](const PageGeometry::Meets& m, double along) { return m.along < along; });
    if (behind != meetings.end() || chain.closed) add(behind != meetings.end() ? behind->along : meetings.front().along);
    if (behind != meetings.begin() || chain.closed)
        add(behind != meetings.begin() ? std::prev(behind)->along : meetings.back().along);
}

bool InkWays::may_reach(Point from, double left) const {
    for (const Gate& gate : gates_) {
        const double straight = left - gate.way, dx = from.x - gate.at.x, dy = from.y - gate.at.y;
        if (straight >= 0 && dx * dx + dy * dy <= straight * straight) return true;
    }
    return false;
}

// Along the same chain from a place where a way has been it is no farther: nothing new comes of it. Lines that touch do so in
// many pieces side by side.
bool InkWays::is_detour(const Station& at, double way) const {
    return std::any_of(been_.begin(), been_.end(), [&](const Been& been) {
        return been.at.chain == at.chain &&
               been.way + geometry_.way(geometry_.chains[at.chain], been.at.along, at.along) <= way + kStraight;
    });
}

// Lines that meet touch in many pieces side by side: what one of these contacts leads to, those farther on do, too.
bool InkWays::is_beside_last(const Station& there, double way) {
    Been& last = lately_[there.chain % lately_.size()];
    if (last.at.chain == there.chain &&
        last.way + geometry_.way(geometry_.chains[there.chain], last.at.along, there.along) <= way + kStraight)
        return true;
    last = {there, way};
    return false;
}

bool InkWays::go_on(const Station& at, const Step* by, const Goal& goal) {
    const Chain& chain = geometry_.chains[at.chain];
    const auto& meetings = geometry_.contacts_of[at.chain];
    const double way = by == nullptr ? 0 : by->way, most = goal.most, reach = most - way;
    been_.push_back({at, way});
    lately_.fill({{Known::kNone}, 0});
    std::size_t work = 10;
    const auto take = [&](const PageGeometry::Meets& here) {
        ++work;
        const Contact& contact = geometry_.contacts[here.contact];
        const double on = way + geometry_.way(chain, at.along, here.along) + contact.apart;
        if (on > most) return false;
        const Station& there = here.turned ? contact.one : contact.other;
        if (is_beside_last(there, on)) return false;
        // It is measured from the place of `one`.
        if (!may_reach(contact.at, most - (here.turned ? on : on - contact.apart) + kStraight)) return false;
        const std::size_t side = 2 * here.contact + (here.turned ? 1 : 0);
        if (asked_[side] == question_ && ways_[side] <= on) return false;
        asked_[side] = question_;
        ways_[side] = on;
        const double departs = by == nullptr ? here.along : by->departs;
        if (!is_detour(there, on)) {
            open_.push_back({on, departs, here.contact, here.turned});
            std::push_heap(open_.begin(), open_.end(), kLonger);
        }
        if (there.chain != goal.at.chain) return false;
        if (on + geometry_.way(geometry_.chains[there.chain], there.along, goal.at.along) > most) return false;
        known(goal.from, goal.at) = {goal.from.chain, goal.at.chain, departs, there.along,
                                     on - geometry_.way(geometry_.chains[goal.from.chain], goal.from.along, departs)};
        return true;
    };
    bool reached = false;
    // On a closed chain its beginning also follows its end.
    for (const double lap : {0.0, -chain.length, chain.length}) {
        if (lap != 0 && !chain.closed) continue;
        const double from = at.along + lap;
        const auto middle = std::lower_bound(meetings.begin(), meetings.end(), from,
                                             [](const PageGeometry::Meets& m, double along) { return m.along < along; });
        // The nearest first, to both sides: most ways lead through one of them.
        auto on = middle, back = middle;
        while (!reached) {
            const double ahead = on != meetings.end() ? on->along - from : reach + 1;
            const double behind = back != meetings.begin() ? from - std::prev(back)->along : reach + 1;
            if (std::min(ahead, behind) > reach) break;
            reached = take(ahead < behind ? *on++ : *--back);
        }
    }
    left_ -= std::min(left_, work);
    return reached;
}

}  // namespace tactics
