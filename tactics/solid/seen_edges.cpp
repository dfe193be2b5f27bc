// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/seen_edges.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "tactics/geometry/grid.h"
#include "tactics/solid/flat_shape.h"

namespace tactics {

namespace {

constexpr double kCrease = 0.4;                 // radians
constexpr double kEdgeOn = 1e-6;                // cosine
constexpr std::size_t kMostLooks = 60'000'000;  // at sides of patches, about a second
constexpr double kAside = 20;                   // times `touching`: where is looked for what lies beside an edge

// A patch that hides.
struct Screen {
    FlatShape shape;
    Point3 normal;
    double off = 0;  // of its plane, along the normal
    double toward(Point at, const ViewPlane& view) const {
        return (off - at.x * dot(normal, view.right) - at.y * dot(normal, view.down)) / dot(normal, view.toward);
    }
};

struct Edge {
    Point3 from, to;
    bool crease = false;
};

// What of a ring's side no seam covers.
void add_open_sides(std::vector<Edge>& edges, const Patch& patch, const std::vector<const Seam*>& seams, double touching) {
    for (const auto& ring : patch.rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point3 &a = ring[i], &b = ring[(i + 1) % ring.size()];
            const Point3 along = b - a;
            const double square = dot(along, along);
            if (!(square > 0)) continue;
            std::vector<std::pair<double, double>> covered;
            for (const Seam* seam : seams) {
                const auto share = [&](const Point3& at) { return dot(at - a, along) / square; };
                const auto off = [&](const Point3& at) { return length_of(at - a - share(at) * along); };
                if (off(seam->from) > 20 * touching || off(seam->to) > 20 * touching) continue;
                const auto [from, to] = std::minmax({share(seam->from), share(seam->to)});
                covered.emplace_back(from, to);
            }
            std::sort(covered.begin(), covered.end());
            double begin = 0;
            const auto add = [&](double from, double to) {
                if ((to - from) * std::sqrt(square) > 20 * touching) edges.push_back({a + from * along, a + to * along, false});
            };
            for (const auto& [from, to] : covered) {
                add(begin, std::min(from, 1.0));
                begin = std::max(begin, to);
            }
            add(begin, 1);
        }
}

std::vector<Edge> edges_of(const Solid& solid, const Point3& toward, double touching) {
    std::vector<Edge> edges;
    const auto faces = [&](std::uint32_t patch) { return dot(solid.patches[patch].normal, toward) > kEdgeOn; };
    const auto is_edge_on = [&](std::uint32_t patch) { return std::abs(dot(solid.patches[patch].normal, toward)) <= kEdgeOn; };
    std::vector<std::vector<const Seam*>> seams(solid.closed ? 0 : solid.patches.size());
    for (const Seam& seam : solid.seams) {
        if (!solid.closed)
            for (const std::uint32_t patch : {seam.one, seam.other}) seams[patch].push_back(&seam);
        const bool one = faces(seam.one), other = faces(seam.other);
        if (solid.closed && !one && !other) continue;
        const bool outline = one != other || is_edge_on(seam.one) || is_edge_on(seam.other);
        if (outline || std::abs(seam.bend) > kCrease) edges.push_back({seam.from, seam.to, !outline});
    }
    for (std::size_t i = 0; i < seams.size(); ++i) add_open_sides(edges, solid.patches[i], seams[i], touching);
    return edges;
}

class Seeing {
public:
    Seeing(const std::vector<ModelPart>& parts, const ViewPlane& view, double touching)
        : parts_(parts), view_(view), touching_(touching) {
        Box all = kNothing;
        for (const ModelPart& part : parts)
            for (const Patch& patch : part.solid.patches) {
                const double facing = dot(patch.normal, view.toward);
                if (facing <= kEdgeOn && (part.solid.closed || facing >= -kEdgeOn)) continue;
                std::vector<std::vector<Point>> rings;
                for (const auto& ring : patch.rings) {
                    rings.emplace_back();
                    for (const Point3& at : ring) rings.back().push_back(flat_place(at, view));
                }
                screens_.push_back({flat_shape(std::move(rings)), patch.normal, dot(patch.normal, patch.rings.front().front())});
                all.take({screens_.back().shape.box.left, screens_.back().shape.box.top});
                all.take({screens_.back().shape.box.right, screens_.back().shape.box.bottom});
            }
        origin_ = screens_.empty() ? Point{} : Point{all.left, all.top};
        std::vector<Box> boxes;
        for (const Screen& screen : screens_) boxes.push_back(in_grid(screen.shape.box));
        if (!boxes.empty()) grid_ = Grid(std::move(boxes), all.width(), all.height());
    }

    SeenEdges run() {
        SeenEdges seen;
        std::vector<std::uint32_t> order(parts_.size());
        std::iota(order.begin(), order.end(), 0u);
        std::stable_sort(order.begin(), order.end(),
                         [&](std::uint32_t a, std::uint32_t b) { return extent_of(parts_[a]) > extent_of(parts_[b]); });
        for (const std::uint32_t part : order)
            for (const Edge& edge : edges_of(parts_[part].solid, view_.toward, touching_)) {
                if (looks_ > kMostLooks) {
                    seen.complete = false;
                    return seen;
                }
                look(edge, part, seen);
            }
        return seen;
    }

private:
    Box in_grid(const Box& box) const {
        return {box.left - origin_.x, box.top - origin_.y, box.right - origin_.x, box.bottom - origin_.y};
    }

