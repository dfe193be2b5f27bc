// SPDX-License-Identifier: Apache-2.0
// The shortest way from one place to another through ink.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "tactics/rules/page_geometry.h"

namespace tactics {

/// Asks many times, so it keeps its memory. The geometry must stay.
class InkWays {
public:
    explicit InkWays(const PageGeometry& geometry);

    /// Whether the distance from one place to the other through ink, along middle lines, is at most `most`. One path is the part
    /// of the chain between them; others lead through contacts. If the work limit is reached (`exhausted`), the answer is no.
    bool joined_within(const Station& from, const Station& to, double most);

    /// True: an earlier search between these lines already showed it. Call it first, because it needs no search.
    bool known_within(const Station& from, const Station& to, double most);

    /// False: these two pieces are too far from all contacts for a path that short. Call it before joined_within, which takes
    /// longer.
    bool may_join(std::size_t piece, std::size_t other, double most) const;

    /// True: the two chains touch, and the way through one of their contacts is that short. Needs no search at all.
    bool touch_within(const Station& from, const Station& to, double most) const;

    /// Whether the work limit was reached.
    bool exhausted() const { return left_ == 0; }
    std::size_t work() const { return kMostWork - left_; }  ///< contacts visited so far

private:
    struct Step {
        double way;
        double departs;  ///< where the way leaves its first chain
        std::uint32_t contact;
        bool turned;  ///< at the place of its `one`, having come from `other`
    };
    struct Been {
        Station at;
        double way;
    };
    /// A way that was found, from where it leaves the first chain to where it comes to the last.
    struct Known {
        std::size_t first = kNone, last = kNone;  ///< chains
        double departs = 0, arrives = 0, between = 0;
        static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
    };
    /// From there to there it is more than `most`.
    struct Denied {
        Station from{Known::kNone}, to{Known::kNone};
        double most = 0;
        bool excludes(const PageGeometry& geometry, const Station& one, const Station& other, double way) const;
    };
    struct Goal {
        Station from, at;
        double most;  ///< mm
    };
    /// The place of a contact on the goal's chain.
    struct Gate {
        Point at;
        double way;  ///< mm along the chain to the goal
    };
    Known& known(const Station& from, const Station& to);
    Denied& denied(const Station& from, const Station& to);
    void find_gates(const Station& goal);
    /// No way is shorter than the straight one to a gate and on from there: is that no more than `left`?
    bool may_reach(Point from, double left) const;
    bool is_detour(const Station& at, double way) const;
    bool is_beside_last(const Station& there, double way);
    /// Takes up the contacts that can be reached from here. True: the goal was reached through one of them.
    bool go_on(const Station& at, const Step* by, const Goal& goal);

    const PageGeometry& geometry_;
    void find_contacts_of_pieces();
    void find_touching();

    /// Two chains, the first of lower number, and one of their contacts, as places along them.
    struct Touching {
        std::uint32_t first = 0, last = 0;  ///< the same: there is none
        double departs = 0, arrives = 0, between = 0;
    };
    std::size_t touching_at(std::size_t first, std::size_t last) const {
        return (first * 0x9e3779b97f4a7c15 + last * 0xc2b2ae3d27d4eb4f) >> touching_shift_;
    }
    std::vector<Touching> touching_;  // by their chains; one takes the place of another
    int touching_shift_ = 0;
    std::vector<double> to_contact_;  // from each piece to the nearest contact of its chain, mm along it
    std::vector<Step> open_;          // a heap, the shortest way on top
    std::vector<Been> been_;          // where the ways led on from
    std::array<Been, 8> lately_;      // what the contacts of the place that is left led to, by chain
    std::vector<Gate> gates_;         // of the goal: the nearest to both sides
    std::vector<Known> known_;
    std::vector<Denied> denied_;
    std::vector<double> ways_;          // the shortest known way to each side of each contact
    std::vector<std::uint32_t> asked_;  // the question that it belongs to
    std::uint32_t question_ = 0;
    static constexpr std::size_t kMostWork = 10'000'000;
    std::size_t left_ = kMostWork;
};

}  // namespace tactics
