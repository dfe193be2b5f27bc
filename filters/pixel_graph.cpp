// SPDX-License-Identifier: Apache-2.0
#include "filters/pixel_graph.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>
#include <queue>
#include <utility>

#include "tactics/geometry/vectors.h"

namespace tactics {

namespace {

// Which neighbours a line goes on to: those at the sides, and the diagonal ones that no side neighbour leads to. So a
// corner of three pixels is a line and not a triangle, and the stem of a T meets its bar in one pixel.
constexpr auto make_links() {
    std::array<std::uint8_t, 256> links{};
    for (unsigned code = 0; code < 256; ++code) {
        unsigned mask = code & 0x55u;
        for (unsigned diagonal = 1; diagonal < 8; diagonal += 2) {
            const unsigned sides = (1u << (diagonal - 1)) | (1u << ((diagonal + 1) & 7u));
            if (((code >> diagonal) & 1u) != 0 && (code & sides) == 0) mask |= 1u << diagonal;
        }
        links[code] = static_cast<std::uint8_t>(mask);
    }
    return links;
}
constexpr auto kLinks = make_links();

// How many lines meet in a pixel: 2 in the middle of a line.
constexpr auto make_degrees() {
    std::array<std::uint8_t, 256> degrees{};
    for (unsigned code = 0; code < 256; ++code) degrees[code] = static_cast<std::uint8_t>(std::popcount(kLinks[code]));
    return degrees;
}
constexpr auto kDegrees = make_degrees();

constexpr std::uint8_t kSeen = 2;  // a bit that thinning leaves free

constexpr double step_length(unsigned direction) { return (direction & 1u) != 0 ? std::numbers::sqrt2 : 1.0; }

struct Edge {
    int ends[2] = {-1, -1};  // nodes; -1: a loop without any
    std::size_t first = 0;   // its pixels in the pool, without the nodes' own
    std::size_t count = 0;
    double length = 0;
    bool alive = true;
};

// PixelJunction pixels that were joined: their rectangle, and the widest ink among them.
struct Cluster {
    int parent = 0;
    PixelBox box;
    double half_width = 0.5;
    double sum_x = 0, sum_y = 0;
    int pixels = 1;
};

// From the middle of one outermost pixel to that of the other.
double extent_of(const Cluster& cluster) { return std::hypot(cluster.box.width() - 1, cluster.box.height() - 1); }

class Builder {
public:
    Builder(Skeleton& skeleton, double spur) : skeleton_(skeleton), spur_(spur) {}

    PixelGraph build() {
        find_nodes();
        follow_lines();
        join_junctions();
        list_ends();
        drop_small_loops();
        cut_spurs();
        collect();
        return std::move(graph_);
    }

private:
    unsigned code_at(std::uint32_t pixel) const {
        return neighbours_of(skeleton_.map.bytes.data() + pixel, skeleton_.map.stride);
    }
    unsigned links_at(std::uint32_t pixel) const { return kLinks[code_at(pixel)]; }
    int degree_at(std::uint32_t pixel) const { return kDegrees[code_at(pixel)]; }
    std::uint32_t step(std::uint32_t pixel, unsigned direction) const {
        return static_cast<std::uint32_t>(static_cast<std::ptrdiff_t>(pixel) + kSteps[direction].y * skeleton_.map.stride +
                                          kSteps[direction].x);
    }
    Point centre(std::uint32_t pixel) const {
        const int y = skeleton_.y_of(pixel);
        return {static_cast<double>(pixel - static_cast<std::uint32_t>((y + 1) * skeleton_.map.stride)) - 0.5, y + 0.5};
    }

    void find_nodes() {
        row_start_.assign(static_cast<std::size_t>(skeleton_.map.height) + 1, 0);
        for (const std::uint32_t pixel : skeleton_.pixels) {
            const int degree = degree_at(pixel);
            if (degree == 2) continue;
            const int x = skeleton_.x_of(pixel), y = skeleton_.y_of(pixel);
            Cluster cluster{static_cast<int>(nodes_.size()), {x, y, x + 1, y + 1}, 0.5, x + 0.5, y + 0.5, 1};
            if (degree > 2) cluster.half_width = skeleton_.half_width(pixel);
            nodes_.push_back(pixel);
            clusters_.push_back(cluster);
            ++row_start_[static_cast<std::size_t>(y) + 1];
        }
        for (std::size_t y = 1; y < row_start_.size(); ++y) row_start_[y] += row_start_[y - 1];
    }

