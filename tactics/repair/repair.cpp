#include "tactics/repair/repair.h"

#include <algorithm>

#include "tactics/repair/means.h"
#include "tactics/rules/rule.h"

namespace tactics {

namespace {

// New ends may come too close to others; each round has fewer. Then what is left is told, not mended.
constexpr int kMostRounds = 12;

// Lines and outlines.
double length_of_all(const Drawing& drawing) {
    double length = total_stroke_length(drawing);
    for (const Area& area : drawing.areas) {
        if (area.texture > 0) continue;  // its outline is among the lines
        for (const auto& ring : area.rings) length += length_of(Stroke{ring, true});
    }
    return length;
}

struct Broken {
    std::size_t places = 0;
    bool complete = true;
};

// The hard rules about lines and areas; a drawing has no margins and no braille.
Broken broken_rules(const Drawing& drawing, const Medium& medium) {
    std::vector<Demand> hard;
    for (const Demand& demand : demands_of(medium))
        if (demand.rule->hard) hard.push_back(demand);
    Broken broken;
    for (const Verdict& verdict : check_page(page_of(drawing, medium), hard)) {
        broken.places += verdict.findings.places.size();
        broken.complete = broken.complete && verdict.findings.complete;
    }
    return broken;
}

void add(Mends& changes, Mends more) { changes.insert(changes.end(), more.begin(), more.end()); }

}  // namespace

Repaired repair(Drawing drawing, const Medium& medium) {
    const double length_before = length_of_all(drawing);
    const Broken before = broken_rules(drawing, medium);
    Repaired repaired{std::move(drawing), {}, before.places, before.places, 1, before.complete};
    Drawing& mended = repaired.drawing;
    Mends& changes = repaired.changes;
    if (before.places > 0) {
        add(changes, join_ends(mended, medium));
        add(changes, lighten(mended, medium));
        add(changes, outline_areas(mended, medium));
        // What no bending would help does not stand in the way of what it helps.
        add(changes, cut_lesser(mended, medium, 2 * kFarthestMove));
        add(changes, move_apart(mended, medium));
    }
    add(changes, break_crossings(mended, medium));
    for (int round = 0; round < kMostRounds; ++round) {
        Mends more = cut_lesser(mended, medium, 0);
        if (more.empty()) break;
        add(changes, std::move(more));
    }
    const double kept = length_before > 0 ? std::min(1.0, length_of_all(mended) / length_before) : 1;
    cut_dashes(mended, medium);
    if (changes.empty() && before.places == 0) return repaired;  // a bend too small for a word is none of the changes
    const Broken after = broken_rules(mended, medium);
    repaired.broken_after = after.places;
    repaired.complete = after.complete;
    repaired.kept = kept;  // gaps between dashes are no loss
    std::stable_sort(changes.begin(), changes.end(),
                     [](const Mend& a, const Mend& b) { return a.at.y < b.at.y || (a.at.y == b.at.y && a.at.x < b.at.x); });
    return repaired;
}

}  // namespace tactics
