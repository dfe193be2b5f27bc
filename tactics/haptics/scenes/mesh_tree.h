// SPDX-License-Identifier: Apache-2.0
// Which facets are near a ball or in its way: a tree of boxes around them.
#pragma once

#include <array>
#include <limits>
#include <span>

#include "tactics/haptics/scenes/four_boxes.h"
#include "tactics/haptics/scenes/mesh_facets.h"

namespace tactics {

/// The leaves (up to four facets each) of a tree that are near a place: what a finger looks through while it stays near.
struct MeshVicinity {
    static constexpr std::size_t kMost = 128;
    Point3 middle;
    double reach = -1;      ///< mm: each facet that is within it is in one of the leaves; negative: nothing is known
    std::size_t count = 0;  ///< leaves
    std::array<FourBoxes, kMost / 4> boxes;
    std::array<std::uint32_t, kMost> leaf;
};

/// Boxes in boxes, four by four, cut by the surface area heuristic in bins (I. Wald, "On fast construction of SAH-based bounding
/// volume hierarchies", 2007; four children as in H. Dammertz, J. Hanika, A. Keller, "Shallow bounding volume hierarchies for
/// fast SIMD ray tracing of incoherent rays", 2008). Queries take no memory; each boils down `work`, a count of what it looks at
/// (four boxes or four facets at once count one, a facet by itself four), and gives up where it is used up.
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
    /// As above, up to a share of the way, of a vicinity that the ball does not leave before.
    Hit first_met(const Point3& ball, const Point3& way, double radius, std::span<const std::uint32_t> known, double before,
                  const MeshVicinity& vicinity, int& work) const noexcept;
    struct Near {
        double distance = std::numeric_limits<double>::infinity();  ///< mm
        std::uint32_t facet = 0;
        bool gave_up = false;
    };
    /// The facet that is nearest to a place, without those in `but`; none where there is none within `most`.
    Near nearest(const Point3& place, double most, std::span<const std::uint32_t> but, int& work) const noexcept;
    /// As above, of a vicinity that reaches as far.
    Near nearest(const Point3& place, double most, std::span<const std::uint32_t> but, const MeshVicinity& vicinity,
                 int& work) const noexcept;
    /// False, and a vicinity of which nothing is known, where it has too many leaves or work ran out.
    bool look_around(const Point3& place, double reach, MeshVicinity& vicinity, int& work) const noexcept;
    /// How many facets lie straight above a place: odd in a closed mesh. A way of its own, exact at edges and corners.
    int facets_above(const Point3& place, int& work) const noexcept;

    FacetCorners corners(std::uint32_t facet) const noexcept {
        const auto& at = facets_.facets[facet];
        return {facets_.corners[at[0]], facets_.corners[at[1]], facets_.corners[at[2]]};
    }
    double grain() const noexcept { return grain_; }               ///< mm: the size of a leaf, most of them
    const MeshFacets& facets() const noexcept { return facets_; }  ///< in the tree's order
    Point3 low() const noexcept { return low_; }                   ///< of the box around all; 0 without facets
    Point3 high() const noexcept { return high_; }

private:
    // A little larger than what is in them; a child is a place in nodes_, or, negative, in leaves_.
    struct alignas(64) Node {
        FourBoxes boxes;
        std::array<std::int32_t, 4> child{};
    };
    struct Builder;
    class Above;
    class Meeting;
    class Reaching;
    static constexpr int kMostDepth = 64;  // of the tree of two children that it is made from

    template <typename Search>
    bool walk(Search& search, int& work) const noexcept;
    template <typename Search>
    void look_through(const MeshVicinity& vicinity, Search& search, int& work) const noexcept;

    MeshFacets facets_;
    std::vector<Node> nodes_;
    std::vector<FourFacets> leaves_;
    Point3 low_, high_;
    double grain_ = 0;
    float slack_ = 0;  // what single precision may be wrong by
};

}  // namespace tactics
