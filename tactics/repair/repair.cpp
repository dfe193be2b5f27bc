// SPDX-License-Identifier: Apache-2.0
#include "tactics/repair/repair.h"

#include <algorithm>
#include <memory>

#include "tactics/repair/means.h"

namespace tactics {

namespace {

// New ends may come too close to others, but fewer in each round. Afterwards the rest is reported, not mended.
constexpr int kMostRounds = 40;

// Lines with their gaps that take more than the whole drawing cannot all stay, and looking at them takes long: the least go
// first. (A tenth more: lines along the border have their gap outside.) If even what is left is too much to be looked at, half of
// it is mended.
constexpr double kMostLine = 1.1;

// Lines and outlines.
double length_of_all(const Drawing& drawing) {
    double length = total_stroke_length(drawing);
    for (const Area& area : drawing.areas) {
        if (area.texture > 0) continue;  // its outline is among the lines
        for (const auto& ring : area.rings) length += length_of(Stroke{ring, true});
    }
    return length;
}

// To where the page will have them, so that what is apart here is apart there, too.
void put_on_steps(Drawing& drawing) {
    for (Stroke& stroke : drawing.strokes) stroke.points = on_steps(stroke.points);
    for (Area& area : drawing.areas)
        for (auto& ring : area.rings)
            for (Point& p : ring) p = on_steps(p);
}

// Applies one remedy after another; the analysis of the drawing is kept until a remedy changes it.
class Repairing {
public:
    Repairing(Drawing& drawing, const Medium& medium) : drawing_(drawing), medium_(medium) { put_on_steps(drawing_); }

    // All of the drawing.
    Seen& seen() {
        if (!seen_) seen_ = std::make_unique<Seen>(drawing_, medium_);
        return *seen_;
    }

    // `mean` gets what is seen and gives what it did.
    template <typename Mean>
    bool use(Mean mean) {
        if (!add(mean(seen()))) return false;
        seen_.reset();
        return true;
    }

    bool thin(double times) {
        const bool thinned = add(thin_out(drawing_, medium_, times));
        if (thinned) seen_.reset();
        return thinned;
    }

    // Pairs that bending cannot help must not block those it can. They are a small part of all close pairs; if not all of these
    // are known, they are not searched for.
    void cut_hopeless() {
        constexpr double kHopeless = 2 * kFarthestMove;
        Vicinity all(drawing_.width, drawing_.height);
        if (seen_) {
            use([&](Seen& seen) { return cut_lesser(drawing_, medium_, seen, kHopeless, all); });
            return;
        }
        Seen hopeless(drawing_, medium_, nullptr, kHopeless);
        add(cut_lesser(drawing_, medium_, hopeless, kHopeless, all));
    }

    void bend() {
        if (seen_ && !seen_->near.any_too_close()) return;
        const auto bends = move_apart(drawing_, medium_);
        if (!bends) return;
        add(*bends);
        put_on_steps(drawing_);
        look_again();  // also at what is bent too little for a word
    }

    // Crossings are known without searching for close pairs.
    void break_crossings() {
        const auto mean = [this](const PageGeometry& geometry) { return tactics::break_crossings(drawing_, medium_, geometry); };
        if (seen_) {
            use([&](Seen& seen) { return mean(seen.geometry); });
            return;
        }
        const Page page = page_of(drawing_, medium_);
        add(mean(PageGeometry(page)));
    }

    // Again and again, but for the first time only where the last one has left something else.
    void cut() {
        seen();
        bool all = true;
        for (int round = 0; round < kMostRounds; ++round) {
            Vicinity changed(drawing_.width, drawing_.height);
            if (!add(cut_lesser(drawing_, medium_, *seen_, 0, changed))) break;
            all = !seen_->near.complete();
            seen_ = std::make_unique<Seen>(drawing_, medium_, all ? nullptr : &changed);
        }
        // No line is near anything, here or elsewhere; but areas may be, which no cutting sees to.
        if (!all && !drawing_.areas.empty()) seen_.reset();
    }

