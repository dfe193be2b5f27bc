// SPDX-License-Identifier: Apache-2.0
#include "filters/edge_noise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <vector>

namespace tactics {

namespace {

// A quarter of a Rayleigh distribution of scale 1 lies below this.
const float kWeakestQuarter = static_cast<float>(std::sqrt(2 * std::log(4.0 / 3.0)));

// The strength that three quarters of the pixels exceed.
float weakest_quarter(const EdgeMap& edges) {
    // Enough for a quartile within 1 %, and little to sort. An odd step does not fall in with columns.
    constexpr std::size_t kSamples = 50'000;
    const std::size_t step = edges.strength.size() / kSamples | 1;
    std::vector<float> sample;
    sample.reserve(edges.strength.size() / step + 1);
    for (std::size_t i = 0; i < edges.strength.size(); i += step) sample.push_back(edges.strength[i]);
    if (sample.empty()) return 0;
    const auto quartile = sample.begin() + static_cast<std::ptrdiff_t>(sample.size() / 4);
    std::nth_element(sample.begin(), quartile, sample.end());
    return *quartile;
}

}  // namespace

double noise_level(const Image& grey) {
    if (grey.width < 3 || grey.height < 3) return 0;
    // Second difference in both directions: blind to planes, 6 times the deviation of white noise.
    std::array<std::size_t, 16 * 255 + 1> histogram{};
    std::size_t count = 0, flat = 0;
    for (int y = 1; y + 1 < grey.height; ++y) {
        const std::uint8_t *a = grey.row(y - 1), *b = grey.row(y), *c = grey.row(y + 1);
        for (int x = 1; x + 1 < grey.width; ++x, ++count) {
            const int corners = a[x - 1] + a[x + 1] + c[x - 1] + c[x + 1];
            const int sides = a[x] + c[x] + b[x - 1] + b[x + 1];
            // What was drawn is flat nearly everywhere, and one count after the other of the same bin would have to wait for it.
            if (const int off = std::abs(corners - 2 * sides + 4 * b[x]); off == 0)
                ++flat;
            else
                ++histogram[static_cast<std::size_t>(off)];
        }
    }
    histogram[0] = flat;
    std::size_t below = 0, median = 0;
    while (below + histogram[median] <= count / 2) below += histogram[median++];
    // Whole numbers are bins one wide around them; the bin of 0 is half as wide.
    const double within = (static_cast<double>(count) / 2 - static_cast<double>(below)) / static_cast<double>(histogram[median]);
    const double middle = median == 0 ? within / 2 : static_cast<double>(median) - 0.5 + within;
    constexpr double kMedianOfNormal = 0.6745;  // of the absolute value of a normal deviate of deviation 1
    // A picture of flat parts has no noise at all: most differences are exactly 0.
    return median == 0 && within < 0.75 ? 0 : middle / (6 * kMedianOfNormal);
}

// Without a blur the difference of two pixels is the derivative; it is as long as a Gaussian of half a pixel.
double noise_scale(double level, double sigma) { return level / (2 * std::max(sigma, 0.5)); }

float noise_of(const EdgeMap& edges) { return weakest_quarter(edges) / kWeakestQuarter; }

float noise_floor(const EdgeMap& edges, float least) {
    float noise = edges.noise.value_or(0), slope = 0;
    if (!edges.thinned) {
        const float weak = weakest_quarter(edges);
        if (!edges.noise) noise = weak / kWeakestQuarter;
        // The noise and the slope are at right angles half of the time: their squares add up.
        slope = std::sqrt(std::max(0.0f, weak * weak - noise * noise * kWeakestQuarter * kWeakestQuarter));
    }
    // The share of pixels over t is exp(-t^2 / 2 s^2): a tenth of a pixel of n is over s sqrt(2 ln(10 n)). Along the picture's
    // border, about 4 sqrt(n) pixels, a blur that mirrors the picture averages over half as many, so s is sqrt(2) larger
    // there; a tenth of those pixels is over 2 s sqrt(ln(40 sqrt(n))) = s sqrt(2 ln(1600 n)), which is more.
    const double pixels = static_cast<double>(std::max<std::size_t>(1, edges.strength.size()));
    return slope + std::max(least, noise * static_cast<float>(std::sqrt(2 * std::log(1600 * pixels))));
}

void drop_below(EdgeMap& edges, float least) {
    for (float& s : edges.strength) s = s < least ? 0 : s;
}

}  // namespace tactics
