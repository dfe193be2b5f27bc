// SPDX-License-Identifier: Apache-2.0
// Things that are too close in a drawing, for all of repair.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tactics/page.h"
#include "tactics/rules/narrow.h"
#include "tactics/rules/page_geometry.h"
#include "tactics/rules/vicinity.h"

namespace tactics {

/// The drawing's lines and areas as the rules see them, in the drawing's own millimetres. Strokes and areas keep their numbers.
Page page_of(const Drawing& drawing, const Medium& medium);

/// Two pieces that should stand farther from each other.
struct NearPair {
    std::uint32_t one = 0, other = 0;  ///< pieces of the geometry
    Point at, other_at;                ///< where they are nearest, on their middle lines
    double lacks = 0;                  ///< mm
};

/// Pairs that break the hard rules for distances of that medium unless ink joins or covers them, which takes longest to tell: ask
/// about no more of them than must be known.
class NearSuspects {
public:
    /// Those that lack more than `lacks`, `where` or anywhere. The geometry must outlive them.
    NearSuspects(const PageGeometry& geometry, const Medium& medium, double lacks = 0, const Vicinity* where = nullptr);

    struct Suspect {
        std::uint32_t one, other;  ///< pieces of the geometry
        double lacks;              ///< mm
        double white;              ///< mm from edge to edge
    };
    std::size_t size() const { return begins_.back(); }
    /// Where those of each rule begin; at last `size()`.
    const std::vector<std::size_t>& begins() const { return begins_; }
    Suspect operator[](std::size_t number) const;
    NearPair pair(std::size_t number) const;
    /// Remembers the answer.
    bool is_too_close(std::size_t number);
    bool any_too_close();
    /// False: there are more, or so much was asked that some answers are not known and count as no.
    bool complete() const;

private:
    struct ByRule {
        double limit;
        Apart apart;
        NarrowSuspects suspects;
    };
    std::size_t rule_of(std::size_t number) const { return rules_.size() > 1 && number >= begins_[1] ? 1 : 0; }

    const PageGeometry& geometry_;
    std::vector<ByRule> rules_;
    std::vector<std::size_t> begins_;
};

struct NearPairs {
    std::vector<NearPair> pairs;
    std::size_t work = 0;  ///< number of comparisons
    bool complete = true;
};

/// Pairs that are too close while lines bend, at most `moves` mm from their place in the geometry, which must outlive it.
class MovingNearPairs {
public:
    MovingNearPairs(const PageGeometry& geometry, const Medium& medium, double lacks, double moves);

    /// `now`: current position of each piece of the geometry. If there are more than `most`, not all are reported.
    NearPairs pairs(std::span<const Segment> now, std::size_t most);

private:
    struct ByRule {
        double limit;
        Apart apart;
        MovingNarrowPairs moving;
    };
    std::vector<ByRule> rules_;
};

/// The distance from a change within which such pairs may appear or vanish.
double reach_of_change(const PageGeometry& geometry, const Medium& medium);

/// A drawing as the rules see it; it stays where it is. Looked at once for all who ask before it is changed.
struct Seen {
    /// With `where` only what is near there; of what is too close only that which lacks more than `lacks` mm.
    Seen(const Drawing& drawing, const Medium& medium, const Vicinity* where = nullptr, double lacks = 0);
    Seen(const Seen&) = delete;
    Seen& operator=(const Seen&) = delete;

    const Page page;
    const PageGeometry geometry;
    NearSuspects near;
};

/// Places that break a hard rule about lines and areas, as check_page counts them.
struct Broken {
    std::size_t places = 0;
    bool complete = true;
};
Broken broken_rules(Seen& seen, const Medium& medium);

/// The worth of each chain of the geometry: of two that are too close, the one of greater worth stays. Areas come before lines,
/// then the wider line, then the one with more evidence. All are different.
std::vector<std::size_t> worth_of(const PageGeometry& geometry, const Drawing& drawing);

}  // namespace tactics
