// SPDX-License-Identifier: Apache-2.0
#include "tactics/layout/lead_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_set>
#include <utility>

#include "tactics/geometry/box.h"

namespace tactics {

namespace {

// Lead lines: 3/4 to 1 1/2 in, the least line there is, no arrowhead (GSTG 3.4.3.5, second-hand; medium confidence).
constexpr double kLongestLead = 38;  // mm
constexpr std::size_t kMostLeads =
    500;  // places examined, the best first; they include all those straight above, below and beside
constexpr std::size_t kMostLeadsOfPage =
    500'000;                         // for all of its names: where 200 found none, thousands more are not looked for in vain
constexpr double kShortestLead = 3;  // mm; own choice: anything shorter is a dot
constexpr double kCrossing = 15;     // mm of a lead line: it is worth so much to cross one line less; own choice
constexpr std::size_t kMostCompared = 30;  // lead lines across lines, to one end

// It keeps `gap` from the words, like all lines: closer, it could be mistaken for a dot (rules/braille_clearance.cpp).
Lead lead_of(const Rect& place, Point thing, double gap) {
    const Point near = nearest_of(place, thing);
    const double far = distance(near, thing);
    const double begin = std::min(1.0, gap / std::max(far, 1e-9));
    return {{near.x + begin * (thing.x - near.x), near.y + begin * (thing.y - near.y)}, thing};
}

// Where a lead line begins.
using Beginning = std::pair<double, double>;
struct BeginningHash {
    std::size_t operator()(const Beginning& at) const {
        return std::hash<double>()(at.first) * 1'000'003 + std::hash<double>()(at.second);
    }
};

}  // namespace

bool Led::is_good() const { return cost <= 2 * kCrossing; }

LeadSearch::LeadSearch(const Page& page, const Medium& medium) : medium_(medium), leads_(page, medium.thin_line, medium.gap) {}

// From the middle of a lead line to words; files round to hundredths, at both.
double LeadSearch::gap() const { return clear_of_braille(medium_) + medium_.thin_line / 2 + 0.02; }

bool LeadSearch::is_open(const Lead& lead, Way way) const {
    const double length = distance(lead.from, lead.to);
    return length <= kLongestLead && length >= kShortestLead && !meets_words(lead) &&
           leads_.is_clear(lead, way != Way::open, way == Way::anyhow);
}

std::optional<Led> LeadSearch::led_to(const Room& room, double width, double height, Point end, Way way,
                                      const std::function<bool(const Rect&)>& accept) {
    // Many places share a lead line: words above a thing may stand farther left or right.
    std::unordered_set<Beginning, BeginningHash> known;
    std::optional<Led> best;
    std::size_t compared = 0;
    const auto takes = [&](const Rect& rect) {
        if (!accept(rect) || known.size() >= kMostLeads || tried_ >= kMostLeadsOfPage) return false;
        const Lead lead = lead_of(rect, end, gap());
        if (!known.insert({lead.from.x, lead.from.y}).second) return false;
        ++tried_;
        if (!is_open(lead, way)) return false;
        const double crossed = way != Way::open ? static_cast<double>(leads_.crossings(lead)) : 0;
        const double cost = distance(lead.from, lead.to) + kCrossing * crossed;
        if (!best || cost < best->cost) best = {rect, lead, cost};
        return way == Way::open || best->is_good() || ++compared >= kMostCompared;
    };
    if (tried_ < kMostLeadsOfPage) room.nearest(end, width, height, kLongestLead + gap(), takes);
    return best;
}

// A line beside other words seems to belong to them.
bool LeadSearch::meets_words(const Lead& lead) const {
    constexpr double kStep = 0.25;  // mm
    const int steps = 1 + static_cast<int>(distance(lead.from, lead.to) / kStep);
    const double least = gap() - 1e-6;
    const Box around = grown(box_of(std::array{lead.from, lead.to}), gap());
    return std::any_of(words_.begin(), words_.end(), [&](const Rect& words) {
        if (!meet(around, box_of(words))) return false;
        for (int i = 0; i <= steps; ++i) {
            const double t = static_cast<double>(i) / steps;
            const Point p{lead.from.x + t * (lead.to.x - lead.from.x), lead.from.y + t * (lead.to.y - lead.from.y)};
            if (distance(nearest_of(words, p), p) < least) return true;
        }
        return false;
    });
}

}  // namespace tactics
