// SPDX-License-Identifier: Apache-2.0
// A hot air balloon over a valley on a hazy morning.
#include "samples/draw/march.h"
#include "samples/draw/noise.h"
#include "samples/draw/scenes.h"
#include "samples/draw/solid.h"

namespace tactics::samples {

namespace {

struct Balloon {
    static constexpr float kGores = 16;

    // The envelope: a ball above, drawn down to a narrow mouth; each gore bulges between its seams.
    static float envelope(Vec3 p) {
        const float out = std::hypot(p.x, p.z);
        const float bulge = 0.022f * std::abs(std::sin(std::atan2(p.z, p.x) * kGores * 0.5f));
        const float high = p.y - 0.35f;
        // Below the circle on which a cone from the mouth (0.22 wide at y = -1.05) touches the ball, the side is straight.
        const bool straight = high < -0.726f * out;
        const float d =
            straight ? std::max((out - 0.22f) * 0.809f - (p.y + 1.05f) * 0.588f, -1.05f - p.y) : std::hypot(out, high) - 1.0f;
        return d - bulge * clamp01((p.y + 1.2f) * 0.7f);
    }

    static float basket(Vec3 p) { return box(p, {0, -1.76f, 0}, {0.22f, 0.19f, 0.22f}, 0.03f); }

    static float ropes(Vec3 p) {
        const Vec3 m{std::abs(p.x), p.y, std::abs(p.z)};
        return rod(m, {0.16f, -1.06f, 0.16f}, {0.19f, -1.60f, 0.19f}, 0.014f, 0.014f);
    }

    static float people(Vec3 p) {
        const float one = std::min(ball(p, {-0.07f, -1.44f, 0.05f}, 0.05f),
                                   rod(p, {-0.07f, -1.6f, 0.05f}, {-0.07f, -1.53f, 0.05f}, 0.06f, 0.06f));
        return std::min(
            one, std::min(ball(p, {0.08f, -1.46f, 0}, 0.048f), rod(p, {0.08f, -1.6f, 0}, {0.08f, -1.54f, 0}, 0.06f, 0.06f)));
    }

    float distance(Vec3 p) const {
        const float d = envelope(p);
        return 0.8f * (p.y > -0.9f ? d : std::min({d, basket(p), ropes(p), people(p)}));
    }

    Surface surface(Vec3 p, Vec3) const {
        if (p.y < -1.055f) {
            if (basket(p) < 0.01f) {
                const float weave = 0.6f + 0.4f * std::abs(std::sin(p.y * 70) * std::sin((p.x + p.z) * 70));
                const float rim = p.y > -1.62f ? 0.6f : 1.0f;
                return {paint(140, 98, 58) * (weave * rim), 0.05f, 10, 0, {}};
            }
            return {people(p) < 0.01f ? paint(70, 52, 60) : paint(60, 54, 50), 0.05f, 10, 0, {}};
        }
        const float turn = (std::atan2(p.z, p.x) / 6.2831853f + 0.5f) * kGores;
        const int gore = static_cast<int>(turn) % static_cast<int>(kGores);
        const Vec3 bands[4] = {paint(196, 52, 44), paint(236, 190, 74), paint(230, 226, 216), paint(52, 84, 140)};
        Vec3 colour = bands[gore % 4];
        if (p.y > -0.02f && p.y < 0.22f) colour = gore % 2 == 0 ? paint(52, 84, 140) : paint(236, 190, 74);
        if (p.y < -0.78f) colour = paint(60, 62, 78);
        const float seam = std::abs(turn - std::round(turn));
        const float cloth = 0.9f + 0.2f * cloud({p.x * 6, p.y * 6, p.z * 6}, 3);
        // Cloth lets some light through.
        return {colour * (cloth * mix(0.72f, 1.0f, ramp(0.01f, 0.04f, seam))), 0.12f, 14, 0.3f, colour * 0.05f};
    }

    Vec3 behind(float x, float y, Vec3) const {
        const float horizon = -0.62f;
        if (y > horizon) {
            const float up = (y - horizon) / 1.6f;
            Vec3 sky = mix(paint(214, 222, 226), paint(96, 144, 198), clamp01(std::sqrt(up)));
            const float puff = cloud2(x * 2.2f + 3, y * 5.5f, 6, 21) - 0.08f * up;
            sky = mix(sky, paint(246, 244, 240), 0.75f * ramp(0.52f, 0.72f, puff));
            // Ridges, each nearer one darker and lower.
            for (int i = 0; i < 3; ++i) {
                const float level = horizon + 0.20f - 0.08f * static_cast<float>(i) +
                                    0.12f * (cloud2(x * (1.2f + 0.8f * static_cast<float>(i)), 4, 5, 60 + i) - 0.5f);
                const Vec3 ridge = mix(paint(176, 192, 204), paint(92, 116, 104), 0.3f * static_cast<float>(i + 1));
                sky = mix(sky, ridge * (0.92f + 0.16f * cloud2(x * 16, y * 24, 3, 70 + i)), ramp(0.006f, -0.006f, y - level));
            }
            return sky;
        }
        // Fields, drawn together towards the horizon.
        const float deep = 0.25f / (horizon - y + 0.02f);
        const float across = x * deep * 2.2f;
        const float field = chance(static_cast<int>(std::floor(across + 40)), static_cast<int>(std::floor(deep * 1.3f)), 8);
        Vec3 land = mix(paint(112, 132, 66), paint(176, 164, 96), field);
        land = land * (0.7f + 0.6f * cloud2(across * 5, deep * 9, 4, 31));
        const float trees = cloud2(across * 3, deep * 3.5f, 4, 44);
        land = mix(land, paint(46, 64, 40), ramp(0.56f, 0.66f, trees));
        return mix(land, paint(196, 206, 208), clamp01(deep * 0.085f));
    }
};

}  // namespace

Image draw_balloon(int size) {
    Lamps lamps;
    lamps.key_from = {-0.75f, 0.42f, 0.5f};
    lamps.key = {1.5f, 1.38f, 1.15f};
    lamps.sky = {0.42f, 0.50f, 0.60f};
    lamps.ground = {0.26f, 0.26f, 0.22f};
    lamps.reach = 2;
    const Balloon balloon;
    const Camera camera{{0.1f, -0.9f, 9}, {0.06f, -0.30f, 0}, 4.9f};
    return develop(March(balloon, camera, lamps, 13).take(size * 4 / 5, size), {.vignette = 0.3f, .seed = 61});
}

}  // namespace tactics::samples
