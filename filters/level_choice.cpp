// SPDX-License-Identifier: Apache-2.0
#include "filters/level_choice.h"

#include <algorithm>
#include <cmath>

#include "tactics/layout/texture.h"
#include "tactics/units.h"

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

std::string reason_of(const LevelChoice& choice, const std::string& what) {
    const std::string k = std::to_string(choice.k);
    const std::string share = to_text(std::floor(100 * choice.explained)) + " %";
    std::string reason = "k=" + k + ": ";
    if (choice.k == 1) return reason + "nothing in it stands out of its noise";
    reason += k + " " + what + " explain " + share + " of its variance";
    if (choice.noise) reason += ", the rest is noise";
    if (choice.ended) reason += ", and more textures no finger tells apart";
    return reason;
}

}  // namespace tactics
