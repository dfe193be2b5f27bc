#include "filters/edge_noise.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tactics {

float noise_of(const EdgeMap& edges) {
    // Enough for a quartile within 1 %, and little to sort. An odd step does not fall in with columns.
    constexpr std::size_t kSamples = 50'000;
    const std::size_t step = edges.strength.size() / kSamples | 1;
    std::vector<float> sample;
    sample.reserve(edges.strength.size() / step + 1);
    for (std::size_t i = 0; i < edges.strength.size(); i += step) sample.push_back(edges.strength[i]);
    if (sample.empty()) return 0;
    const auto quartile = sample.begin() + static_cast<std::ptrdiff_t>(sample.size() / 4);
    std::nth_element(sample.begin(), quartile, sample.end());
    // A quarter of a Rayleigh distribution of scale s lies below s sqrt(2 ln(4/3)).
    return *quartile / static_cast<float>(std::sqrt(2 * std::log(4.0 / 3.0)));
}

float noise_floor(const EdgeMap& edges) {
    const double noise = static_cast<double>(edges.noise > 0 || edges.thinned ? edges.noise : noise_of(edges));
    // The share of pixels over t is exp(-t^2 / 2 s^2): a tenth of a pixel of n is over s sqrt(2 ln(10 n)). Along the picture's
    // border, about 4 sqrt(n) pixels, a blur that mirrors the picture averages over half as many, so s is sqrt(2) larger
    // there; a tenth of those pixels is over 2 s sqrt(ln(40 sqrt(n))) = s sqrt(2 ln(1600 n)), which is more.
    const double pixels = static_cast<double>(std::max<std::size_t>(1, edges.strength.size()));
    return static_cast<float>(noise * std::sqrt(2 * std::log(1600 * pixels)));
}

void drop_below(EdgeMap& edges, float least) {
    for (float& s : edges.strength) s = s < least ? 0 : s;
}

}  // namespace tactics
