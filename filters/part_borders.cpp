// SPDX-License-Identifier: Apache-2.0
#include "filters/part_borders.h"

#include <algorithm>
#include <numeric>
#include <queue>
#include <tuple>

namespace tactics {

PartBorders::PartBorders(const RegionTree& tree, const Parts& parts, std::span<const double> gain, std::span<const double> length)
    : part_(parts.part) {
    const std::size_t count = part_.empty() ? 0 : *std::max_element(part_.begin(), part_.end()) + 1u;
    root_.resize(count);
    std::iota(root_.begin(), root_.end(), 0u);
    beside_.resize(count);
    for (std::size_t i = 0; i < tree.arcs.size(); ++i) {
        const std::uint32_t a = part_[tree.arcs[i].faces[0]], b = part_[tree.arcs[i].faces[1]];
        if (a == b) continue;
        for (Border* border : {&beside_[a][b], &beside_[b][a]}) {
            border->gain += gain[i];
            border->length += length[i];
        }
        drawn_ += length[i];
    }
}

std::uint32_t PartBorders::root_of(std::uint32_t part) const {
    while (root_[part] != part) part = root_[part] = root_[root_[part]];
    return part;
}

Parts PartBorders::parts() const {
    Parts parts;
    for (const std::uint32_t part : part_) parts.part.push_back(root_of(part));
    return parts;
}

// The smaller number stays, so that what comes out depends on the picture alone.
void PartBorders::merge(std::uint32_t into, std::uint32_t from) {
    root_[from] = into;
    drawn_ -= beside_[into].at(from).length;
    beside_[into].erase(from);
    for (const auto& [other, border] : beside_[from]) {
        if (other == into) continue;
        beside_[other].erase(from);
        for (Border* both : {&beside_[into][other], &beside_[other][into]}) {
            both->gain += border.gain;
            both->length += border.length;
        }
    }
    beside_[from].clear();
}

// Borders in the order of their keys; one that has changed since it was put in line stands there anew.
template <typename Key, typename Ends>
void PartBorders::take_out(Key key, Ends ends) {
    struct Waiting {
        double key;
        std::uint32_t one, other;
        bool operator>(const Waiting& than) const { return std::tie(key, one, other) > std::tie(than.key, than.one, than.other); }
    };
    std::priority_queue<Waiting, std::vector<Waiting>, std::greater<>> line;
    for (std::uint32_t a = 0; a < beside_.size(); ++a)
        for (const auto& [b, border] : beside_[a])
            if (a < b) line.push({key(border), a, b});
    while (!line.empty() && !ends(line.top().key)) {
        const Waiting next = line.top();
        line.pop();
        const auto found = beside_[next.one].find(next.other);
        if (found == beside_[next.one].end() || key(found->second) != next.key) continue;
        merge(next.one, next.other);
        for (const auto& [b, border] : beside_[next.one]) line.push({key(border), std::min(next.one, b), std::max(next.one, b)});
    }
}

void PartBorders::take_out_losing(double least) {
    take_out([](const Border& border) { return border.gain; }, [&](double gain) { return gain >= -least; });
}

void PartBorders::take_out_until(double most) {
    take_out([](const Border& border) { return border.gain / border.length; }, [&](double) { return drawn_ <= most; });
}

}  // namespace tactics
