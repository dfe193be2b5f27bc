// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/scenes/enough_mesh.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "tactics/text/number.h"

namespace tactics {

namespace {

constexpr std::size_t kMostAround = 16;  // facets around a corner; more are left as they are
constexpr double kUpright = 0.5;         // cosine: a new facet may lean that far from those that were there
// So far beyond those of the original facets the normal of a new one may be, along each axis. However near to the surface, a
// narrow facet may stand upright on it, and a point would catch there as at a wall.
constexpr float kBeyond = 0.1f;
constexpr int kMostPasses = 40;

struct Flat {
    double x, y, height;  // along the mean direction
};

double turn(const Flat& a, const Flat& b, const Flat& c) noexcept {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// The distance of two edges where they cross, seen from above; 0 if they do not.
double apart(const Flat& a, const Flat& b, const Flat& c, const Flat& d) noexcept {
    const double one = turn(a, b, c), other = turn(a, b, d);
    if ((one > 0) == (other > 0)) return 0;
    const double first = turn(c, d, a), second = turn(c, d, b);
    if ((first > 0) == (second > 0)) return 0;
    const double on_ab = first / (first - second), on_cd = one / (one - other);
    return std::abs(a.height + on_ab * (b.height - a.height) - c.height - on_cd * (d.height - c.height));
}

// The box around unit normals. Boxes of boxes grow no larger than what is in them, as cones would.
struct Normals {
    std::array<float, 3> low{1, 1, 1}, high{-1, -1, -1};
    void take(const Normals& more) noexcept {
        for (std::size_t k = 0; k < 3; ++k) {
            low[k] = std::min(low[k], more.low[k]);
            high[k] = std::max(high[k], more.high[k]);
        }
    }
    bool allow(const Normals& one) const noexcept {
        bool within = true;
        for (std::size_t k = 0; k < 3; ++k) within = within && one.low[k] >= low[k] - kBeyond && one.high[k] <= high[k] + kBeyond;
        return within;
    }
};

Normals normal_of(const Point3& over, double length) noexcept {
    const std::array<float, 3> at{static_cast<float>(over.x / length), static_cast<float>(over.y / length),
                                  static_cast<float>(over.z / length)};
    return {at, at};
}

// The corners around one, in the order in which its facets have them; from above they go round to the left.
struct Ring {
    std::array<std::uint32_t, kMostAround> corner;
    std::array<Flat, kMostAround> flat;
    std::size_t count = 0;
    Flat middle{};
    Point3 over;
    double error = 0;  // of its facets
    Normals original;  // of the facets that its facets stand for
    std::size_t after(std::size_t k) const noexcept { return k + 1 == count ? 0 : k + 1; }
    std::size_t before(std::size_t k) const noexcept { return k == 0 ? count - 1 : k - 1; }
};

class Thinning {
public:
    explicit Thinning(MeshFacets& mesh) : mesh_(mesh), error_(mesh.facets.size()) {
        original_.reserve(mesh.facets.size());
        for (const auto& facet : mesh.facets) {
            const Point3& a = mesh.corners[facet[0]];
            const Point3 over = cross(mesh.corners[facet[1]] - a, mesh.corners[facet[2]] - a);
            original_.push_back(normal_of(over, length_of(over)));
        }
    }

    // One corner after another, none beside one that has changed already. How many are gone.
    std::size_t pass(double most) {
        sort_around();
        changed_.assign(mesh_.facets.size(), false);
        std::size_t gone = 0;
        for (std::uint32_t corner = 0; corner < mesh_.corners.size(); ++corner) gone += draw_in(corner, most) ? 1 : 0;
        std::size_t kept = 0;
        for (std::size_t i = 0; i < mesh_.facets.size(); ++i) {
            if (mesh_.facets[i][0] == kGone) continue;
            mesh_.facets[kept] = mesh_.facets[i];
            original_[kept] = original_[i];
            error_[kept++] = error_[i];
        }
        mesh_.facets.resize(kept);
        original_.resize(kept);
        error_.resize(kept);
        return gone;
    }
    double error() const { return error_.empty() ? 0 : *std::max_element(error_.begin(), error_.end()); }

private:
    static constexpr std::uint32_t kGone = UINT32_MAX;

    void sort_around() {
        start_.assign(mesh_.corners.size() + 1, 0);
        for (const auto& facet : mesh_.facets)
            for (const std::uint32_t corner : facet) ++start_[corner + 1];
        for (std::size_t i = 1; i < start_.size(); ++i) start_[i] += start_[i - 1];
        around_.resize(3 * mesh_.facets.size());
        std::vector<std::uint32_t> next(start_.begin(), start_.end() - 1);
        for (std::uint32_t i = 0; i < mesh_.facets.size(); ++i)
            for (const std::uint32_t corner : mesh_.facets[i]) around_[next[corner]++] = i;
    }

    std::span<const std::uint32_t> around(std::uint32_t corner) const {
        return std::span(around_).subspan(start_[corner], start_[corner + 1] - start_[corner]);
    }
    bool untouched(std::uint32_t corner) const {
        const auto facets = around(corner);
        return std::none_of(facets.begin(), facets.end(), [&](std::uint32_t facet) { return changed_[facet]; });
    }

    // Nothing where the facets do not go round the corner once, or hang over.
    std::optional<Ring> ring_of(std::uint32_t corner) const {
        const auto facets = around(corner);
        if (facets.size() < 3 || facets.size() > kMostAround || !untouched(corner)) return {};
        Ring ring;
        std::array<std::array<std::uint32_t, 2>, kMostAround> side{};
        for (const std::uint32_t number : facets) {
            const auto& facet = mesh_.facets[number];
            const std::size_t at = facet[0] == corner ? 0 : facet[1] == corner ? 1 : 2;
            side[ring.count++] = {facet[(at + 1) % 3], facet[(at + 2) % 3]};
            const Point3& a = mesh_.corners[facet[0]];
            ring.over = ring.over + cross(mesh_.corners[facet[1]] - a, mesh_.corners[facet[2]] - a);
            ring.error = std::max(ring.error, error_[number]);
            ring.original.take(original_[number]);
        }
        ring.corner[0] = side[0][0];
        std::uint32_t last = side[0][1];
        for (std::size_t k = 1; k < ring.count; ++k) {
            ring.corner[k] = last;
            const auto begin = side.begin() + 1, end = side.begin() + static_cast<std::ptrdiff_t>(ring.count);
            const auto found = std::find_if(begin, end, [&](const auto& one) { return one[0] == last; });
            if (found == end || std::find(ring.corner.begin(), ring.corner.begin() + static_cast<std::ptrdiff_t>(k), last) !=
                                    ring.corner.begin() + static_cast<std::ptrdiff_t>(k))
                return {};
            last = (*found)[1];
        }
        if (last != ring.corner[0] || !flatten(ring, corner)) return {};
        return ring;
    }

    bool flatten(Ring& ring, std::uint32_t corner) const {
        const double length = length_of(ring.over);
        if (!(length > 0)) return false;
        ring.over = (1 / length) * ring.over;
        const Point3 least = std::abs(ring.over.x) < 0.6 ? Point3{1, 0, 0} : Point3{0, 1, 0};
        Point3 right = cross(least, ring.over);
        right = (1 / length_of(right)) * right;
        const Point3 up = cross(ring.over, right), &middle = mesh_.corners[corner];
        for (std::size_t k = 0; k < ring.count; ++k) {
            const Point3 off = mesh_.corners[ring.corner[k]] - middle;
            ring.flat[k] = {dot(off, right), dot(off, up), dot(off, ring.over)};
        }
        for (std::size_t k = 0; k < ring.count; ++k)
            if (!(turn(ring.middle, ring.flat[k], ring.flat[ring.after(k)]) > 0)) return false;
        return true;
    }

    // The most that the facets around move along the mean direction if their corner is drawn into that one; infinite where they
    // would lie over one another, lean too far, or tie the mesh in a knot.
    double moved(const Ring& ring, std::size_t into) const {
        const Flat& to = ring.flat[into];
        double most = 0;
        bool covers = false;
        for (std::size_t k = ring.after(into); k != ring.before(into); k = ring.after(k)) {
            const Flat &a = ring.flat[k], &b = ring.flat[ring.after(k)];
            const double area = turn(to, a, b);
            if (!(area > 0)) return INFINITY;
            const Point3& at = mesh_.corners[ring.corner[into]];
            const Point3 over = cross(mesh_.corners[ring.corner[k]] - at, mesh_.corners[ring.corner[ring.after(k)]] - at);
            const double length = length_of(over);
            if (dot(over, ring.over) < kUpright * length || !ring.original.allow(normal_of(over, length))) return INFINITY;
            const double of_to = turn(ring.middle, a, b), of_a = turn(ring.middle, b, to), of_b = turn(ring.middle, to, a);
            if (of_to >= 0 && of_a >= 0 && of_b >= 0) {
                covers = true;
                most = std::max(most, std::abs(of_to * to.height + of_a * a.height + of_b * b.height) / area);
            }
            if (k == ring.after(into)) continue;  // the edge to it is one of the ring's
            for (std::size_t spoke = 0; spoke < ring.count; ++spoke)
                if (spoke != into && spoke != k) most = std::max(most, apart(ring.middle, ring.flat[spoke], to, a));
        }
        return covers ? most : INFINITY;
    }

    // Whether that one of the ring hangs together with others of it than the two beside it.
    bool knotted(const Ring& ring, std::size_t into) const {
        const auto begin = ring.corner.begin(), end = begin + static_cast<std::ptrdiff_t>(ring.count);
        for (const std::uint32_t number : around(ring.corner[into])) {
            std::size_t shared = 0;
            for (const std::uint32_t corner : mesh_.facets[number]) {
                const auto found = std::find(begin, end, corner);
                if (found == end || corner == ring.corner[into]) continue;
                const auto at = static_cast<std::size_t>(found - begin);
                if (at != ring.after(into) && at != ring.before(into)) return true;
                ++shared;
            }
            if (shared == 2) return true;
        }
        return false;
    }

    bool draw_in(std::uint32_t corner, double most) {
        const std::optional<Ring> ring = ring_of(corner);
        if (!ring || !(ring->error < most)) return false;
        std::size_t best = ring->count;
        double least = most - ring->error;
        for (std::size_t k = 0; k < ring->count; ++k) {
            const double far = moved(*ring, k);
            if (!(far < least) || !untouched(ring->corner[k]) || knotted(*ring, k)) continue;
            least = far;
            best = k;
        }
        if (best == ring->count) return false;
        for (const std::uint32_t number : around(corner)) {
            auto& facet = mesh_.facets[number];
            changed_[number] = true;
            error_[number] = ring->error + least;
            original_[number] = ring->original;
            if (std::find(facet.begin(), facet.end(), ring->corner[best]) != facet.end())
                facet[0] = kGone;
            else
                std::replace(facet.begin(), facet.end(), corner, ring->corner[best]);
        }
        return true;
    }

    MeshFacets& mesh_;
    std::vector<double> error_;                  // of each facet
    std::vector<Normals> original_;              // of each facet: of those that it stands for
    std::vector<std::uint32_t> start_, around_;  // the facets around each corner
    std::vector<bool> changed_;
};

void drop_unused_corners(MeshFacets& mesh) {
    constexpr std::uint32_t kUnused = UINT32_MAX;
    std::vector<std::uint32_t> place(mesh.corners.size(), kUnused);
    std::vector<Point3> corners;
    for (auto& facet : mesh.facets)
        for (std::uint32_t& corner : facet) {
            if (place[corner] == kUnused) {
                place[corner] = static_cast<std::uint32_t>(corners.size());
                corners.push_back(mesh.corners[corner]);
            }
            corner = place[corner];
        }
    mesh.corners = std::move(corners);
}

}  // namespace

EnoughMesh enough_facets(MeshFacets facets, double tolerance) {
    EnoughMesh enough;
    enough.of_all = facets.facets.size();
    Thinning thinning(facets);
    // Steps that move the surface least come first, because bounds add up.
    double most = tolerance / 8;
    for (int pass = 0; pass < kMostPasses; ++pass) {
        const std::size_t before = facets.facets.size(), gone = thinning.pass(most);
        if (gone * 50 > before) continue;
        if (most >= tolerance) break;
        most = std::min(2 * most, tolerance);
    }
    enough.error = thinning.error();
    drop_unused_corners(facets);
    enough.facets = std::move(facets);
    const std::size_t kept = enough.facets.facets.size();
    if (kept < enough.of_all)
        enough.words = phrase(
            "{0} of {1} facets are enough for a device that tells {2} mm: no place of its surface is further off than {3} mm",
            std::to_string(kept), std::to_string(enough.of_all), numeral(tolerance),
            numeral(std::ceil(enough.error * 1e4) / 1e4));
    else
        enough.words =
            phrase("all {0} facets are kept: fewer would be further off than {1} mm", std::to_string(kept), numeral(tolerance));
    return enough;
}

}  // namespace tactics
