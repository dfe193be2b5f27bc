// SPDX-License-Identifier: Apache-2.0
#include "filters/region_merging.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <queue>

#include "filters/opencv.h"

namespace tactics {

namespace {

constexpr double kFullStrength = 255;

// Half the chi-squared distance of two histograms, each as shares of its area: 0 alike, 1 with nothing in common.
template <std::size_t N>
double unlike(const std::array<float, N>& a, double area_a, const std::array<float, N>& b, double area_b) {
    double sum = 0;
    for (std::size_t i = 0; i < N; ++i) {
        const double p = a[i] / area_a, q = b[i] / area_b;
        if (p + q > 0) sum += (p - q) * (p - q) / (p + q);
    }
    return sum / 2;
}

// Into the two bins beside it, so that a shade that lies between two of them does not fall to one by chance.
template <std::size_t N>
void count_soft(std::array<float, N>& bins, double at) {
    const double inside = std::clamp(at, 0.0, static_cast<double>(N - 1));
    const auto below = std::min(static_cast<std::size_t>(inside), N - 2);
    const auto share = static_cast<float>(inside - static_cast<double>(below));
    bins[below] += 1 - share;
    bins[below + 1] += share;
}

// How much lightness varies around each pixel: the deviation in a small window, on a scale where twice as rough is one more.
std::vector<float> roughness_of(const std::vector<float>& lightness, int width, int height) {
    constexpr int kWindow = 7;
    std::vector<float> copy = lightness;
    const cv::Mat plane = view_of(copy, width, height);
    cv::Mat mean, square;
    cv::boxFilter(plane, mean, -1, {kWindow, kWindow}, {-1, -1}, true, cv::BORDER_REFLECT);
    cv::boxFilter(plane.mul(plane), square, -1, {kWindow, kWindow}, {-1, -1}, true, cv::BORDER_REFLECT);
    for (std::size_t i = 0; i < copy.size(); ++i) {
        const float m = mean.ptr<float>()[i];
        copy[i] = std::log2(1 + std::sqrt(std::max(square.ptr<float>()[i] - m * m, 0.0f)));
    }
    return copy;
}

}  // namespace

RegionSums& RegionSums::operator+=(const RegionSums& other) {
    area += other.area;
    for (std::size_t c = 0; c < 3; ++c) {
        colour[c] += other.colour[c];
        for (std::size_t i = 0; i < kShades; ++i) shades[c][i] += other.shades[c][i];
    }
    for (std::size_t i = 0; i < kTextures; ++i) rough[i] += other.rough[i];
    return *this;
}

std::vector<RegionSums> sums_of(std::span<const std::uint32_t> face, std::size_t faces,
                                const std::vector<std::vector<float>>& planes, int width, int height) {
    // Where the bins lie: lightness 0 to 100; a* and b* mostly within 60 of grey; rough from 1 to 32 and more.
    constexpr double kLightness = (RegionSums::kShades - 1) / 100.0, kColour = (RegionSums::kShades - 1) / 100.0, kFarthest = 50;
    constexpr double kRough = (RegionSums::kTextures - 1) / 5.0;
    const std::vector<float> rough = roughness_of(planes[0], width, height);
    std::vector<RegionSums> sums(faces);
    for (std::size_t i = 0; i < face.size(); ++i) {
        RegionSums& sum = sums[face[i]];
        sum.area += 1;
        for (std::size_t c = 0; c < 3; ++c) sum.colour[c] += static_cast<double>(planes[c][i]);
        count_soft(sum.shades[0], static_cast<double>(planes[0][i]) * kLightness);
        for (std::size_t c = 1; c < 3; ++c) count_soft(sum.shades[c], (static_cast<double>(planes[c][i]) + kFarthest) * kColour);
        count_soft(sum.rough, static_cast<double>(rough[i]) * kRough);
    }
    return sums;
}

PairFeatures features_of(const RegionSums& a, const RegionSums& b, const SharedBorder& border) {
    const double strength = border.strength / (border.length * kFullStrength) * 5;
    const double smaller = std::log(std::min(a.area, b.area)) / 5;
    const double light = std::sqrt(unlike(a.shades[0], a.area, b.shades[0], b.area));
    const double colour =
        std::sqrt(unlike(a.shades[1], a.area, b.shades[1], b.area)) + std::sqrt(unlike(a.shades[2], a.area, b.shades[2], b.area));
    const double rough = std::sqrt(unlike(a.rough, a.area, b.rough, b.area));
    double square = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        const double apart = a.colour[c] / a.area - b.colour[c] / b.area;
        square += apart * apart;
    }
    const double root = std::sqrt(strength);
    return {strength,
            root,
            light,
            colour,
            rough,
            std::sqrt(std::sqrt(square)) / 5,
            smaller,
            root * smaller,
            std::log1p(border.length) / 4,
            root * light,
            1};
}

