// SPDX-License-Identifier: Apache-2.0
#include "filters/edge_map.h"

#include <algorithm>
#include <cmath>

#include "filters/components.h"

namespace tactics {

namespace {

// Beyond the picture there is nothing.
float strength_at(const EdgeMap& map, int x, int y) {
    return x < 0 || y < 0 || x >= map.width || y >= map.height ? 0 : map.strength[pixel_index(map, x, y)];
}

// Between pixels; (x, y) is the middle of a pixel.
float strength_between(const EdgeMap& map, float x, float y) {
    const int left = static_cast<int>(x) - (x < 0 ? 1 : 0), top = static_cast<int>(y) - (y < 0 ? 1 : 0);
    const float fx = x - static_cast<float>(left), fy = y - static_cast<float>(top);
    const auto mean = [=](float a, float b, float c, float d) {
        return (1 - fy) * ((1 - fx) * a + fx * b) + fy * ((1 - fx) * c + fx * d);
    };
    if (left >= 0 && top >= 0 && left + 1 < map.width && top + 1 < map.height) {
        const float *a = &map.strength[pixel_index(map, left, top)], *b = a + map.width;
        return mean(a[0], a[1], b[0], b[1]);
    }
    return mean(strength_at(map, left, top), strength_at(map, left + 1, top), strength_at(map, left, top + 1),
                strength_at(map, left + 1, top + 1));
}

// How the strength is bent: its Hessian.
struct Bend {
    float xx, yy, xy;

    bool ridge() const { return xx + yy < 0; }  // bent down more than up
    /// In which it is bent down most, by the lowest eigenvalue; across the edge on a ridge.
    float angle() const { return std::atan2(-2 * xy, yy - xx) / 2; }
};

Bend bend_at(const EdgeMap& map, int x, int y) {
    const auto bend = [](const auto& at) {
        const float here = 2 * at(0, 0);
        return Bend{at(-1, 0) + at(1, 0) - here, at(0, -1) + at(0, 1) - here,
                    (at(1, 1) + at(-1, -1) - at(1, -1) - at(-1, 1)) / 4};
    };
    if (x > 0 && y > 0 && x + 1 < map.width && y + 1 < map.height) {
        const float* middle = &map.strength[pixel_index(map, x, y)];
        return bend(
            [middle, row = static_cast<std::ptrdiff_t>(map.width)](int right, int down) { return middle[down * row + right]; });
    }
    return bend([&map, x, y](int right, int down) { return strength_at(map, x + right, y + down); });
}

// The strengths across the edge, `steps` pixels from the middle of a pixel.
class Across {
public:
    Across(const EdgeMap& map, int x, int y, float angle)
        : map_(map), x_(static_cast<float>(x)), y_(static_cast<float>(y)), c_(std::cos(angle)), s_(std::sin(angle)) {}
    float operator()(float steps) const { return strength_between(map_, x_ + steps * c_, y_ + steps * s_); }
    Point at(double steps) const {
        return {static_cast<double>(x_) + 0.5 + steps * static_cast<double>(c_),
                static_cast<double>(y_) + 0.5 + steps * static_cast<double>(s_)};
    }

private:
    const EdgeMap& map_;
    float x_, y_, c_, s_;
};

}  // namespace

EdgeMap thin_edges(const EdgeMap& edges, std::optional<double> sigma) {
    const auto reach = static_cast<float>(std::max(sigma.value_or(0), 2.0));
    EdgeMap thin = edges;
    thin.thinned = true;
    for (int y = 0; y < edges.height; ++y)
        for (int x = 0; x < edges.width; ++x) {
            const std::size_t i = pixel_index(edges, x, y);
            const float s = edges.strength[i];
            if (s <= 0) continue;
            float angle = 0;
            if (edges.normal.empty()) {
                const Bend bend = bend_at(edges, x, y);
                if (!bend.ridge()) {
                    thin.strength[i] = 0;
                    continue;
                }
                angle = bend.angle();
            } else {
                angle = edges.normal[i];
            }
            const Across across(edges, x, y, angle);
            // Of two pixels that are alike the first stays.
            bool ridge = s > across(-1) && s >= across(1);
            // A wide plateau, as on an even slope, is no ridge: a step falls to 0.6 of its height one sigma away.
            constexpr float kClearly = 0.98f;
            if (sigma) ridge = ridge && across(-reach) <= kClearly * s && across(reach) <= kClearly * s;
            if (!ridge) thin.strength[i] = 0;
        }
    return thin;
}

Point on_ridge(const EdgeMap& edges, Point at) {
    const int x = static_cast<int>(std::floor(at.x)), y = static_cast<int>(std::floor(at.y));
    if (x < 0 || y < 0 || x >= edges.width || y >= edges.height) return at;
    const Across across(edges, x, y,
                        edges.normal.empty() ? bend_at(edges, x, y).angle() : edges.normal[pixel_index(edges, x, y)]);
    const double before = static_cast<double>(across(-1)), after = static_cast<double>(across(1));
    const double bend = before - 2 * static_cast<double>(strength_at(edges, x, y)) + after;
    if (bend >= 0) return at;
    return across.at(std::clamp((before - after) / (2 * bend), -1.0, 1.0));
}

EdgeMap keep_connected(EdgeMap edges, float low, float high) {
    auto& strength = edges.strength;
    const auto runs = connected_to(
        edges.width, edges.height, [&](std::size_t i) { return strength[i] >= high; },
        [&](std::size_t i) { return strength[i] > 0 && strength[i] >= low; });
    std::vector<float> kept(strength.size(), 0.0f);
    for (const Run& run : runs) {
        const std::size_t begin = pixel_index(edges, run.begin, run.row);
        std::copy_n(strength.begin() + static_cast<std::ptrdiff_t>(begin), run.length(),
                    kept.begin() + static_cast<std::ptrdiff_t>(begin));
    }
    strength = std::move(kept);
    return edges;
}

}  // namespace tactics