    // True: some were.
    bool part_areas() {
        bool parted = !moved_ && use([this](Seen& seen) { return move_areas_apart(drawing_, medium_, seen); });
        moved_ = moved_ || parted;
        const double length = length_of_all(drawing_);
        if (!shrunk_ && use([this](Seen& seen) { return shrink_areas(drawing_, medium_, seen); })) {
            parted = shrunk_ = true;
            shrunk_by_ = length - length_of_all(drawing_);
        }
        int round = 0;
        while (round++ < kMostRounds && use([this](Seen& seen) { return outline_areas(drawing_, seen); })) parted = true;
        return parted;
    }
    // Of lengths, which is no loss.
    double shrunk_by() const { return shrunk_by_; }

    void enlarge_specks() {
        if (add(tactics::enlarge_specks(drawing_, medium_))) seen_.reset();
    }

    void look_again() {
        seen_.reset();
        changed_ = true;
    }
    bool has_changed() const { return changed_; }

    Mends take_changes() {
        std::stable_sort(changes_.begin(), changes_.end(),
                         [](const Mend& a, const Mend& b) { return a.at.y < b.at.y || (a.at.y == b.at.y && a.at.x < b.at.x); });
        return std::move(changes_);
    }

private:
    bool add(const Mends& more) {
        changes_.insert(changes_.end(), more.begin(), more.end());
        if (!more.empty()) put_on_steps(drawing_);
        changed_ = changed_ || !more.empty();
        return !more.empty();
    }

    Drawing& drawing_;
    const Medium& medium_;
    std::unique_ptr<Seen> seen_;
    Mends changes_;
    bool changed_ = false;
    bool moved_ = false, shrunk_ = false;  // areas move once, so that none goes farther than kFarthestMove
    double shrunk_by_ = 0;
};

}  // namespace

Repaired repair(Drawing drawing, const Medium& medium) {
    Repaired repaired{std::move(drawing), {}, 0, 0, 1, true};
    Drawing& mended = repaired.drawing;
    Repairing repairing(mended, medium);
    double length_before = length_of_all(mended);
    const auto finish = [&] {
        repaired.changes = repairing.take_changes();
        const double of = length_before - repairing.shrunk_by();
        repaired.kept = of > 0 ? std::min(1.0, length_of_all(mended) / of) : 1;
    };
    repairing.thin(kMostLine);
    if (!repairing.seen().near.complete()) repairing.thin(kMostLine / 2);
    Broken before = broken_rules(repairing.seen(), medium);
    // Also if it takes too long to tell what is too close.
    if (!repairing.seen().near.complete() && repairing.thin(kMostLine / 2)) before = broken_rules(repairing.seen(), medium);
    repaired.broken_before = repaired.broken_after = before.places;
    if (!repairing.seen().near.complete()) {
        repaired.complete = false;
        finish();
        return repaired;
    }
    repairing.use([&](Seen& seen) { return draw_back_heads(mended, medium, seen); });
    if (before.places > 0) {
        repairing.use([&](Seen& seen) { return join_ends(mended, medium, seen); });
        if (!mended.areas.empty()) {
            if (drop_rims(mended, repairing.seen())) {
                repairing.look_again();
                length_before = length_of_all(mended);
            }
            repairing.use([&](Seen&) { return lighten(mended, medium); });
            repairing.part_areas();
        }
        repairing.cut_hopeless();
        repairing.bend();
    }
    repairing.break_crossings();
    repairing.cut();
    // Lines that joined areas, or stood between them, may be gone.
    for (int round = 0; round < kMostRounds && !mended.areas.empty() && repairing.has_changed() && repairing.part_areas();
         ++round)
        repairing.cut();
    repairing.enlarge_specks();
    finish();  // gaps between dashes are no loss
    if (cut_dashes(mended, medium)) {
        put_on_steps(mended);
        repairing.look_again();
    }
    const Broken after = repairing.has_changed() ? broken_rules(repairing.seen(), medium) : before;
    repaired.broken_after = after.places;
    repaired.complete = after.complete;
    return repaired;
}

}  // namespace tactics
