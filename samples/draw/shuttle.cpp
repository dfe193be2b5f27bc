// SPDX-License-Identifier: Apache-2.0
// The launch of a space shuttle: orbiter, tank and two boosters on their flames above a growing cloud.
#include "samples/draw/march.h"
#include "samples/draw/noise.h"
#include "samples/draw/scenes.h"
#include "samples/draw/solid.h"

namespace tactics::samples {

namespace {

// The stack stands along y, its foot at y = 0 and the tip of the tank at y = 4.7; the orbiter's back faces the viewer.
struct Shuttle {
    enum class Part { tank, booster, orbiter, flame, smoke, tower };
    struct Near {
        float distance;
        Part part;
    };

    static float tank(Vec3 p) {
        const float out = std::hypot(p.x, p.z);
        const float body = std::max(out - 0.42f, std::abs(p.y - 1.9f) - 1.7f);
        return join(body, ellipsoid(p, {0, 3.55f, 0}, {0.42f, 1.15f, 0.42f}), 0.05f);
    }

    static float boosters(Vec3 p) {
        const Vec3 m{std::abs(p.x) - 0.66f, p.y, p.z};
        const float out = std::hypot(m.x, m.z);
        float d = std::max(out - 0.19f, std::abs(p.y - 1.75f) - 1.7f);
        d = std::min(d, rod(m, {0, 3.4f, 0}, {0, 3.86f, 0}, 0.19f, 0.03f));
        return std::min(d, std::max(out - mix(0.28f, 0.17f, clamp01((p.y + 0.15f) / 0.5f)), std::abs(p.y - 0.1f) - 0.25f));
    }

    static float orbiter(Vec3 p) {
        const Vec3 m{std::abs(p.x), p.y, p.z};
        float d = rod(p, {0, 0.75f, 0.72f}, {0, 2.75f, 0.72f}, 0.27f, 0.25f);
        d = join(d, ellipsoid(p, {0, 2.85f, 0.68f}, {0.25f, 0.52f, 0.24f}), 0.1f);  // nose
        // Delta wing with its strake: a thin plate, bounded by two slanting edges.
        const float edge = std::max((m.x - 0.98f + 0.62f * (p.y - 0.42f)) * 0.85f, 0.34f - p.y);
        const float strake = std::max((m.x - 0.42f + 0.16f * (p.y - 1.2f)) * 0.95f, std::abs(p.y - 1.4f) - 0.95f);
        const float plate = std::max(std::min(std::max(edge, m.x - 0.98f), strake), std::abs(p.z - 0.58f) - 0.05f);
        d = join(d, plate, 0.06f);
        // Tail fin and the engine pods beside it.
        const float fin = std::max({std::abs(p.x) - 0.045f, 0.45f - p.y - 0.25f * (p.z - 1.0f),
                                    (p.y - 1.35f + 0.9f * (p.z - 0.9f)) * 0.74f, p.z - 1.62f, 0.7f - p.z});
        d = std::min(d, fin);
        d = join(d, rod(m, {0.24f, 0.55f, 0.90f}, {0.22f, 1.0f, 0.88f}, 0.15f, 0.10f), 0.06f);
        for (const Vec3 c : {Vec3{0.15f, 0.32f, 0.72f}, Vec3{0, 0.34f, 0.95f}}) {
            const float out = std::hypot(m.x - c.x, p.z - c.z);
            d = std::min(d, std::max(out - mix(0.15f, 0.08f, clamp01((p.y - 0.15f) / 0.4f)), std::abs(p.y - 0.35f) - 0.2f));
        }
        return d;
    }

    static float flames(Vec3 p) {
        const Vec3 m{std::abs(p.x) - 0.66f, p.y, p.z};
        const float below = clamp01(-p.y / 2.4f);
        const float flicker = p.y < 0 && p.y > -2.6f ? 0.10f * below * (noise({p.x * 7, p.y * 3, p.z * 7}) - 0.5f) : 0.0f;
        return 0.7f * (rod(m, {0, -0.15f, 0}, {0, -2.5f, 0}, 0.20f, 0.34f) - flicker);
    }

    static float smoke(Vec3 p) {
        if (p.y > 0.4f) return p.y + 0.4f;
        float d = p.y + 2.75f;
        for (const Vec3 c :
             {Vec3{-1.5f, -2.5f, 0.1f}, Vec3{1.4f, -2.6f, 0.3f}, Vec3{-2.7f, -2.55f, -0.5f}, Vec3{2.7f, -2.45f, -0.6f},
              Vec3{0, -3.0f, 1.0f}, Vec3{-0.85f, -2.25f, -0.6f}, Vec3{0.95f, -2.2f, -0.7f}, Vec3{-3.7f, -2.9f, 0.0f},
              Vec3{3.7f, -2.85f, 0.1f}, Vec3{0.1f, -2.2f, -1.0f}})
            d = join(d, ball(p, c, 0.72f + 0.12f * c.z), 0.3f);
        if (d < 0.8f) d += 0.7f * (cloud(p * 1.5f, 4) - 0.5f) * ramp(0.8f, 0.3f, d);
        return 0.62f * d;
    }

    static float tower(Vec3 p) {
        // A lattice of four legs with floors, behind and to the left.
        const Vec3 q = p - Vec3{-2.5f, -1.5f, -3.0f};
        const float bound = std::max(std::abs(q.x) - 0.45f, std::max(std::abs(q.z) - 0.4f, q.y - 4.4f));
        if (bound > 0.4f) return bound;
        const Vec3 m{std::abs(q.x) - 0.32f, q.y, std::abs(q.z) - 0.3f};
        float d = std::max(std::max(std::abs(m.x), std::abs(m.z)) - 0.04f, q.y - 4.1f);
        const float level = q.y - std::round(q.y / 0.62f) * 0.62f;
        d = std::min(
            d, std::max(std::max(std::abs(level) - 0.035f, std::abs(q.x) - 0.36f), std::max(std::abs(q.z) - 0.34f, q.y - 4.1f)));
        d = std::min(d, rod(q, {0, 4.0f, 0}, {0, 5.1f, 0}, 0.05f, 0.02f));
        return std::min(d, box(q, {0.55f, 3.1f, 0}, {0.55f, 0.05f, 0.07f}, 0.01f));
    }

