// SPDX-License-Identifier: Apache-2.0
// Which facets are near a ball or in its way: a tree of boxes around them.
#pragma once

#include <limits>
#include <span>

#include "tactics/haptics/scenes/mesh_ball.h"
#include "tactics/haptics/scenes/mesh_facets.h"

namespace tactics {

/// Built once by the surface area heuristic in bins (I. Wald, "On fast construction of SAH-based bounding volume hierarchies",
/// 2007). Queries take no memory; each boils down `work`, a count of boxes and facets looked at, and gives up where it is used
/// up.
class MeshTree {
public:
    explicit MeshTree(MeshFacets facets);

    struct Hit {
        double share = kMeetsNever;  ///< of the way
        std::uint32_t facet = 0;
        bool gave_up = false;  ///< nothing is known
    };
    /// The first facet that a ball meets on its way, without those in `known`.
    Hit first_met(const Point3& ball, const Point3& way, double radius, std::span<const std::uint32_t> known,
                  int& work) const noexcept;
    struct Near {
        double distance = std::numeric_limits<double>::infinity();  ///< mm
        std::uint32_t facet = 0;
        bool gave_up = false;
    };
    /// The facet that is nearest to a place; none where there is none within `most`.
    Near nearest(const Point3& place, double most, std::span<const std::uint32_t> but, int& work) const noexcept;
    /// Leaves (a few facets each) within `reach` of a place, by number: how many there are, or -1 where `leaves` holds fewer or
    /// work ran out.
    int leaves_near(const Point3& place, double reach, std::span<std::uint32_t> leaves, int& work) const noexcept;
    /// As above, of those leaves only.
    Near nearest(const Point3& place, double most, std::span<const std::uint32_t> but, std::span<const std::uint32_t> leaves,
                 int& work) const noexcept;
    /// How many facets lie straight above a place: odd in a closed mesh. A way of its own, exact at edges and corners.
    int facets_above(const Point3& place, int& work) const noexcept;

    FacetCorners corners(std::uint32_t facet) const noexcept {
        const auto& at = facets_.facets[facet];
        return {facets_.corners[at[0]], facets_.corners[at[1]], facets_.corners[at[2]]};
    }
    const MeshFacets& facets() const noexcept { return facets_; }  ///< in the tree's order
    Point3 low() const noexcept { return low_; }                   ///< of the box around all; 0 without facets
    Point3 high() const noexcept { return high_; }

private:
    // Both boxes below it, a little larger than they are; a child is a place in nodes_, or, negative, in leaves_.
    struct Node {
        float low[2][3], high[2][3];
        std::int32_t child[2];
    };
    // Facets that lie together, and the box in their own directions around them: facets that lie aslant fill little of a box
    // along the axes, and a ball that rests on them reaches into many of those.
    struct Leaf {
        float middle[3], over[3], along[3], half[3];  // half the size along `along`, across both, and along `over`
        std::uint32_t first, count;
    };
    struct Builder;
    static constexpr int kMostDepth = 80;

    void look_for_nearest(const Leaf& leaf, const Point3& place, std::span<const std::uint32_t> but, double& least,
                          Near& near) const noexcept;
    Leaf leaf_of(std::uint32_t first, std::uint32_t count) const;
    template <typename Wanted, typename Look>
    bool walk(int& work, Wanted wanted, Look look) const noexcept;

    MeshFacets facets_;
    std::vector<Node> nodes_;
    std::vector<Leaf> leaves_;
    Point3 low_, high_;
    float slack_ = 0;  // what single precision may be wrong by
};

}  // namespace tactics
