// SPDX-License-Identifier: Apache-2.0
#include "filters/components.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "tactics/image.h"

namespace tactics {

namespace {

// Union-find over the runs; a parent never stands behind its child, so the root is the first run of the piece.
class Forest {
public:
    explicit Forest(std::size_t count) : parents_(count) {
        for (std::size_t i = 0; i < count; ++i) parents_[i] = static_cast<std::uint32_t>(i);
    }

    std::uint32_t root(std::uint32_t i) {
        while (parents_[i] != i) i = parents_[i] = parents_[parents_[i]];
        return i;
    }

    void join(std::uint32_t a, std::uint32_t b) {
        a = root(a);
        b = root(b);
        parents_[a < b ? b : a] = a < b ? a : b;
    }

private:
    std::vector<std::uint32_t> parents_;
};

}  // namespace

Components join_runs(std::vector<Run> runs, Joined joined) {
    const int reach = joined == Joined::by_corners ? 1 : 0;
    Forest forest(runs.size());
    // `above` walks along the row before while `i` walks along its own.
    std::size_t above = 0;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const Run& run = runs[i];
        while (above < i &&
               (runs[above].row < run.row - 1 || (runs[above].row == run.row - 1 && runs[above].end + reach <= run.begin)))
            ++above;
        for (std::size_t j = above; j < i && runs[j].row == run.row - 1 && runs[j].begin < run.end + reach; ++j)
            forest.join(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j));
    }
    Components components{std::move(runs), 0};
    for (std::size_t i = 0; i < components.runs.size(); ++i) {
        const std::uint32_t root = forest.root(static_cast<std::uint32_t>(i));
        components.runs[i].component = root == i ? components.count++ : components.runs[root].component;
    }
    return components;
}

std::vector<std::size_t> Components::areas() const {
    std::vector<std::size_t> areas(count, 0);
    for (const Run& run : runs) areas[run.component] += run.length();
    return areas;
}

std::vector<std::size_t> Components::extents() const {
    constexpr int kFar = std::numeric_limits<int>::max();
    std::vector<PixelBox> boxes(count, {kFar, kFar, 0, 0});
    for (const Run& run : runs) {
        PixelBox& box = boxes[run.component];
        box = around(box, {run.begin, run.row, run.end, run.row + 1});
    }
    std::vector<std::size_t> extents;
    extents.reserve(count);
    for (const PixelBox& box : boxes) extents.push_back(static_cast<std::size_t>(std::max(box.width(), box.height())));
    return extents;
}

}  // namespace tactics
