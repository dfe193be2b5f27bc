// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/scenes/mesh_tree.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace tactics {

// A search says of four boxes which are `wanted`, and how far each is; nearer ones come first. It looks at a leaf, and gives how
// many facets it looked at by themselves. False where the work ran out.
template <typename Search>
bool MeshTree::walk(Search& search, int& work) const noexcept {
    if (nodes_.empty()) return true;
    std::array<std::int32_t, 3 * kMostDepth> later;
    std::size_t count = 0;
    std::int32_t at = 0;
    for (;;) {
        --work;
        unsigned wanted = 0;
        if (at < 0) {
            work -= 4 * search.look(leaves_[static_cast<std::size_t>(-1 - at)]);
        } else {
            const Node& node = nodes_[static_cast<std::size_t>(at)];
            const Four far = search.wanted(node.boxes, wanted);
            if (wanted != 0) {
                auto nearest = static_cast<std::size_t>(std::countr_zero(wanted));
                for (unsigned rest = wanted & (wanted - 1); rest != 0; rest &= rest - 1) {
                    auto lane = static_cast<std::size_t>(std::countr_zero(rest));
                    if (far[lane] < far[nearest]) std::swap(lane, nearest);
                    later[count++] = node.child[lane];
                }
                at = node.child[nearest];
            }
        }
        if (work <= 0) return false;
        if (wanted != 0) continue;
        if (count == 0) return true;
        at = later[--count];
    }
}

template <typename Search>
void MeshTree::look_through(const MeshVicinity& vicinity, Search& search, int& work) const noexcept {
    for (std::size_t four = 0; 4 * four < vicinity.count; ++four) {
        unsigned wanted = 0;
        search.wanted(vicinity.boxes[four], wanted);
        --work;
        for (; wanted != 0; wanted &= wanted - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(wanted));
            work -= 1 + 4 * search.look(leaves_[vicinity.leaf[4 * four + lane]]);
        }
    }
}

namespace {

// A finger on a large mesh waits for memory most of all: what it looks at next is on its way while it looks at others.
template <typename Item>
void fetch_ahead(const Item& item) noexcept {
    constexpr std::size_t kLine = 64;  // bytes
    const char* at = reinterpret_cast<const char*>(&item);
    for (std::size_t byte = 0; byte < sizeof item; byte += kLine) __builtin_prefetch(at + byte);
}

// Squared, for boxes whose places are rounded.
float reach_of(double distance, float slack) noexcept {
    const float reach = static_cast<float>(distance) * (1 + 1e-6f) + 2 * slack;
    return reach * reach;
}

bool is_in(std::span<const std::uint32_t> facets, std::uint32_t facet) noexcept {
    return std::find(facets.begin(), facets.end(), facet) != facets.end();
}

}  // namespace

// What a ball meets first. A way that is short beside the ball is taken as the ball around all of it.
class MeshTree::Meeting {
public:
    Meeting(const MeshTree& tree, const Point3& ball, const Point3& way, double radius, std::span<const std::uint32_t> known,
            double before)
        : hit(),
          tree_(tree),
          ball_(ball),
          way_(way),
          radius_(radius),
          length_(length_of(way)),
          before_(before),
          known_(known),
          wide_(ball, way, static_cast<float>(radius) + 2 * tree.slack_),
          middle_(ball),
          thin_(length_ > 2 * radius) {
        shorten();
    }
    Four wanted(const FourBoxes& boxes, unsigned& lanes) const noexcept {
        if (thin_) {
            FourTold reached;
            const Four enter = entered(boxes, wide_, reached);
            lanes = lanes_of(reached);
            return enter;
        }
        const Four far = squared_distances(boxes, middle_);
        lanes = lanes_of(far <= all_four(reach_));
        return far;
    }
    int look(const FourFacets& leaf) noexcept {
        int looked = 0;
        for (unsigned may = leaf.may_meet(ball_, before_ * way_, radius_); may != 0; may &= may - 1) {
            const std::uint32_t facet = leaf.first + static_cast<std::uint32_t>(std::countr_zero(may));
            if (is_in(known_, facet)) continue;
            ++looked;
            const double share = meeting(tree_.corners(facet), ball_, way_, length_, radius_, before_);
            if (share > before_ || (share == before_ && hit.share <= 1)) continue;
            hit.share = before_ = share;
            hit.facet = facet;
            shorten();
        }
        return looked;
    }
    Hit hit;

private:
    void shorten() noexcept {
        wide_.share = static_cast<float>(before_);
        if (thin_) return;
        middle_ = FourPoints(ball_ + before_ / 2 * way_);
        reach_ = reach_of(radius_ + before_ / 2 * length_, tree_.slack_);
    }
    const MeshTree& tree_;
    const Point3 &ball_, &way_;
    double radius_, length_, before_;
    std::span<const std::uint32_t> known_;
    WideWay wide_;
    FourPoints middle_;
    float reach_ = 0;
    bool thin_;
};

