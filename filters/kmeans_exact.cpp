// SPDX-License-Identifier: Apache-2.0
// One-dimensional k-means by dynamic programming: the best c classes of the first j levels are the best c-1 classes of the
// first i levels and one class of the rest (H. Wang, M. Song, "Ckmeans.1d.dp", The R Journal 3/2, 2011). The best i never
// falls when j rises, so each row is filled by halving (divide and conquer).
#include "filters/kmeans_exact.h"

#include <algorithm>
#include <limits>

namespace tactics {

namespace {

class Table {
public:
    explicit Table(std::span<const Level> levels) : sums_(levels.size() + 1) {
        double weight = 0;
        double total = 0;
        for (const Level& level : levels) {
            weight += level.weight;
            total += level.weight * level.value;
        }
        // Sums about the mean keep more digits than sums about 0.
        const double mean = total / weight;
        for (std::size_t i = 0; i < levels.size(); ++i) {
            const double value = levels[i].value - mean;
            const double w = levels[i].weight;
            sums_[i + 1] = {sums_[i].weight + w, sums_[i].first + w * value, sums_[i].second + w * value * value};
        }
    }

    // Index of the first level of each of `k` classes; 1 <= k <= number of levels.
    std::vector<std::size_t> starts(std::size_t k) {
        const std::size_t n = sums_.size() - 1;
        best_.assign(n + 1, 0);
        for (std::size_t j = 1; j <= n; ++j) best_[j] = squares(0, j);
        std::vector<std::vector<std::size_t>> start_of(k, std::vector<std::size_t>(n + 1, 0));
        std::vector<double> next(n + 1);
        for (std::size_t c = 1; c < k; ++c) {
            // With c+1 classes at least c+1 levels are needed.
            fill(start_of[c], next, c + 1, n, c, n - 1);
            best_.swap(next);
        }
        std::vector<std::size_t> starts(k, 0);
        for (std::size_t c = k, end = n; c-- > 1;) end = starts[c] = start_of[c][end];
        return starts;
    }

private:
    struct Sums {
        double weight = 0;
        double first = 0;
        double second = 0;
    };

    // Of one class that holds the levels [i, j).
    double squares(std::size_t i, std::size_t j) const {
        const double weight = sums_[j].weight - sums_[i].weight;
        const double first = sums_[j].first - sums_[i].first;
        return std::max(0.0, sums_[j].second - sums_[i].second - first * first / weight);
    }

    // The last class of the first j levels starts within [low, high], for every j in [from, to].
    void fill(std::vector<std::size_t>& start_of, std::vector<double>& next, std::size_t from, std::size_t to, std::size_t low,
              std::size_t high) const {
        const std::size_t j = from + (to - from) / 2;
        double least = std::numeric_limits<double>::infinity();
        std::size_t start = low;
        for (std::size_t i = low; i <= std::min(high, j - 1); ++i) {
            const double sum = best_[i] + squares(i, j);
            if (sum < least) {
                least = sum;
                start = i;
            }
        }
        next[j] = least;
        start_of[j] = start;
        if (j > from) fill(start_of, next, from, j - 1, low, start);
        if (j < to) fill(start_of, next, j + 1, to, start, high);
    }

    std::vector<Sums> sums_;
    std::vector<double> best_;  // least sum of squares of the first j levels with the classes so far
};

}  // namespace

std::size_t Classes::class_of(std::size_t level) const {
    const auto after = std::upper_bound(first.begin(), first.end(), level);
    return after == first.begin() ? 0 : static_cast<std::size_t>(after - first.begin()) - 1;
}

Classes kmeans_exact(std::span<const Level> levels, int k) {
    std::vector<Level> present;
    std::vector<std::size_t> index;
    for (std::size_t i = 0; i < levels.size(); ++i) {
        if (levels[i].weight <= 0) continue;
        present.push_back(levels[i]);
        index.push_back(i);
    }
    Classes classes;
    if (present.empty() || k < 1) return classes;
    const std::vector<std::size_t> starts = Table(present).starts(std::min(static_cast<std::size_t>(k), present.size()));
    for (std::size_t c = 0; c < starts.size(); ++c) {
        const std::size_t end = c + 1 < starts.size() ? starts[c + 1] : present.size();
        double weight = 0;
        double total = 0;
        for (std::size_t i = starts[c]; i < end; ++i) {
            weight += present[i].weight;
            total += present[i].weight * present[i].value;
        }
        const double centre = total / weight;
        for (std::size_t i = starts[c]; i < end; ++i)
            classes.squares += present[i].weight * (present[i].value - centre) * (present[i].value - centre);
        classes.first.push_back(index[starts[c]]);
        classes.centres.push_back(centre);
    }
    return classes;
}

}  // namespace tactics
