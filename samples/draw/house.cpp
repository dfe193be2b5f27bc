// SPDX-License-Identifier: Apache-2.0
// A brick house with a tiled roof behind a lawn, a tree beside it, an afternoon sky.
#include "samples/draw/march.h"
#include "samples/draw/noise.h"
#include "samples/draw/scenes.h"
#include "samples/draw/solid.h"

namespace tactics::samples {

namespace {

// The ground is y = 0; the front of the house is z = 1, 4 wide (x from -2 to 2); the wall ends at y = 1.7.
struct House {
    static constexpr float kRidge = 3.1f, kHalf = 2.0f, kDepth = 1.0f;

    static float walls(Vec3 p) {
        // The gable is part of the wall: the front shows it whole.
        const float side = std::max(std::abs(p.x) - kHalf, std::abs(p.z) - kDepth);
        const float under_roof = (p.y - kRidge + 0.08f + std::abs(p.x) * 0.7f) * 0.82f;
        return std::max(side, under_roof);
    }

    static float roof(Vec3 p) {
        // Two slabs of slope 0.7, thicker than the eye expects so that their edge shows.
        const float slope = (p.y - kRidge + std::abs(p.x) * 0.7f) * 0.82f;
        const float slab = std::abs(slope - 0.05f) - 0.075f;
        return std::max({slab, std::abs(p.x) - 2.42f, std::abs(p.z) - 1.32f});
    }

    static float chimney(Vec3 p) {
        return std::min(box(p, {1.05f, 2.95f, -0.3f}, {0.22f, 0.65f, 0.22f}, 0.01f),
                        box(p, {1.05f, 3.62f, -0.3f}, {0.27f, 0.06f, 0.27f}, 0.01f));
    }

    // Window frames, sills, the door and its steps: all that stands out from the front wall.
    static float joinery(Vec3 p) {
        const auto frame = [&](float x, float y, float w, float h) {
            const Vec3 q = p - Vec3{x, y, 1};
            const float outer = box(q, {0, 0, 0}, {w, h, 0.06f}, 0.01f);
            const float hole = box(q, {0, 0, 0}, {w - 0.06f, h - 0.06f, 0.3f}, 0);
            const float bars = std::max(std::min(std::abs(q.x), std::abs(q.y)) - 0.022f, outer + 0.02f);
            const float sill = box(q, {0, -h - 0.05f, 0.06f}, {w + 0.08f, 0.04f, 0.1f}, 0.01f);
            return std::min({std::max(outer, -hole), bars, sill});
        };
        const float d =
            std::min({frame(-1.15f, 0.98f, 0.42f, 0.44f), frame(1.15f, 0.98f, 0.42f, 0.44f), frame(0, 2.05f, 0.32f, 0.34f)});
        const float door_frame =
            std::max(box(p, {0, 0.66f, 1}, {0.40f, 0.70f, 0.07f}, 0.01f), -box(p, {0, 0.6f, 1}, {0.33f, 0.69f, 0.3f}, 0));
        const float steps = std::min(box(p, {0, 0.05f, 1.3f}, {0.62f, 0.05f, 0.32f}, 0.01f),
                                     box(p, {0, 1.46f, 1.16f}, {0.6f, 0.05f, 0.24f}, 0.02f));
        return std::min({d, door_frame, steps});
    }

    static float panes(Vec3 p) {
        const auto pane = [&](float x, float y, float w, float h) { return box(p, {x, y, 0.985f}, {w, h, 0.03f}, 0); };
        return std::min({pane(-1.15f, 0.98f, 0.40f, 0.42f), pane(1.15f, 0.98f, 0.40f, 0.42f), pane(0, 2.05f, 0.30f, 0.32f)});
    }

    static float door(Vec3 p) { return box(p, {0, 0.62f, 0.99f}, {0.34f, 0.68f, 0.035f}, 0); }