namespace {

struct SharedEdge {
    std::uint32_t a = 0, b = 0;
    SharedBorder border;
    int version = 0;  // counts up when anything of it changes; what waits in the queue with another number is old
    bool gone = false;
};

struct Waiting {
    double cost = 0;
    std::uint32_t edge = 0;
    int version = 0;
    bool operator<(const Waiting& other) const { return cost != other.cost ? cost > other.cost : edge > other.edge; }
};

class Merger {
public:
    Merger(RegionTree& tree, std::vector<RegionSums> sums, double least, const PairWeights& weights, const PairWatcher& watcher)
        : tree_(tree), sums_(std::move(sums)), least_(least), weights_(weights), watcher_(watcher) {
        const std::size_t faces = sums_.size();
        edges_of_.resize(faces);
        edge_of_arc_.resize(tree.arcs.size());
        std::vector<std::pair<std::uint64_t, std::uint32_t>> pairs;
        for (std::uint32_t i = 0; i < tree.arcs.size(); ++i) {
            const auto [a, b] = std::minmax(tree.arcs[i].faces[0], tree.arcs[i].faces[1]);
            pairs.push_back({static_cast<std::uint64_t>(a) << 32 | b, i});
        }
        std::sort(pairs.begin(), pairs.end());
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            const RegionArc& arc = tree.arcs[pairs[i].second];
            if (i == 0 || pairs[i].first != pairs[i - 1].first) {
                const auto a = static_cast<std::uint32_t>(pairs[i].first >> 32), b = static_cast<std::uint32_t>(pairs[i].first);
                edges_of_[a].push_back(static_cast<std::uint32_t>(edges_.size()));
                edges_of_[b].push_back(static_cast<std::uint32_t>(edges_.size()));
                edges_.push_back({a, b, {}, 0, false});
            }
            const double length = steps_of(arc);
            edges_.back().border.length += length;
            edges_.back().border.strength += length * static_cast<double>(arc.strength);
            edge_of_arc_[pairs[i].second] = static_cast<std::uint32_t>(edges_.size() - 1);
        }
        joined_.resize(edges_.size());
        std::iota(joined_.begin(), joined_.end(), 0u);
        ended_.assign(edges_.size(), {});
        tree.nodes.assign(faces, {});
        for (std::size_t i = 0; i < faces; ++i) place(tree.nodes[i], sums_[i]);
        for (std::uint32_t i = 0; i < edges_.size(); ++i) wait(i);
    }

    void merge() {
        while (!queue_.empty()) {
            const Waiting next = queue_.top();
            queue_.pop();
            const SharedEdge& edge = edges_[next.edge];
            if (edge.gone || edge.version != next.version) continue;
            join(next.edge);
        }
        for (std::size_t i = 0; i < tree_.arcs.size(); ++i) {
            const End& end = ended_[root_of(edge_of_arc_[i])];
            tree_.arcs[i].level = end.level;
            tree_.arcs[i].unlike = end.unlike;
        }
    }

private:
    struct End {
        float level = 0;
        std::array<float, 3> unlike{};
    };

    static void place(RegionNode& node, const RegionSums& sums) {
        node.area = sums.area;
        for (std::size_t c = 0; c < 3; ++c) node.colour[c] = static_cast<float>(sums.colour[c] / sums.area);
    }

    std::uint32_t root_of(std::uint32_t edge) {
        while (joined_[edge] != edge) edge = joined_[edge] = joined_[joined_[edge]];
        return edge;
    }

    PairFeatures features(const SharedEdge& edge) const { return features_of(sums_[edge.a], sums_[edge.b], edge.border); }

    double score(const PairFeatures& f) const { return std::inner_product(f.begin(), f.end(), weights_.begin(), 0.0); }