    std::vector<std::size_t> screens_near(const Box& box) const {
        std::vector<std::size_t> near;
        if (screens_.empty()) return near;
        grid_.any_near(in_grid(box), [&](std::size_t i) {
            near.push_back(i);
            return false;
        });
        std::sort(near.begin(), near.end());
        near.erase(std::unique(near.begin(), near.end()), near.end());
        return near;
    }

    void look(const Edge& edge, std::uint32_t part, SeenEdges& seen) {
        const Point from = flat_place(edge.from, view_), to = flat_place(edge.to, view_);
        const double length = distance(from, to), low = dot(edge.from, view_.toward), high = dot(edge.to, view_.toward);
        if (!(length > touching_)) return;
        Box box = kNothing;
        box.take(from);
        box.take(to);
        const std::vector<std::size_t> near = screens_near(grown(box, (kAside + 1) * touching_));
        const std::vector<double> cuts = cuts_of(from, to, low, high, near);
        for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
            if ((cuts[i + 1] - cuts[i]) * length <= touching_) continue;
            const auto at = [&](double t) { return Point{from.x + t * (to.x - from.x), from.y + t * (to.y - from.y)}; };
            const double middle = (cuts[i] + cuts[i + 1]) / 2;
            // Behind the line where two patches meet it is hidden by both; along the border of one it is not.
            const double toward = low + middle * (high - low);
            const Point there = at(middle);
            const auto aside = [&](double by) {
                return Point{there.x - by * touching_ * (to.y - from.y) / length,
                             there.y + by * touching_ * (to.x - from.x) / length};
            };
            if (is_hidden(aside(2), toward, near) && is_hidden(aside(-2), toward, near)) continue;
            const bool outer = !edge.crease && (is_empty(aside(kAside), near) || is_empty(aside(-kAside), near));
            seen.edges.push_back({at(cuts[i]), at(cuts[i + 1]),
                                  edge.crease ? LineClass::thin
                                  : outer     ? LineClass::thick
                                              : LineClass::normal,
                                  false});
            seen.part.push_back(part);
        }
    }

    // Where what is before or behind the edge changes.
    std::vector<double> cuts_of(Point from, Point to, double low, double high, const std::vector<std::size_t>& near) {
        std::vector<double> cuts = {0, 1};
        const double dx = to.x - from.x, dy = to.y - from.y, length = std::hypot(dx, dy);
        for (const std::size_t i : near) {
            const Screen& screen = screens_[i];
            for (const auto& ring : screen.shape.rings) {
                looks_ += ring.size();
                for (std::size_t k = 0; k < ring.size(); ++k) {
                    const Point &a = ring[k], &b = ring[(k + 1) % ring.size()];
                    const double ex = b.x - a.x, ey = b.y - a.y, both = dx * ey - dy * ex;
                    if (std::abs(both) < 1e-12 * length * std::hypot(ex, ey)) continue;
                    const double t = ((a.x - from.x) * ey - (a.y - from.y) * ex) / both;
                    const double s = ((a.x - from.x) * dy - (a.y - from.y) * dx) / both;
                    if (t > 0 && t < 1 && s >= -1e-9 && s <= 1 + 1e-9) cuts.push_back(t);
                }
            }
            const double before = screen.toward(from, view_) - low, after = screen.toward(to, view_) - high;
            if ((before < 0) != (after < 0) && before != after) cuts.push_back(before / (before - after));
        }
        std::sort(cuts.begin(), cuts.end());
        return cuts;
    }

    bool is_hidden(Point at, double toward, const std::vector<std::size_t>& near) {
        return std::any_of(near.begin(), near.end(), [&](std::size_t i) {
            const Screen& screen = screens_[i];
            if (!screen.shape.box.holds(at) || screen.toward(at, view_) <= toward + 20 * touching_) return false;
            for (const auto& ring : screen.shape.rings) looks_ += ring.size();
            return holds(screen.shape, at);
        });
    }

    bool is_empty(Point at, const std::vector<std::size_t>& near) {
        return std::none_of(near.begin(), near.end(), [&](std::size_t i) {
            const Screen& screen = screens_[i];
            if (!screen.shape.box.holds(at)) return false;
            for (const auto& ring : screen.shape.rings) looks_ += ring.size();
            return holds(screen.shape, at);
        });
    }

    const std::vector<ModelPart>& parts_;
    const ViewPlane& view_;
    double touching_;
    std::vector<Screen> screens_;
    Point origin_;
    Grid grid_;
    std::size_t looks_ = 0;
};

}  // namespace

SeenEdges seen_edges(const std::vector<ModelPart>& parts, const ViewPlane& view, double touching) {
    return Seeing(parts, view, touching).run();
}

std::vector<DrawnSide> cut_sides(const ModelPart& part, const ViewPlane& view, double at) {
    std::vector<DrawnSide> sides;
    for (const Patch& patch : part.solid.patches) {
        // Points in the plane count as in front of it, so that every ring crosses it an even number of times.
        const Point3 along = cross(patch.normal, view.toward);
        std::vector<std::pair<double, Point3>> places;
        for (const auto& ring : patch.rings)
            for (std::size_t i = 0; i < ring.size(); ++i) {
                const Point3 &a = ring[i], &b = ring[(i + 1) % ring.size()];
                const double before = dot(a, view.toward) - at, after = dot(b, view.toward) - at;
                if ((before >= 0) == (after >= 0)) continue;
                const Point3 place = a + before / (before - after) * (b - a);
                places.emplace_back(dot(place, along), place);
            }
        std::sort(places.begin(), places.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
        for (std::size_t i = 0; i + 1 < places.size(); i += 2)
            sides.push_back({flat_place(places[i].second, view), flat_place(places[i + 1].second, view)});
    }
    return sides;
}

}  // namespace tactics
