// SPDX-License-Identifier: Apache-2.0
#include "tactics/lettering/weighed_groups.h"

#include <algorithm>
#include <cmath>

namespace tactics {

std::vector<double> heaviest_groups(std::vector<std::pair<double, double>> votes, double share, double step, std::size_t most) {
    std::sort(votes.begin(), votes.end());
    std::vector<std::pair<double, double>> groups;  // weight, mean
    for (std::size_t i = 0; i < votes.size(); ++i) {
        double weight = 0, sum = 0;
        for (std::size_t k = i; k < votes.size() && votes[k].first <= votes[i].first * (1 + share) + step; ++k) {
            weight += votes[k].second;
            sum += votes[k].second * votes[k].first;
        }
        groups.push_back({-weight, sum / weight});
    }
    std::sort(groups.begin(), groups.end());
    std::vector<double> found;
    for (const auto& group : groups) {
        const double mean = group.second;
        const bool known = std::any_of(found.begin(), found.end(),
                                       [&](double one) { return std::abs(one - mean) <= (share * mean + step) / 2; });
        if (!known) found.push_back(mean);
        if (found.size() == most) break;
    }
    return found;
}

}  // namespace tactics