    bool is_small(const SharedEdge& edge) const { return std::min(sums_[edge.a].area, sums_[edge.b].area) < least_; }

    void wait(std::uint32_t i) {
        SharedEdge& edge = edges_[i];
        ++edge.version;
        const PairFeatures f = features(edge);
        constexpr double kFirst = 1e6;  // before any that is large enough
        const bool small = is_small(edge);
        if (watcher_ && !small) watcher_(edge.a, edge.b, f);
        queue_.push({score(f) - (small ? kFirst : 0), i, edge.version});
    }

    void join(std::uint32_t between) {
        const std::uint32_t a = edges_[between].a, b = edges_[between].b;
        const PairFeatures f = features(edges_[between]);
        const auto chance = static_cast<float>(255 / (1 + std::exp(-score(f))));
        const float below = std::max(tree_.nodes[a].level, tree_.nodes[b].level);
        const float level = is_small(edges_[between]) ? below : std::max(below, chance);
        const auto node = static_cast<std::uint32_t>(tree_.nodes.size());
        tree_.nodes.push_back({});
        tree_.nodes[node].children = {static_cast<int>(a), static_cast<int>(b)};
        tree_.nodes[node].level = level;
        tree_.nodes[a].parent = tree_.nodes[b].parent = static_cast<int>(node);
        ended_[between] = {level, {static_cast<float>(f[2]), static_cast<float>(f[3] / 2), static_cast<float>(f[4])}};
        sums_.push_back(sums_[a]);
        sums_[node] += sums_[b];
        place(tree_.nodes[node], sums_[node]);
        edges_[between].gone = true;
        take_over(a, b, node);
        for (const std::uint32_t i : edges_of_[node]) wait(i);
    }

    // The borders of both, those with the same neighbour as one.
    void take_over(std::uint32_t a, std::uint32_t b, std::uint32_t node) {
        edges_of_.emplace_back();
        with_.resize(edges_of_.size(), kNone);
        for (const std::uint32_t old : {a, b})
            for (const std::uint32_t i : edges_of_[old]) {
                SharedEdge& edge = edges_[i];
                if (edge.gone) continue;
                const std::uint32_t other = edge.a == old ? edge.b : edge.a;
                if (with_[other] != kNone && with_[other] != i) {
                    edges_[with_[other]].border.length += edge.border.length;
                    edges_[with_[other]].border.strength += edge.border.strength;
                    edge.gone = true;
                    joined_[i] = with_[other];
                    continue;
                }
                with_[other] = i;
                edge.a = other;
                edge.b = node;
                edges_of_[node].push_back(i);
            }
        for (const std::uint32_t i : edges_of_[node]) with_[edges_[i].a] = kNone;
        edges_of_[a] = edges_of_[b] = {};
    }

    static constexpr std::uint32_t kNone = 0xffffffff;
    RegionTree& tree_;
    std::vector<RegionSums> sums_;
    double least_;
    const PairWeights& weights_;
    const PairWatcher& watcher_;
    std::vector<SharedEdge> edges_;
    std::vector<std::vector<std::uint32_t>> edges_of_;  // of each node; may hold some that are gone
    std::vector<std::uint32_t> edge_of_arc_, joined_, with_;
    std::vector<End> ended_;
    std::priority_queue<Waiting> queue_;
};

void find_boxes(RegionTree& tree) {
    for (RegionNode& node : tree.nodes) node.box = {tree.width, tree.height, 0, 0};
    const auto hold = [](PixelBox& box, const PixelBox& other) { box = around(box, other); };
    std::size_t i = 0;
    for (int y = 0; y < tree.height; ++y)
        for (int x = 0; x < tree.width; ++x, ++i) hold(tree.nodes[tree.face[i]].box, {x, y, x + 1, y + 1});
    for (const RegionNode& node : tree.nodes)  // children stand before their parents
        if (node.parent >= 0) hold(tree.nodes[static_cast<std::size_t>(node.parent)].box, node.box);
}

}  // namespace

void merge_regions(RegionTree& tree, std::vector<RegionSums> sums, double least, const PairWeights& weights,
                   const PairWatcher& watcher) {
    Merger(tree, std::move(sums), least, weights, watcher).merge();
    find_boxes(tree);
}

}  // namespace tactics