MeshTree::Hit MeshTree::first_met(const Point3& ball, const Point3& way, double radius, std::span<const std::uint32_t> known,
                                  int& work) const noexcept {
    Meeting search(*this, ball, way, radius, known, 1);
    search.hit.gave_up = !walk(search, work);
    return search.hit;
}

MeshTree::Hit MeshTree::first_met(const Point3& ball, const Point3& way, double radius, std::span<const std::uint32_t> known,
                                  double before, const MeshVicinity& vicinity, int& work) const noexcept {
    Meeting search(*this, ball, way, radius, known, before);
    look_through(vicinity, search, work);
    return search.hit;
}

// What is nearest to a place; nothing is said of a facet beyond `least_`. Facets of a vicinity wait until all have been seen and
// the one that seems to be nearest has been looked at: a ball that has come into many of them then looks at few.
class MeshTree::Reaching {
public:
    Reaching(const MeshTree& tree, const Point3& place, double most, std::span<const std::uint32_t> but, bool waits)
        : near(), tree_(tree), place_(place), at_(place), least_(most), but_(but), waits_(waits) {
        set_reach();
    }
    Four wanted(const FourBoxes& boxes, unsigned& lanes) const noexcept {
        const Four far = squared_distances(boxes, at_);
        lanes = lanes_of(far <= all_four(reach_));
        return far;
    }
    int look(const FourFacets& leaf) noexcept {
        int looked = 0;
        const Four bound = leaf.squared_at_least(place_);
        for (unsigned may = lanes_of(bound <= all_four(bound_)); may != 0; may &= may - 1) {
            const auto lane = static_cast<std::uint32_t>(std::countr_zero(may));
            if (is_in(but_, leaf.first + lane)) continue;
            if (waits_ && count_ < waiting_.size()) {
                waiting_[count_++] = {leaf.first + lane, bound[lane]};
            } else if (bound[lane] <= bound_) {
                look_at(leaf.first + lane);
                ++looked;
            }
        }
        return looked;
    }
    int look_at_waiting() noexcept {
        int looked = 0;
        for (std::size_t first = 0; first < count_; ++first) {
            const auto begin = waiting_.begin() + static_cast<std::ptrdiff_t>(first);
            if (first == 0) std::iter_swap(begin, std::min_element(begin, begin + static_cast<std::ptrdiff_t>(count_), nearer));
            if (begin->bound > bound_) continue;
            look_at(begin->facet);
            ++looked;
        }
        return looked;
    }
    Near near;

private:
    struct Waiting {
        std::uint32_t facet;
        float bound;
    };
    static bool nearer(const Waiting& a, const Waiting& b) noexcept { return a.bound < b.bound; }
    void set_reach() noexcept {
        reach_ = reach_of(least_, tree_.slack_);
        bound_ = static_cast<float>(least_ * least_) * (1 + 1e-6f);
    }
    void look_at(std::uint32_t facet) noexcept {
        const double distance = distance_to(tree_.corners(facet), place_, least_);
        if (distance > least_ || distance >= near.distance) return;
        near.distance = least_ = distance;
        near.facet = facet;
        set_reach();
    }
    const MeshTree& tree_;
    const Point3& place_;
    FourPoints at_;
    double least_;
    float reach_ = 0, bound_ = 0;  // squared: of boxes, of facets
    std::span<const std::uint32_t> but_;
    bool waits_;
    std::size_t count_ = 0;
    std::array<Waiting, 32> waiting_;
};

