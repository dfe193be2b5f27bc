// SPDX-License-Identifier: Apache-2.0
#include "tactics/layout/texture_choice.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "tactics/layout/texture.h"

namespace tactics {

std::vector<int> choose_textures(const std::vector<std::vector<double>>& border, const std::vector<double>& grey) {
    const std::size_t classes = grey.size(), kinds = textures().size() + 1;
    if (classes > kinds) throw std::logic_error("more classes than textures");
    // All ways: with five textures and blank at most 720.
    std::vector<int> order(kinds);
    std::iota(order.begin(), order.end(), 0);
    struct Way {
        std::vector<int> textures;
        double apart = 0;
        int in_order = 0;
    };
    std::vector<Way> ways;
    std::vector<int> last;
    do {
        Way way{{order.begin(), order.begin() + static_cast<std::ptrdiff_t>(classes)}};
        if (way.textures == last) continue;  // only those that no class has were exchanged
        last = way.textures;
        for (std::size_t a = 0; a < classes; ++a)
            for (std::size_t b = 0; b < a; ++b) {
                way.apart += border[a][b] * difference(way.textures[a], way.textures[b]);
                const double darker = grey[b] - grey[a], blacker = share_black(way.textures[a]) - share_black(way.textures[b]);
                way.in_order += darker * blacker > 0 ? 1 : 0;
            }
        ways.push_back(std::move(way));
    } while (std::next_permutation(order.begin(), order.end()));
    const double most =
        std::max_element(ways.begin(), ways.end(), [](const Way& a, const Way& b) { return a.apart < b.apart; })->apart;
    constexpr double kNothing = 0.02;
    const Way* best = nullptr;
    for (const Way& way : ways)
        if (way.apart >= (1 - kNothing) * most && (best == nullptr || way.in_order > best->in_order)) best = &way;
    return best->textures;
}

}  // namespace tactics
