// SPDX-License-Identifier: Apache-2.0
// The illustration of a human heart: muscle, great vessels, coronary arteries on fat, wet gloss, pale paper behind.
#include "samples/draw/march.h"
#include "samples/draw/noise.h"
#include "samples/draw/scenes.h"
#include "samples/draw/solid.h"

namespace tactics::samples {

namespace {

struct Heart {
    enum class Part { muscle, artery, vein, pulmonary };
    struct Near {
        float distance;
        Part part;
    };

    static float tube(Vec3 p, std::initializer_list<Vec3> path, float radius) {
        float d = 1e9f;
        const Vec3* last = nullptr;
        for (const Vec3& point : path) {
            if (last != nullptr) d = std::min(d, rod(p, *last, point, radius, radius));
            last = &point;
        }
        return d;
    }

    static float muscle(Vec3 p) {
        float d = ellipsoid(p, {0.10f, -0.28f, 0}, {0.70f, 0.80f, 0.56f});
        d = join(d, rod(p, {0.05f, -0.25f, 0.1f}, {0.30f, -0.98f, 0.12f}, 0.50f, 0.20f), 0.25f);
        d = join(d, ellipsoid(p, {-0.32f, -0.18f, 0.22f}, {0.42f, 0.56f, 0.40f}), 0.12f);  // right ventricle
        d = join(d, ellipsoid(p, {-0.58f, 0.34f, 0.02f}, {0.30f, 0.34f, 0.34f}), 0.05f);   // right atrium
        d = join(d, ellipsoid(p, {0.52f, 0.36f, -0.05f}, {0.27f, 0.20f, 0.28f}), 0.05f);   // left auricle
        if (d < 0.1f) d -= 0.02f * (cloud(p * 5, 2) - 0.5f);
        return d;
    }

    // The branches that run down over the muscle, as distances in the plane of the picture.
    static float coronary(float x, float y) {
        const auto branch = [&](float x0, float y0, float x1, float y1, float sway, float width) {
            const float length2 = (x1 - x0) * (x1 - x0) + (y1 - y0) * (y1 - y0);
            const float t = clamp01(((x - x0) * (x1 - x0) + (y - y0) * (y1 - y0)) / length2);
            const float bend = sway * std::sin(t * 9) * (1 - t);
            return std::hypot(x - mix(x0, x1, t) - bend, y - mix(y0, y1, t)) - width * (1 - 0.6f * t);
        };
        return std::min(
            {branch(0.12f, 0.34f, 0.22f, -0.95f, 0.05f, 0.045f), branch(0.15f, 0.0f, 0.58f, -0.42f, 0.04f, 0.028f),
             branch(0.13f, -0.32f, 0.46f, -0.74f, -0.04f, 0.022f), branch(0.12f, -0.18f, -0.28f, -0.62f, 0.05f, 0.022f),
             branch(-0.30f, 0.34f, -0.64f, -0.20f, -0.05f, 0.036f), branch(-0.60f, -0.1f, -0.28f, -0.38f, 0.03f, 0.02f)});
    }

