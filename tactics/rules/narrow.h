// SPDX-License-Identifier: Apache-2.0
// Places where two things are too close, with white between them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "tactics/rules/page_geometry.h"
#include "tactics/rules/rule.h"
#include "tactics/rules/vicinity.h"

namespace tactics {

/// How `apart` is measured: from edge to edge, or between middle lines.
enum class Apart { edges, middles };

/// As the spacing of drawings counts (filters/spacing.cpp): a corner of 29 degrees.
inline constexpr double kBend = 4;

/// The narrowest place between each two lines or areas (or between two parts of one) that are nearer than `limit` and do
/// not touch there. A texture's distance from lines is the rule texture-clearance's; here it counts between middles only, and
/// its own marks never. No gap is
/// - a bend, a corner or a meeting: where the way from one place to the other through ink is at most four times the
///   distance between their middle lines (lines that meet at 29 degrees or more);
/// - what is black between the two, or has a third thing in it.
Findings narrow_places(const PageGeometry& geometry, double limit, Apart apart);

class NarrowSearch;

/// Two pieces that are nearer than the limit.
struct NearPieces {
    std::uint32_t one = 0, other = 0;  ///< pieces
    double measured = 0;
};

/// All that may be narrow places, not just the narrowest between each two things. To tell whether one is takes far longer than to
/// tell that it may be, so each is asked about on its own, and the answer is kept.
class NarrowSuspects {
public:
    /// Those of which one piece has its middle `where`; nullptr: anywhere. The geometry must outlive them.
    NarrowSuspects(const PageGeometry& geometry, double limit, Apart apart, const Vicinity* where = nullptr);
    ~NarrowSuspects();
    NarrowSuspects(NarrowSuspects&&) noexcept;

    const std::vector<NearPieces>& all() const { return all_; }
    bool is_narrow(std::size_t number);
    /// False: there are more, or so much was asked that some answers are not known and count as no.
    bool complete() const;

private:
    const PageGeometry& geometry_;
    Apart apart_;
    std::unique_ptr<NarrowSearch> search_;
    std::vector<NearPieces> all_;
    enum class Told : std::uint8_t { nothing, yes, no };
    std::vector<Told> told_;  ///< of each
    bool complete_;
};

/// Two pieces that are nearer than the limit, where they are nearest.
struct NarrowPair {
    std::uint32_t one = 0, other = 0;  ///< pieces
    double measured = 0;
    Point at, other_at;  ///< on their middle lines
};
struct NarrowPairs {
    std::vector<NarrowPair> pairs;
    std::size_t work = 0;  ///< number of comparisons; unlike time, it is the same for the same page
    bool complete = true;
};

/// Those that are, repeatedly, while lines bend: no point may move farther than `moves` mm from its place in the geometry. Bends,
/// meetings and covered parts are determined once, from the initial state, and do not change. The geometry must outlive it.
class MovingNarrowPairs {
public:
    MovingNarrowPairs(const PageGeometry& geometry, double limit, Apart apart, double moves);
    ~MovingNarrowPairs();
    MovingNarrowPairs(MovingNarrowPairs&&) noexcept;

    /// `now`: current position of each piece of the geometry. If there are more pairs than `most`, only that fact is reported.
    /// `work` counts the comparisons of this call.
    NarrowPairs pairs(std::span<const Segment> now, std::size_t most);

private:
    enum class Told : std::uint8_t { nothing, gap, none };
    struct Suspect {
        std::uint32_t one, other;
        Told told;
    };

    const PageGeometry& geometry_;
    double limit_;
    Apart apart_;
    std::unique_ptr<NarrowSearch> search_;
    std::vector<Suspect> suspects_;  ///< pieces that may come near enough
    bool complete_;
};

/// Pairs that are farther than this from all that was changed are narrow places if they were before: a way through ink that makes
/// a bend of them is no longer than kBend times their distance, and from one of them to its middle it is half of that.
double reach_of_change(const PageGeometry& geometry, double limit);

}  // namespace tactics
