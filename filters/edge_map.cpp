#include "filters/edge_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace tactics {

namespace {

float between(const EdgeMap& map, float x, float y) {
    x = std::clamp(x, 0.0f, static_cast<float>(map.width - 1));
    y = std::clamp(y, 0.0f, static_cast<float>(map.height - 1));
    const int left = static_cast<int>(x), top = static_cast<int>(y);
    const int right = std::min(left + 1, map.width - 1), bottom = std::min(top + 1, map.height - 1);
    const float fx = x - static_cast<float>(left), fy = y - static_cast<float>(top);
    const auto at = [&](int column, int row) {
        return map.strength[static_cast<std::size_t>(row) * static_cast<std::size_t>(map.width) + static_cast<std::size_t>(column)];
    };
    return (1 - fy) * ((1 - fx) * at(left, top) + fx * at(right, top)) + fy * ((1 - fx) * at(left, bottom) + fx * at(right, bottom));
}

}  // namespace

EdgeMap thin_edges(const EdgeMap& edges, double sigma) {
    const auto reach = static_cast<float>(std::max(sigma, 2.0));
    EdgeMap thin = edges;
    thin.thinned = true;
    for (int y = 0; y < edges.height; ++y)
        for (int x = 0; x < edges.width; ++x) {
            const std::size_t i = static_cast<std::size_t>(y) * static_cast<std::size_t>(edges.width) + static_cast<std::size_t>(x);
            const float s = edges.strength[i];
            if (s <= 0) continue;
            const float c = std::cos(edges.normal[i]), d = std::sin(edges.normal[i]);
            const auto side = [&](float steps) { return between(edges, static_cast<float>(x) + steps * c, static_cast<float>(y) + steps * d); };
            // On a plateau of two pixels the first of them stays. A wide one, as on an even slope, is no ridge: a step falls
            // to 0.6 of its height one sigma away.
            constexpr float kClearly = 0.98f;
            if (s <= side(-1) || s < side(1) || side(-reach) > kClearly * s || side(reach) > kClearly * s) thin.strength[i] = 0;
        }
    return thin;
}

EdgeMap keep_connected(EdgeMap edges, float low, float high) {
    const std::size_t count = edges.strength.size();
    std::vector<std::uint8_t> seen(count);
    std::vector<std::size_t> piece;
    for (std::size_t start = 0; start < count; ++start) {
        if (seen[start] || edges.strength[start] <= 0) continue;
        if (edges.strength[start] < low) {
            edges.strength[start] = 0;
            continue;
        }
        piece.assign(1, start);
        seen[start] = 1;
        bool strong = false;
        for (std::size_t k = 0; k < piece.size(); ++k) {
            strong = strong || edges.strength[piece[k]] >= high;
            const int x = static_cast<int>(piece[k] % static_cast<std::size_t>(edges.width));
            const int y = static_cast<int>(piece[k] / static_cast<std::size_t>(edges.width));
            for (int ny = std::max(y - 1, 0); ny <= std::min(y + 1, edges.height - 1); ++ny)
                for (int nx = std::max(x - 1, 0); nx <= std::min(x + 1, edges.width - 1); ++nx) {
                    const std::size_t n = static_cast<std::size_t>(ny) * static_cast<std::size_t>(edges.width) + static_cast<std::size_t>(nx);
                    if (seen[n] || edges.strength[n] <= 0 || edges.strength[n] < low) continue;
                    seen[n] = 1;
                    piece.push_back(n);
                }
        }
        if (!strong)
            for (const std::size_t i : piece) edges.strength[i] = 0;
    }
    return edges;
}

double noise_level(const Image& grey) {
    if (grey.width < 3 || grey.height < 3) return 0;
    // Second difference in both directions: blind to planes, 6 times the deviation of white noise.
    std::array<std::size_t, 16 * 255 + 1> histogram{};
    std::size_t count = 0;
    for (int y = 1; y + 1 < grey.height; ++y) {
        const std::uint8_t *a = grey.row(y - 1), *b = grey.row(y), *c = grey.row(y + 1);
        for (int x = 1; x + 1 < grey.width; ++x, ++count) {
            const int corners = a[x - 1] + a[x + 1] + c[x - 1] + c[x + 1];
            const int sides = a[x] + c[x] + b[x - 1] + b[x + 1];
            ++histogram[static_cast<std::size_t>(std::abs(corners - 2 * sides + 4 * b[x]))];
        }
    }
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

}  // namespace tactics