    // The node at that pixel: nodes are in the order of their pixels.
    int node_at(std::uint32_t pixel) const {
        const auto y = static_cast<std::size_t>(skeleton_.y_of(pixel));
        const auto begin = nodes_.begin() + row_start_[y], end = nodes_.begin() + row_start_[y + 1];
        return static_cast<int>(std::lower_bound(begin, end, pixel) - nodes_.begin());
    }

    // Walks from `from` in that direction until a node, or until `from` comes again.
    Edge follow(int node, std::uint32_t from, unsigned direction) {
        Edge edge;
        edge.ends[0] = node;
        edge.first = pool_.size();
        std::uint32_t at = from;
        for (;;) {
            at = step(at, direction);
            edge.length += step_length(direction);
            const unsigned code = code_at(at);
            if (kDegrees[code] != 2) {
                edge.ends[1] = node_at(at);
                break;
            }
            if (at == from) break;
            pool_.push_back(at);
            const unsigned back = 1u << ((direction + 4) & 7u);
            direction = static_cast<unsigned>(std::countr_zero(kLinks[code] & ~back));
        }
        edge.count = pool_.size() - edge.first;
        return edge;
    }

    bool seen(std::uint32_t pixel) const { return (skeleton_.map.bytes[pixel] & kSeen) != 0; }
    void mark_seen(const Edge& edge) {
        for (std::size_t i = edge.first; i < edge.first + edge.count; ++i) skeleton_.map.bytes[pool_[i]] |= kSeen;
    }

    void follow_lines() {
        for (std::size_t node = 0; node < nodes_.size(); ++node) {
            const unsigned links = links_at(nodes_[node]);
            for (unsigned direction = 0; direction < 8; ++direction) {
                if (((links >> direction) & 1u) == 0) continue;
                const std::uint32_t next = step(nodes_[node], direction);
                // From its other end a line has been walked already.
                if (seen(next) || (degree_at(next) != 2 && next < nodes_[node])) continue;
                edges_.push_back(follow(static_cast<int>(node), nodes_[node], direction));
                mark_seen(edges_.back());
            }
        }
        for (const std::uint32_t pixel : skeleton_.pixels) {
            if (seen(pixel) || degree_at(pixel) != 2) continue;
            edges_.push_back(follow(-1, pixel, static_cast<unsigned>(std::countr_zero(links_at(pixel)))));
            pool_.push_back(pixel);
            ++edges_.back().count;
            mark_seen(edges_.back());
        }
    }

    int cluster_of(int node) {
        while (clusters_[static_cast<std::size_t>(node)].parent != node) {
            auto& parent = clusters_[static_cast<std::size_t>(node)].parent;
            parent = clusters_[static_cast<std::size_t>(parent)].parent;
            node = parent;
        }
        return node;
    }
    Cluster& cluster(int root) { return clusters_[static_cast<std::size_t>(root)]; }

    void join_junctions() {
        std::vector<std::size_t> links;
        for (std::size_t i = 0; i < edges_.size(); ++i) {
            const Edge& edge = edges_[i];
            if (edge.ends[0] < 0 || edge.ends[0] == edge.ends[1]) continue;
            if (degree_at(nodes_[static_cast<std::size_t>(edge.ends[0])]) < 3) continue;
            if (degree_at(nodes_[static_cast<std::size_t>(edge.ends[1])]) < 3) continue;
            const double widths = cluster(edge.ends[0]).half_width + cluster(edge.ends[1]).half_width;
            if (edge.length <= link_limit(widths)) links.push_back(i);
        }
        std::stable_sort(links.begin(), links.end(),
                         [this](std::size_t a, std::size_t b) { return edges_[a].length < edges_[b].length; });
        for (const std::size_t link : links) {
            const int a = cluster_of(edges_[link].ends[0]), b = cluster_of(edges_[link].ends[1]);
            if (a == b) continue;
            const int root = std::min(a, b), other = std::max(a, b);
            Cluster joined = cluster(root);
            const Cluster& more = cluster(other);
            joined.box = around(joined.box, more.box);
            joined.half_width = std::max(joined.half_width, more.half_width);
            joined.sum_x += more.sum_x;
            joined.sum_y += more.sum_y;
            joined.pixels += more.pixels;
            // A junction stays a place: a mesh of short links does not fall together into one.
            if (extent_of(joined) > link_limit(2 * joined.half_width)) continue;
            cluster(other).parent = root;
            cluster(root) = joined;
        }
        for (Edge& edge : edges_) {
            if (edge.ends[0] < 0) continue;
            for (int& end : edge.ends) end = cluster_of(end);
        }
    }