    static float tree(Vec3 p) {
        const float trunk = rod(p, {-3.35f, 0, 0.4f}, {-3.25f, 1.5f, 0.4f}, 0.17f, 0.11f);
        float crown = ball(p, {-3.3f, 2.2f, 0.4f}, 0.85f);
        if (crown > 1.2f) return std::min(trunk, crown - 0.7f);
        for (const Vec3 c :
             {Vec3{-3.85f, 1.9f, 0.6f}, Vec3{-2.85f, 1.85f, 0.7f}, Vec3{-3.2f, 2.75f, 0.3f}, Vec3{-3.7f, 2.45f, 0.1f}})
            crown = join(crown, ball(p, c, 0.55f), 0.2f);
        if (crown < 0.3f) crown += 0.42f * (cloud(p * 4.5f, 3) - 0.5f);
        return std::min(trunk, 0.6f * crown);
    }

    static float bushes(Vec3 p) {
        float d = 1e9f;
        for (const float x : {-1.75f, -0.95f, 0.95f, 1.7f})
            d = std::min(d, ellipsoid(p, {x, 0.12f, 1.28f}, {0.38f, 0.30f, 0.22f}));
        if (d < 0.2f) d += 0.12f * (noise(p * 12) - 0.5f);
        return 0.7f * d;
    }

    static float ground(Vec3 p) { return p.y; }

    float distance(Vec3 p) const {
        float d = std::min(ground(p), tree(p));
        // Nothing of the house is nearer than its bounding box.
        const float bound = box(p, {0, 1.85f, 0.1f}, {2.6f, 1.95f, 1.65f}, 0);
        if (bound > 0.5f) return std::min(d, bound);
        d = std::min({d, walls(p), roof(p), chimney(p), bushes(p), panes(p), door(p)});
        if (p.z > 0.7f) d = std::min(d, joinery(p));
        return d;
    }

    static Vec3 brick(float along, float up) {
        const float course = std::floor(up / 0.085f);
        const float shift = static_cast<int>(course) % 2 == 0 ? 0.0f : 0.5f;
        const float u = along / 0.24f + shift, v = up / 0.085f;
        const float one = chance(static_cast<int>(std::floor(u)), static_cast<int>(course), 3);
        const float joint =
            std::min(ramp(0.0f, 0.06f, std::abs(u - std::round(u))), ramp(0.03f, 0.12f, std::abs(v - std::round(v))));
        const Vec3 clay = mix(paint(142, 74, 56), paint(178, 104, 76), one) * (0.85f + 0.3f * noise2(along * 40, up * 40, 2));
        return mix(paint(176, 166, 152), clay, 0.3f + 0.7f * joint);
    }