MeshTree::Near MeshTree::nearest(const Point3& place, double most, std::span<const std::uint32_t> but, int& work) const noexcept {
    Reaching search(*this, place, most, but, false);
    search.near.gave_up = !walk(search, work);
    return search.near;
}

MeshTree::Near MeshTree::nearest(const Point3& place, double most, std::span<const std::uint32_t> but,
                                 const MeshVicinity& vicinity, int& work) const noexcept {
    Reaching search(*this, place, most, but, true);
    look_through(vicinity, search, work);
    work -= 4 * search.look_at_waiting();
    return search.near;
}

bool MeshTree::look_around(const Point3& place, double reach, MeshVicinity& vicinity, int& work) const noexcept {
    vicinity.reach = -1;
    vicinity.count = 0;
    vicinity.middle = place;
    const FourPoints at(place);
    const Four most = all_four(reach_of(reach, slack_));
    std::array<std::int32_t, 3 * kMostDepth> later;
    std::size_t count = 0;
    if (!nodes_.empty()) later[count++] = 0;
    while (count > 0) {
        if (--work <= 0) return false;
        const Node& node = nodes_[static_cast<std::size_t>(later[--count])];
        for (unsigned near = lanes_of(squared_distances(node.boxes, at) <= most); near != 0; near &= near - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(near));
            if (node.child[lane] >= 0) {
                later[count++] = node.child[lane];
                fetch_ahead(nodes_[static_cast<std::size_t>(node.child[lane])]);
                continue;
            }
            if (vicinity.count == MeshVicinity::kMost) return false;
            vicinity.boxes[vicinity.count / 4].take(vicinity.count % 4, node.boxes, lane);
            const auto leaf = static_cast<std::uint32_t>(-1 - node.child[lane]);
            vicinity.leaf[vicinity.count++] = leaf;
            fetch_ahead(leaves_[leaf]);
        }
    }
    for (std::size_t i = vicinity.count; i % 4 != 0; ++i) vicinity.boxes[i / 4].take(i % 4, {}, 0);
    vicinity.reach = reach;
    return true;
}

// Seen from above an edge is to the left or to the right of the place, never on it: computed from the same ends in the same order
// for both of its facets, it is the same for both.
class MeshTree::Above {
public:
    Above(const MeshTree& tree, const Point3& place) : tree_(tree), place_(place), at_(place) {}
    Four wanted(const FourBoxes& boxes, unsigned& lanes) const noexcept {
        FourTold over = boxes.high[2] + tree_.slack_ >= at_.at[2];
        for (std::size_t k = 0; k < 2; ++k)
            over &= (boxes.low[k] - tree_.slack_ <= at_.at[k]) & (boxes.high[k] + tree_.slack_ >= at_.at[k]);
        lanes = lanes_of(over);
        return Four{};
    }
    int look(const FourFacets& leaf) noexcept {
        for (std::uint32_t facet = leaf.first; facet < leaf.first + leaf.count; ++facet) count += is_above(facet) ? 1 : 0;
        return static_cast<int>(leaf.count);
    }
    int count = 0;

private:
    bool is_above(std::uint32_t facet) const noexcept {
        const auto& numbers = tree_.facets_.facets[facet];
        int turns = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t one = numbers[k], other = numbers[(k + 1) % 3];
            const Point3 &a = tree_.facets_.corners[std::min(one, other)], &b = tree_.facets_.corners[std::max(one, other)];
            const bool left = (b.x - a.x) * (place_.y - a.y) - (b.y - a.y) * (place_.x - a.x) > 0;
            turns += left == (one < other) ? 1 : -1;
        }
        if (turns != 3 && turns != -3) return false;
        const FacetCorners f = tree_.corners(facet);
        const Point3 over = cross(f.b - f.a, f.c - f.a);
        const double height = dot(over, place_ - f.a);
        return over.z > 0 ? height < 0 : height > 0;
    }
    const MeshTree& tree_;
    const Point3& place_;
    FourPoints at_;
};

int MeshTree::facets_above(const Point3& place, int& work) const noexcept {
    Above search(*this, place);
    walk(search, work);
    return search.count;
}

}  // namespace tactics
