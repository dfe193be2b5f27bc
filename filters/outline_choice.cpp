// SPDX-License-Identifier: Apache-2.0
#include "filters/outline_choice.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "filters/line_budget.h"
#include "filters/node_outlines.h"
#include "filters/part_borders.h"

namespace tactics {

double length_of(const RegionTree& tree, const Parts& parts) {
    double length = 0;
    for (const RegionArc& arc : tree.arcs)
        if (parts.divides(arc)) length += steps_of(arc);
    return length;
}

namespace {

// The search: outlines of nodes are put in and borders between two parts are taken out, each time the change that gains most,
// until none gains.
class Search {
public:
    Search(const RegionTree& tree, std::span<const float> worth, double price, double most)
        : tree_(tree), most_(most), outline_(outlines_of_nodes(tree)), order_(tree) {
        parts_.part.assign(tree.faces(), 0);
        for (std::size_t i = 0; i < tree.arcs.size(); ++i) {
            length_.push_back(steps_of(tree.arcs[i]));
            gain_.push_back(length_.back() * (static_cast<double>(worth[i]) - price));
        }
        for (std::uint32_t i = 0; i < tree.nodes.size(); ++i)
            if (is_thing(tree, i)) candidates_.push_back(i);
    }

    // Goes on from what is drawn.
    void start_from(Parts drawn) {
        parts_ = std::move(drawn);
        number_anew();
        drawn_ = length_of(tree_, parts_);
    }

    void run() {
        constexpr int kRounds = 20;  // each gains, so it ends by itself; this bounds the time
        for (int i = 0; i < kRounds; ++i) {
            const bool taken = take_out();
            if (!put_in() && !taken) break;
        }
    }

    const Parts& parts() const { return parts_; }
    double gain() const {
        double sum = 0;
        for (std::size_t i = 0; i < gain_.size(); ++i)
            if (parts_.divides(tree_.arcs[i])) sum += gain_[i];
        return sum;
    }

private:
    // What an outline gains for its new length, if there is that much left; what is drawn already costs nothing.
    double worth_of(std::uint32_t node) const {
        double gain = 0, length = 0;
        for (const std::uint32_t a : outline_[node])
            if (!parts_.divides(tree_.arcs[a])) {
                gain += gain_[a];
                length += length_[a];
            }
        return length > 0 && length <= most_ - drawn_ ? gain / (length + kStart) : 0;
    }

    // Outlines that gain, the best first.
    bool put_in() {
        bool any = false;
        for (;;) {
            double best = kLeast;
            std::uint32_t found = kNone;
            for (const std::uint32_t node : candidates_)
                if (const double worth = worth_of(node); worth > best) {
                    best = worth;
                    found = node;
                }
            if (found == kNone) return any;
            cut_out(found);
            drawn_ = length_of(tree_, parts_);
            any = true;
        }
    }

    // Every part that the node divides becomes two.
    void cut_out(std::uint32_t node) {
        std::vector<std::uint32_t> fresh(parts_count_, kNone);
        const std::size_t begin = order_.first[node], end = begin + order_.count[node];
        for (std::size_t i = begin; i < end; ++i) {
            std::uint32_t& part = parts_.part[order_.face_at[i]];
            if (fresh[part] == kNone) fresh[part] = static_cast<std::uint32_t>(parts_count_++);
            part = fresh[part];
            fresh.resize(parts_count_, kNone);
        }
        number_anew();
    }

    // Parts that do not hang together become several, so that each border between two of them can be judged alone.
    void number_anew() {
        std::vector<std::uint32_t> root(tree_.faces());
        std::iota(root.begin(), root.end(), 0u);
        const auto find = [&](std::uint32_t f) {
            while (root[f] != f) f = root[f] = root[root[f]];
            return f;
        };
        for (const RegionArc& arc : tree_.arcs)
            if (!parts_.divides(arc)) root[find(arc.faces[0])] = find(arc.faces[1]);
        std::vector<std::uint32_t> number(tree_.faces(), kNone);
        parts_count_ = 0;
        for (std::uint32_t f = 0; f < tree_.faces(); ++f) {
            std::uint32_t& n = number[find(f)];
            if (n == kNone) n = static_cast<std::uint32_t>(parts_count_++);
        }
        for (std::uint32_t f = 0; f < tree_.faces(); ++f) parts_.part[f] = number[find(f)];
    }

    // Borders whose steps are together worth less than they cost; and while there is too much, those that are worth least.
    bool take_out() {
        PartBorders borders(tree_, parts_, gain_, length_);
        borders.take_out_losing(kLeast);
        borders.take_out_until(most_);
        if (borders.drawn() >= drawn_) return false;
        parts_ = borders.parts();
        drawn_ = borders.drawn();
        return true;
    }

    static constexpr std::uint32_t kNone = 0xffffffff;
    static constexpr double kLeast = 1e-6;
    static constexpr double kStart = 400;  // sides of pixels: a new outline costs that much more, or slivers would come first
    const RegionTree& tree_;
    Parts parts_;
    double most_, drawn_ = 0;
    std::size_t parts_count_ = 1;
    std::vector<double> length_, gain_;  // of each arc, if it is drawn
    std::vector<std::uint32_t> candidates_;
    std::vector<std::vector<std::uint32_t>> outline_;
    FaceOrder order_;
};

}  // namespace

// From nothing and from all: each way misses some of what the other finds.
Parts best_parts(const RegionTree& tree, std::span<const float> worth, double price, double most) {
    Search search(tree, worth, price, most);
    search.run();
    Parts best = search.parts();
    const double gain = search.gain();
    Parts all;
    all.part.resize(tree.faces());
    std::iota(all.part.begin(), all.part.end(), 0u);
    search.start_from(std::move(all));
    search.run();
    return search.gain() > gain ? search.parts() : best;
}

double most_of_page(const RegionTree& tree, double line) {
    constexpr double kStairs = 1.27;  // staircases of pixels are longer than the lines that they become
    const double mm = tree.mm_per_pixel;
    return line_budget(line, tree.width * mm, tree.height * mm) * kStairs / mm;
}

// A faint thing before nothing: better unsure than a page without a line. On blank, shaded and noisy walls there is none even so.
Parts parts_of_page(const RegionTree& tree, std::span<const float> worth, double price, double line, const Parts& drawn) {
    constexpr double kLower = 0.85;   // of a price, to the next that is tried
    constexpr double kEnough = 0.95;  // of what is asked for
    const auto parts_at = [&](double cost, double length) {
        return drawn.part.empty() ? best_parts(tree, worth, cost, length) : more_parts(tree, drawn, worth, cost, length);
    };
    const double most = most_of_page(tree, line);
    Parts parts = parts_at(price, most);
    const double usual = length_of(tree, parts);
    if (usual <= 0) return parts_at(std::min(price, kFaint), most);
    const double asked = std::min(most, usual * line / kUsualLine);
    while (price > kFaint && length_of(tree, parts) < kEnough * asked) {
        price *= kLower;
        parts = parts_at(price, asked);
    }
    return parts;
}

Parts more_parts(const RegionTree& tree, Parts drawn, std::span<const float> worth, double price, double most) {
    Search search(tree, worth, price, std::max(most, length_of(tree, drawn)));
    search.start_from(std::move(drawn));
    search.run();
    return search.parts();
}

}  // namespace tactics