    // Two lines of width w that cross at a right angle meet within w; at 45 degrees within 1.4 w. One pixel for the grid.
    static double link_limit(double widths) { return 1.5 * widths + 1.5; }

    // The ends at each cluster, as 2 * edge + end.
    void list_ends() {
        start_.assign(clusters_.size() + 1, 0);
        for (const Edge& edge : edges_)
            if (edge.ends[0] >= 0)
                for (const int end : edge.ends) ++start_[static_cast<std::size_t>(end) + 1];
        for (std::size_t i = 1; i < start_.size(); ++i) start_[i] += start_[i - 1];
        ends_.resize(start_.empty() ? 0 : start_.back());
        degree_.assign(clusters_.size(), 0);
        for (std::size_t i = 0; i < edges_.size(); ++i) {
            if (edges_[i].ends[0] < 0) continue;
            for (std::size_t end = 0; end < 2; ++end) {
                const auto at = static_cast<std::size_t>(edges_[i].ends[end]);
                ends_[start_[at] + static_cast<std::size_t>(degree_[at]++)] = 2 * i + end;
            }
        }
    }

    void kill(Edge& edge) {
        edge.alive = false;
        for (const int end : edge.ends) --degree_[static_cast<std::size_t>(end)];
    }

    // From the middle line to a corner of the ink it is 1.4 half widths.
    double limit_at(int root) { return std::max(spur_, 1.5 * cluster(root).half_width + 1); }

    // Links within a junction, and eyes so small that they are flaws of the ink.
    void drop_small_loops() {
        for (Edge& edge : edges_)
            if (edge.ends[0] >= 0 && edge.ends[0] == edge.ends[1] && edge.length < 2 * limit_at(edge.ends[0])) kill(edge);
    }

    // The other end of a line at a cluster of degree two, or the only one at degree one.
    std::size_t live_end(int root, std::size_t except) const {
        for (std::size_t i = start_[static_cast<std::size_t>(root)]; i < start_[static_cast<std::size_t>(root) + 1]; ++i)
            if (edges_[ends_[i] / 2].alive && ends_[i] != except) return ends_[i];
        return except;
    }

    // From the line end at `root` to the first junction: its length (no further than `enough`), and where it arrives.
    std::pair<double, int> walk(int root, double enough, std::vector<std::size_t>& path) {
        path.clear();
        double length = 0;
        std::size_t end = live_end(root, static_cast<std::size_t>(-1));
        while (end != static_cast<std::size_t>(-1)) {
            const Edge& edge = edges_[end / 2];
            path.push_back(end / 2);
            length += edge.length;
            const std::size_t arrival = end ^ 1u;
            root = edge.ends[arrival & 1u];
            if (degree_[static_cast<std::size_t>(root)] != 2 || length > enough) return {length, root};
            end = live_end(root, arrival);
        }
        return {length, root};
    }

    Point place(int root) const {
        const Cluster& c = clusters_[static_cast<std::size_t>(root)];
        return {c.sum_x / c.pixels, c.sum_y / c.pixels};
    }

    // One half of a short line across the end of a longer one, as error bars and whiskers have it.
    bool is_half_of_cap(int root, int at, double length) {
        constexpr double kLeast = 1.5;                   // half widths
        constexpr double kStraight = -0.8, kEven = 0.6;  // cosine, where corners of a broad end have 0; of the longer half
        if (degree_[static_cast<std::size_t>(at)] != 3 || length < kLeast * cluster(at).half_width) return false;
        const Point junction = place(at), own = place(root) - junction;
        for (std::size_t i = start_[static_cast<std::size_t>(at)]; i < start_[static_cast<std::size_t>(at) + 1]; ++i) {
            const Edge& edge = edges_[ends_[i] / 2];
            const int other = edge.ends[(ends_[i] ^ 1u) & 1u];
            if (!edge.alive || other == root || degree_[static_cast<std::size_t>(other)] != 1) continue;
            if (std::min(edge.length, length) >= kEven * std::max(edge.length, length) &&
                cosine(own, place(other) - junction) <= kStraight)
                return true;
        }
        return false;
    }