    Surface surface(Vec3 p, Vec3 n) const {
        constexpr float kNear = 0.02f;
        if (p.y < 0.02f && n.y > 0.8f) {
            const float bend = 0.25f * std::sin(p.z * 0.7f);
            const float path = std::abs(p.x - bend * ramp(1.6f, 3.0f, p.z)) - 0.42f - 0.05f * noise2(p.x * 6, p.z * 6, 9);
            if (p.z > 1 && path < 0)
                return {paint(176, 166, 150) * (0.75f + 0.45f * cloud2(p.x * 9, p.z * 9, 4, 3)), 0, 8, 0, {}};
            const float blades = noise2(p.x * 90, p.z * 34, 5), patch = cloud2(p.x * 1.3f, p.z * 1.3f, 3, 6);
            return {mix(paint(74, 104, 44), paint(130, 144, 72), patch) * (0.55f + 0.8f * blades), 0, 8, 0.3f, {}};
        }
        if (tree(p) < kNear) {
            if (p.y < 1.5f && std::hypot(p.x + 3.3f, p.z - 0.4f) < 0.24f)
                return {paint(92, 72, 54) * (0.6f + 0.7f * noise2(p.x * 30, p.y * 6, 1)), 0, 8, 0, {}};
            return {mix(paint(52, 80, 34), paint(112, 132, 58), noise(p * 16)) * (0.55f + 0.8f * noise(p * 40)), 0, 8, 0.4f, {}};
        }
        if (p.z > 0.7f && joinery(p) < 0.006f)
            return {paint(222, 218, 208) * (0.92f + 0.1f * noise2(p.x * 20, p.y * 20, 8)), 0.1f, 20, 0, {}};
        if (bushes(p) < kNear) return {mix(paint(40, 72, 36), paint(96, 120, 60), noise(p * 30)), 0, 8, 0.3f, {}};
        if (panes(p) < kNear && p.z > 0.99f) {
            const float curtain = ramp(0.10f, 0.24f, std::abs(std::abs(p.x) > 0.5f ? std::abs(p.x) - 1.15f : p.x));
            const float sky = 0.25f + 0.5f * cloud2(p.x * 3, p.y * 3 + p.x, 3, 4);
            return {mix(paint(40, 48, 58), paint(160, 156, 148), 0.45f * curtain), 0.6f, 90, 0,
                    paint(150, 176, 204) * (0.22f * sky)};
        }
        if (door(p) < kNear && p.z > 0.99f) {
            const float panel = std::max(std::abs(std::abs(p.x) - 0.16f) - 0.10f, std::abs(std::abs(p.y - 0.66f) - 0.3f) - 0.2f);
            const Vec3 green = paint(40, 74, 62) * (0.9f + 0.2f * noise2(p.x * 40, p.y * 8, 1));
            if (std::hypot(p.x - 0.27f, p.y - 0.62f) < 0.03f) return {paint(206, 178, 90), 0.8f, 40, 0, {}};
            return {green * mix(0.55f, 1.0f, ramp(0.0f, 0.02f, std::abs(panel))), 0.2f, 24, 0, {}};
        }
        if (chimney(p) < kNear) return {brick(std::abs(n.x) > 0.5f ? p.z : p.x, p.y), 0, 8, 0, {}};
        if (roof(p) < kNear) {
            if (n.y < 0.3f) return {paint(226, 222, 212), 0.05f, 12, 0, {}};
            const float row = p.x / 0.16f, tile = p.z / 0.2f + (static_cast<int>(std::floor(row)) % 2 == 0 ? 0.5f : 0.0f);
            const float one = chance(static_cast<int>(std::floor(tile)), static_cast<int>(std::floor(row)), 11);
            const float edge = 0.55f + 0.45f * ramp(0.0f, 0.3f, row - std::floor(row));
            return {mix(paint(92, 60, 54), paint(136, 88, 72), one) * edge, 0.05f, 12, 0, {}};
        }
        return {brick(std::abs(n.x) > 0.5f ? p.z : p.x, p.y), 0.02f, 8, 0, {}};
    }

    Vec3 behind(float x, float y, Vec3 ray) const {
        const float up = std::max(ray.y, 0.0f);
        Vec3 sky = mix(paint(206, 220, 232), paint(84, 136, 200), clamp01(1.8f * std::sqrt(up)));
        const float puff = cloud2(x * 1.8f + 5, y * 3.6f, 6, 90);
        sky = mix(sky, paint(248, 246, 242), 0.85f * ramp(0.50f, 0.68f, puff));
        // Woods on the horizon.
        const float woods = 0.035f + 0.06f * cloud2(x * 5, 2, 5, 33);
        const Vec3 leaves = mix(paint(70, 92, 66), paint(116, 132, 96), cloud2(x * 26, y * 30, 4, 35));
        sky = mix(sky, leaves, ramp(0.006f, -0.006f, ray.y - woods));
        return mix(sky, paint(96, 118, 60), ramp(-0.004f, -0.012f, ray.y));
    }
};

}  // namespace

Image draw_house(int size) {
    Lamps lamps;
    lamps.key_from = {-0.55f, 0.75f, 0.8f};
    lamps.key = {1.45f, 1.36f, 1.18f};
    lamps.sky = {0.36f, 0.43f, 0.54f};
    lamps.ground = {0.18f, 0.19f, 0.13f};
    lamps.shadow = 14;
    lamps.reach = 5;
    const House house;
    const Camera camera{{1.7f, 1.55f, 9.5f}, {-0.42f, 1.62f, 0}, 2.55f};
    return develop(March(house, camera, lamps, 40).take(size, size * 3 / 4), {.vignette = 0.35f, .seed = 83});
}

}  // namespace tactics::samples