    static Near nearest(Vec3 p) {
        float wall = muscle(p);
        const float line = wall < 0.15f && p.z > 0 ? coronary(p.x, p.y) : 1.0f;
        wall -= 0.03f * ramp(0.03f, -0.02f, line);
        Near near{wall, Part::muscle};
        if (p.y < 0.05f) return near.distance < 0.3f ? near : Near{std::min(near.distance, std::max(0.3f, -p.y)), Part::muscle};
        const auto take = [&](float d, Part part) {
            const float joined = join(near.distance, d, 0.06f);
            if (d < near.distance) near.part = part;
            near.distance = joined;
        };
        // Aorta: up, over and behind, with three branches.
        const float arch = std::max(ring(p, {0.10f, 0.80f, -0.08f}, 0.27f, 0.165f), 0.75f - p.y);
        float aorta = std::min(arch, tube(p, {{-0.17f, 0.80f, -0.08f}, {-0.08f, 0.25f, 0.05f}}, 0.165f));
        aorta = std::min(aorta, tube(p, {{0.37f, 0.80f, -0.08f}, {0.40f, 0.1f, -0.45f}}, 0.15f));
        for (int i = 0; i < 3; ++i) {
            const float x = -0.08f + 0.16f * static_cast<float>(i);
            const float branch =
                rod(p, {x, 1.02f, -0.08f}, {x - 0.05f + 0.06f * static_cast<float>(i), 1.42f, -0.1f}, 0.068f, 0.062f);
            aorta = join(aorta, std::max(branch, p.y - 1.36f), 0.05f);
        }
        take(aorta, Part::artery);
        float trunk =
            tube(p, {{0.02f, 0.12f, 0.36f}, {0.12f, 0.42f, 0.30f}, {0.38f, 0.58f, 0.08f}, {0.80f, 0.66f, -0.02f}}, 0.155f);
        take(std::max(trunk, p.x - 0.76f), Part::pulmonary);
        const float cava = tube(p, {{-0.50f, 1.30f, -0.05f}, {-0.54f, 0.30f, 0.0f}}, 0.15f);
        take(std::max(cava, p.y - 1.22f), Part::vein);
        return near;
    }

    float distance(Vec3 p) const { return 0.75f * nearest(p).distance; }

    Surface surface(Vec3 p, Vec3) const {
        const float mottle = cloud(p * 7, 4);
        switch (nearest(p).part) {
            case Part::artery: return {paint(186, 62, 52) * (0.8f + 0.4f * mottle), 0.5f, 40, 0.1f, {}};
            case Part::vein: return {paint(92, 100, 150) * (0.8f + 0.4f * mottle), 0.5f, 40, 0.1f, {}};
            case Part::pulmonary: return {paint(122, 120, 164) * (0.8f + 0.4f * mottle), 0.5f, 40, 0.1f, {}};
            case Part::muscle: break;
        }
        const float fibres = noise({(p.x + 0.5f * p.y) * 42, (p.y - 0.5f * p.x) * 5, p.z * 8});
        Vec3 colour = paint(150, 56, 48) * (0.72f + 0.3f * fibres + 0.3f * mottle);
        const float line = p.z > 0 ? coronary(p.x, p.y) : 1.0f;
        colour = mix(colour, paint(224, 178, 120), 0.75f * ramp(0.085f, 0.03f, line + 0.05f * (mottle - 0.5f)));
        colour = mix(colour, paint(168, 34, 32), ramp(0.008f, -0.004f, line));
        return {colour, 0.55f, 45, 0.12f, {}};
    }

    Vec3 behind(float x, float y, Vec3) const {
        const float shade = 0.30f * std::exp(-3.0f * ((x - 0.14f) * (x - 0.14f) + (y + 0.10f) * (y + 0.10f) * 0.6f));
        return paint(226, 220, 206) * (0.92f + 0.10f * y - shade + 0.06f * cloud2(x * 3, y * 3, 4, 5));
    }
};

}  // namespace

Image draw_heart(int size) {
    Lamps lamps;
    lamps.key_from = {-0.5f, 0.65f, 0.75f};
    lamps.key = {1.4f, 1.35f, 1.28f};
    lamps.sky = {0.42f, 0.44f, 0.48f};
    lamps.ground = {0.26f, 0.22f, 0.2f};
    lamps.rim = {0.22f, 0.22f, 0.25f};
    lamps.reach = 1.4f;
    const Heart heart;
    const Camera camera{{0, 0.15f, 9}, {0, 0.14f, 0}, 6.0f};
    return develop(March(heart, camera, lamps, 12).take(size * 9 / 10, size), {.vignette = 0.2f, .seed = 53});
}

}  // namespace tactics::samples