    void cut_spurs() {
        using Spur = std::pair<double, int>;  // length, the cluster at its end
        std::priority_queue<Spur, std::vector<Spur>, std::greater<>> spurs;
        std::vector<std::size_t> path;
        const double longest = std::max(spur_, 2 * 64.0);
        const auto propose = [&](int root) {
            const auto [length, at] = walk(root, longest, path);
            if (degree_[static_cast<std::size_t>(at)] >= 3 && length < limit_at(at)) spurs.emplace(length, root);
        };
        for (std::size_t i = 0; i < clusters_.size(); ++i)
            if (degree_[i] == 1) propose(static_cast<int>(i));
        while (!spurs.empty()) {
            const auto [length, root] = spurs.top();
            spurs.pop();
            const auto [now, at] = walk(root, longest, path);
            if (degree_[static_cast<std::size_t>(at)] < 3 || is_half_of_cap(root, at, now)) continue;
            if (now > length) {
                if (now < limit_at(at)) spurs.emplace(now, root);
                continue;
            }
            for (const std::size_t edge : path) kill(edges_[edge]);
        }
    }

    void collect() {
        std::vector<int> junction(clusters_.size(), -1);
        for (std::size_t i = 0; i < clusters_.size(); ++i) {
            if (degree_[i] < 3) continue;
            junction[i] = static_cast<int>(graph_.junctions.size());
            const Cluster& c = clusters_[i];
            const double extent = extent_of(c) / 2;
            graph_.junctions.push_back({{c.sum_x / c.pixels, c.sum_y / c.pixels}, std::max(extent, c.half_width) + 1});
        }
        std::vector<bool> used(edges_.size(), false);
        for (std::size_t i = 0; i < clusters_.size(); ++i) {
            if (degree_[i] == 2 || degree_[i] == 0) continue;
            for (std::size_t at = start_[i]; at < start_[i + 1]; ++at)
                if (edges_[ends_[at] / 2].alive && !used[ends_[at] / 2]) collect_chain(ends_[at], junction, used);
        }
        for (std::size_t i = 0; i < edges_.size(); ++i)
            if (edges_[i].alive && !used[i]) collect_chain(2 * i, junction, used);
    }

    void collect_chain(std::size_t end, const std::vector<int>& junction, std::vector<bool>& used) {
        PixelChain chain;
        const int begin = edges_[end / 2].ends[end & 1u];
        if (begin >= 0) {
            chain.from = junction[static_cast<std::size_t>(begin)];
            if (degree_[static_cast<std::size_t>(begin)] != 1 && chain.from < 0) chain.closed = true;
            if (chain.from < 0) chain.points.push_back(place(begin));
        } else {
            chain.closed = true;
        }
        for (;;) {
            const Edge& edge = edges_[end / 2];
            used[end / 2] = true;
            chain.points.reserve(chain.points.size() + edge.count + 1);
            for (std::size_t i = 0; i < edge.count; ++i)
                chain.points.push_back(centre(pool_[edge.first + ((end & 1u) == 0 ? i : edge.count - 1 - i)]));
            const std::size_t arrival = end ^ 1u;
            const int root = edge.ends[arrival & 1u];
            if (root < 0 || (chain.closed && root == begin)) break;
            if (degree_[static_cast<std::size_t>(root)] != 2) {
                chain.to = junction[static_cast<std::size_t>(root)];
                if (chain.to < 0) chain.points.push_back(place(root));
                break;
            }
            chain.points.push_back(place(root));
            end = live_end(root, arrival);
        }
        graph_.chains.push_back(std::move(chain));
    }

    Skeleton& skeleton_;
    double spur_;
    std::vector<std::uint32_t> nodes_;  // pixels that are not the middle of a line
    std::vector<std::ptrdiff_t> row_start_;
    std::vector<std::uint32_t> pool_;
    std::vector<Edge> edges_;
    std::vector<Cluster> clusters_;
    std::vector<std::size_t> start_, ends_;
    std::vector<int> degree_;
    PixelGraph graph_;
};

}  // namespace

PixelGraph graph_of(Skeleton& skeleton, double spur) { return Builder(skeleton, spur).build(); }

}  // namespace tactics