    static Near nearest(Vec3 p) {
        Near near{smoke(p), Part::smoke};
        const auto take = [&](float d, Part part) {
            if (d < near.distance) near = {d, part};
        };
        const float stack = std::max({std::abs(p.x) - 1.05f, -0.35f - p.y, p.y - 4.75f});
        if (stack > 0.4f)
            take(stack, Part::tank);
        else {
            take(tank(p), Part::tank);
            take(boosters(p), Part::booster);
            take(orbiter(p), Part::orbiter);
        }
        take(flames(p), Part::flame);
        take(tower(p), Part::tower);
        return near;
    }

    float distance(Vec3 p) const { return 0.9f * nearest(p).distance; }

    Surface surface(Vec3 p, Vec3 n) const {
        switch (nearest(p).part) {
            case Part::tank: {
                const float rings = 0.94f + 0.06f * std::sin(p.y * 60);
                return {paint(188, 106, 52) * (rings * (0.85f + 0.3f * cloud(p * 5, 4))), 0.03f, 10, 0, {}};
            }
            case Part::booster: {
                const float joints = ramp(0.0f, 0.03f, std::abs(p.y - std::round(p.y / 0.8f) * 0.8f));
                Vec3 white = paint(222, 220, 216) * (0.65f + 0.35f * joints) * (0.9f + 0.2f * noise(p * Vec3{6, 2, 6}));
                if (p.y < 0.3f) white = paint(96, 92, 92);
                return {white, 0.08f, 16, 0, {}};
            }
            case Part::orbiter: {
                const bool under = n.z < -0.3f || std::hypot(p.x, p.y - 3.3f) < 0.16f;
                Vec3 colour = under ? paint(44, 44, 50) : paint(232, 230, 226) * (0.92f + 0.12f * noise(p * 9));
                if (p.y < 0.52f && std::abs(p.x) < 0.32f) colour = paint(70, 68, 70);
                // Windows, the joint of the bay doors, the dark leading edges.
                if (p.y > 2.72f && p.y < 2.86f && p.z > 0.80f && std::abs(p.x) < 0.17f &&
                    std::abs(std::fmod(std::abs(p.x), 0.09f) - 0.045f) > 0.012f)
                    colour = paint(24, 24, 30);
                if (std::abs(p.x) < 0.012f && p.y > 0.9f && p.y < 2.6f) colour = colour * 0.5f;
                const float lead = std::abs(p.x) - 0.98f + 0.62f * (p.y - 0.42f);
                if (p.z < 0.66f && lead > -0.06f && std::abs(p.x) > 0.3f) colour = paint(54, 54, 58);
                if (p.z < 0.66f && std::abs(p.x) > 0.4f && p.y < 0.45f) colour = colour * 0.6f;
                return {colour, 0.12f, 20, 0, {}};
            }
            case Part::flame: {
                const float low = clamp01(-p.y / 2.4f);
                return {paint(255, 230, 180), 0, 8, 1, mix(Vec3{1.6f, 1.45f, 1.0f}, Vec3{1.5f, 0.85f, 0.32f}, low)};
            }
            case Part::tower: return {paint(150, 158, 168) * (0.8f + 0.3f * noise(p * 12)), 0.05f, 10, 0, {}};
            case Part::smoke: break;
        }
        // Lit from inside near the flames.
        const float heat =
            std::exp(-1.1f * std::max(std::min(std::hypot(p.x - 0.66f, p.z), std::hypot(p.x + 0.66f, p.z)) - 0.2f, 0.0f)) *
            ramp(-3.0f, -1.6f, p.y);
        return {paint(228, 224, 218) * (0.9f + 0.2f * cloud(p * 6, 3)), 0, 8, 0.7f,
                Vec3{0.95f, 0.55f, 0.22f} * (0.8f * heat) + Vec3{0.07f, 0.07f, 0.08f}};
    }

    Vec3 behind(float x, float y, Vec3) const {
        Vec3 sky = mix(paint(196, 210, 222), paint(52, 98, 168), clamp01(0.25f + 0.55f * (y + 0.5f)));
        const float veil = cloud2(x * 1.3f + 2, y * 4.5f, 6, 14);
        sky = mix(sky, paint(228, 230, 232), 0.45f * ramp(0.5f, 0.75f, veil));
        const float glow = std::exp(-3.5f * (x * x * 1.6f + (y + 0.62f) * (y + 0.62f)));
        return sky + Vec3{0.35f, 0.24f, 0.12f} * glow;
    }
};

}  // namespace

Image draw_shuttle(int size) {
    Lamps lamps;
    lamps.key_from = {-0.7f, 0.5f, 0.7f};
    lamps.key = {1.4f, 1.32f, 1.18f};
    lamps.sky = {0.32f, 0.38f, 0.47f};
    lamps.ground = {0.42f, 0.30f, 0.18f};  // the flames light everything from below
    lamps.shadow = 10;
    lamps.reach = 2;
    const Shuttle shuttle;
    const Camera camera{{1.6f, -0.6f, 14}, {-0.12f, 1.0f, 0}, 3.55f};
    return develop(March(shuttle, camera, lamps, 24).take(size * 4 / 5, size), {.vignette = 0.3f, .seed = 97});
}

}  // namespace tactics::samples
