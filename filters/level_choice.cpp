// SPDX-License-Identifier: Apache-2.0
#include "filters/level_choice.h"

#include <algorithm>
#include <cmath>

#include "tactics/layout/texture.h"

namespace tactics {

LevelChoice choose_levels(const std::function<double(int)>& unexplained, double noise_variance, int least) {
    constexpr double kRest = 0.1;
    const int most = static_cast<int>(textures().size());
    const double all = unexplained(1);
    double left = all;
    for (int k = 1;; ++k) {
        const double next = k < std::max(most, least) ? unexplained(k + 1) : left;
        const bool noise = left <= noise_variance, enough = noise || (left <= kRest * all && next > kRest * left);
        if (k >= least && (enough || k >= most))
            return {k, all > 0 ? 1 - left / all : 1, noise && left > 0, left > kRest * all && !noise};
        left = next;
    }
}

Phrase reason_of(const LevelChoice& choice, bool of_colours) {
    if (choice.k == 1) return phrase("nothing in it stands out of its noise");
    const auto k = static_cast<std::size_t>(choice.k);
    const Phrase share = numeral(std::floor(100 * choice.explained));
    Phrase reason =
        of_colours ? phrases(k, "{0} colour explains {1} % of its variance", "{0} colours explain {1} % of its variance", share)
                   : phrases(k, "{0} grey explains {1} % of its variance", "{0} greys explain {1} % of its variance", share);
    if (choice.noise) reason = phrase("{0}, the rest is noise", std::move(reason));
    if (choice.ended) reason = phrase("{0}, and more textures no finger tells apart", std::move(reason));
    return reason;
}

}  // namespace tactics
