// SPDX-License-Identifier: Apache-2.0
#include "filters/min_cut.h"

#include <algorithm>
#include <limits>

namespace tactics {

namespace {

class Flow {
public:
    Flow(std::span<const std::int64_t> as_true, std::span<const std::int64_t> as_false, std::span<const CutEdge> edges)
        : things_(as_true.size()), out_(as_true.size() + 2) {
        for (std::uint32_t i = 0; i < things_; ++i) {
            // What both sides cost alike decides nothing.
            const std::int64_t both = std::min(as_true[i], as_false[i]);
            if (as_false[i] > both) add(source(), i, as_false[i] - both, 0);
            if (as_true[i] > both) add(i, sink(), as_true[i] - both, 0);
        }
        for (const CutEdge& edge : edges)
            if (edge.a != edge.b && edge.weight > 0) add(edge.a, edge.b, edge.weight, edge.weight);
    }

    std::vector<bool> run() {
        while (find_ways()) {
            next_.assign(out_.size(), 0);
            while (push() > 0) {
            }
        }
        std::vector<bool> side(things_);
        for (std::size_t i = 0; i < things_; ++i) side[i] = depth_[i] >= 0;
        return side;
    }

private:
    struct Pipe {
        std::uint32_t to;
        std::int64_t room;  // the pipe back is its neighbour in the list: the index with its last bit turned
    };

    std::uint32_t source() const { return static_cast<std::uint32_t>(things_); }
    std::uint32_t sink() const { return static_cast<std::uint32_t>(things_ + 1); }

    void add(std::uint32_t a, std::uint32_t b, std::int64_t there, std::int64_t back) {
        out_[a].push_back(pipes_.size());
        pipes_.push_back({b, there});
        out_[b].push_back(pipes_.size());
        pipes_.push_back({a, back});
    }

    // How many pipes each is from the source; whether the sink can be reached.
    bool find_ways() {
        depth_.assign(out_.size(), -1);
        depth_[source()] = 0;
        std::vector<std::uint32_t> queue{source()};
        for (std::size_t n = 0; n < queue.size(); ++n)
            for (const std::size_t p : out_[queue[n]])
                if (pipes_[p].room > 0 && depth_[pipes_[p].to] < 0) {
                    depth_[pipes_[p].to] = depth_[queue[n]] + 1;
                    queue.push_back(pipes_[p].to);
                }
        return depth_[sink()] >= 0;
    }

    // Fills one shortest way; without recursion, as a way may be as long as there are things.
    std::int64_t push() {
        std::vector<std::size_t> way;
        std::uint32_t at = source();
        while (at != sink()) {
            std::size_t& n = next_[at];
            while (n < out_[at].size() && !(pipes_[out_[at][n]].room > 0 && depth_[pipes_[out_[at][n]].to] == depth_[at] + 1))
                ++n;
            if (n < out_[at].size()) {
                way.push_back(out_[at][n]);
                at = pipes_[way.back()].to;
                continue;
            }
            if (way.empty()) return 0;
            at = pipes_[way.back() ^ 1].to;
            way.pop_back();
            ++next_[at];
        }
        std::int64_t most = std::numeric_limits<std::int64_t>::max();
        for (const std::size_t p : way) most = std::min(most, pipes_[p].room);
        for (const std::size_t p : way) {
            pipes_[p].room -= most;
            pipes_[p ^ 1].room += most;
        }
        return most;
    }

    std::size_t things_;
    std::vector<std::vector<std::size_t>> out_;  // pipes of each
    std::vector<Pipe> pipes_;
    std::vector<int> depth_;
    std::vector<std::size_t> next_;  // pipes before it lead nowhere any more
};

}  // namespace

std::vector<bool> min_cut(std::span<const std::int64_t> as_true, std::span<const std::int64_t> as_false,
                          std::span<const CutEdge> edges) {
    return Flow(as_true, as_false, edges).run();
}

}  // namespace tactics
