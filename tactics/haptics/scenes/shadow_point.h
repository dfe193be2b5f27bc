// SPDX-License-Identifier: Apache-2.0
// The point that stays outside of a mesh while the finger goes in: the Shadow Point of the TACTICS paper on haptic graphing
// (section 3.0), "determining which facets the IP would lie on if it could not cross through the surface".
#pragma once

#include <array>
#include <span>

#include "tactics/haptics/scenes/mesh_tree.h"

namespace tactics {

/// Of a finger that is a ball, or a point (which is a ball of kLeastFinger). Its middle goes straight towards the finger as far
/// as air reaches, then along what it touches to where no way near leads nearer: the god-object of C. B. Zilles and J. K.
/// Salisbury (IROS 1995), with a radius as in D. C. Ruspini, K. Kolarov and O. Khatib (SIGGRAPH 1997).
///
/// A facet is convex, so the distance to it is a convex function: on the outer side of the plane through the place that is
/// touched the ball is outside of the facet, however far it goes. The nearest place to the finger that all such planes leave is
/// found exactly, the ball goes there unless another facet is met, which then has its plane, too; and planes are laid anew where
/// it has come to. Each move ends nearer to the finger. Where edges and corners are round for a ball, the move is stretched by
/// their curvature, as Newton's method would.
///
/// On facets much finer than itself a ball would meet a new one every few hundredths of a mm. It rolls over them: it goes on by
/// up to an eighth of its radius, and the next move takes it out of what it has come into. So it may go over what is not a 500th
/// of its radius high (s^2/8r), but an update always ends where it touches and is in nothing.
class ShadowPoint {
public:
    /// The tree must outlive it; radius in mm, 0 or more. `tick_work`: of an update, after which no further move is begun.
    ShadowPoint(const MeshTree& tree, double radius, int tick_work = kTickWork) noexcept;

    /// Where it is for the finger there; once per update. A finger that is not finite changes nothing. Time is bounded: what is
    /// left of the way is gone the next time. First of all it is at the finger, or, where that is in a closed mesh or too near
    /// a facet, comes from straight above.
    Point3 follow(Point3 finger) noexcept;
    bool settled() const noexcept { return settled_; }  ///< no way near leads nearer
    bool arrived() const noexcept { return arrived_; }  ///< it has been settled since the finger was set down
    void lift() noexcept { lifted_ = true; }            ///< the finger was taken off and is set down anew
    double radius() const noexcept { return radius_; }
    int moves() const noexcept { return moves_; }  ///< of the last update
    /// Of the last update: what was looked at as the tree counts it (mesh_tree.h), and moves at kMoveWork. Unlike time it is the
    /// same on any machine, whatever else that does.
    int work() const noexcept { return work_; }

    struct Touching {
        std::uint32_t facet = 0;
        FacetContact contact;
        double pressed = 0;  ///< mm by which it holds the finger off; 0 where it only lies near
    };
    std::span<const Touching> touching() const noexcept { return {touching_.data(), count_}; }

    static constexpr int kMostMoves = 60;
    static constexpr int kMostWork = 30'000;  ///< in an update, at most
    static constexpr int kTickWork = 3'000;   ///< no further move is begun after that
    static constexpr int kMoveWork = 30;      ///< of a move itself, beside what it looks at

private:
    static constexpr std::size_t kMost = 6;  // planes at once; three hold a point
    bool set_down(const Point3& finger, int& work) noexcept;
    void look_again() noexcept;
    void drop(std::size_t number) noexcept;
    void touch(std::uint32_t facet) noexcept;
    bool allowed(const Point3& wish, Point3& way) noexcept;
    bool try_held(const Point3& wish, std::span<const std::size_t> held, Point3& way) noexcept;
    Point3 stretched(const Point3& way) noexcept;
    bool look_around(int& work, bool anew) noexcept;
    MeshTree::Near nearest_now(int& work) noexcept;
    MeshTree::Hit first_met(const Point3& way, std::span<const std::uint32_t> known, int& work) noexcept;
    bool settle_by_rolling(const Point3& goal, int& work) noexcept;
    bool roll(const Point3& way, int& work) noexcept;
    void settle(const Point3& goal, int& work) noexcept;

    const MeshTree* tree_;
    int tick_work_;
    double radius_, keep_, largest_;
    Point3 place_{};
    std::array<Touching, kMost> touching_{};
    std::size_t count_ = 0;
    std::array<std::uint32_t, kMost> twin_{};  // facets that are touched where one of those is, as by a common edge
    std::size_t twins_ = 0;
    MeshVicinity near_;
    double around_;           // mm farther than the ball reaches that is looked around
    Point3 clear_{};          // the last place that the ball had to itself
    int enough_ = 0;          // the work that is left when a tick has had its share
    bool sweeps_ = false;     // as rolling came no farther
    std::uint64_t last_ = 0;  // the edges and corners of the last move
    int long_left_ = 0;
    double stride_ = 1;  // of a way, where the whole was too much work
    int moves_ = 0, work_ = 0;
    bool lifted_ = true, settled_ = true, arrived_ = false;
};

}  // namespace tactics
