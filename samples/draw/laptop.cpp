// SPDX-License-Identifier: Apache-2.0
// An open laptop computer on a wooden desk by a window.
#include "samples/draw/march.h"
#include "samples/draw/noise.h"
#include "samples/draw/scenes.h"
#include "samples/draw/solid.h"

namespace tactics::samples {

namespace {

// The desk top is y = 0; the hinge lies along x at z = -0.7; the viewer sits at positive z.
struct Laptop {
    Turn lid{0, -0.30f};  // leans back from upright

    Vec3 in_lid(Vec3 p) const { return lid.into(p - Vec3{0, 0.1f, -0.72f}); }

    float screen(Vec3 p) const { return box(in_lid(p), {0, 0.74f, 0}, {1.12f, 0.74f, 0.028f}, 0.025f); }

    static float base(Vec3 p) {
        const float shell = box(p, {0, 0.055f, 0}, {1.12f, 0.055f, 0.76f}, 0.04f);
        const float well = box(p, {0, 0.11f, -0.22f}, {1.0f, 0.018f, 0.36f}, 0.01f);
        const float pad = box(p, {0, 0.112f, 0.47f}, {0.30f, 0.012f, 0.19f}, 0.01f);
        return std::max(std::max(shell, -well), -pad);
    }

    // 12 x 5 keys; the lowest row has a long one in its middle.
    static float keys(Vec3 p) {
        const float step_x = 0.163f, step_z = 0.138f;
        const float row = std::clamp(std::round((p.z + 0.22f) / step_z), -2.0f, 2.0f);
        if (row == 2 && std::abs(p.x) < 3 * step_x)
            return box(p, {0, 0.112f, -0.22f + 2 * step_z}, {2.9f * step_x, 0.016f, 0.056f}, 0.014f);
        const float column = std::clamp(std::floor(p.x / step_x), -6.0f, 5.0f);
        return box(p, {(column + 0.5f) * step_x, 0.112f, -0.22f + row * step_z}, {0.069f, 0.016f, 0.056f}, 0.014f);
    }

    static float cup(Vec3 p) {
        const float out = std::hypot(p.x - 1.62f, p.z + 0.55f);
        const float body = std::max(std::abs(out - 0.20f) - 0.018f, std::abs(p.y - 0.24f) - 0.24f);
        const float handle = ring({p.x - 1.62f, p.y, p.z + 0.55f}, {0.25f, 0.25f, 0}, 0.12f, 0.03f);
        return std::min(std::min(body, std::max(handle, 0.2f - out)), std::max(out - 0.19f, std::abs(p.y - 0.2f) - 0.2f));
    }

    float distance(Vec3 p) const {
        float d = std::min({p.y, base(p), screen(p), cup(p)});
        if (p.y < 0.3f) d = std::min(d, keys(p));
        return d;
    }

    Vec3 picture(Vec3 q) const {
        // What the screen shows: a lake under mountains, with a row of icons.
        const float x = q.x / 1.04f, y = (q.y - 0.76f) / 0.62f;
        Vec3 colour = mix(paint(240, 214, 180), paint(70, 120, 190), clamp01(0.5f + 0.6f * y));
        const float far = 0.05f + 0.5f * (cloud2(x * 1.8f + 9, 1, 5, 3) - 0.35f),
                    near = -0.25f + 0.5f * (cloud2(x * 2.4f + 2, 5, 5, 9) - 0.4f);
        colour = mix(colour, paint(120, 134, 168), ramp(0.01f, -0.01f, y - far));
        colour = mix(colour, paint(44, 66, 74), ramp(0.01f, -0.01f, y - near));
        if (y < -0.42f)
            colour = mix(paint(90, 130, 160), paint(36, 58, 80), clamp01(-y - 0.3f + 0.2f * noise2(x * 8, y * 60, 4)));
        if (y > 0.92f) colour = paint(226, 226, 228);
        return colour;
    }

    Surface surface(Vec3 p, Vec3 n) const {
        if (p.y < 0.004f && n.y > 0.9f) {
            const float board = std::floor(p.z / 0.62f);
            const float grain = cloud2(p.x * 1.2f + board * 7, p.z * 14 + 0.6f * noise2(p.x * 1.5f, board, 3), 4, 12);
            const float gap = ramp(0.0f, 0.012f, std::abs(p.z / 0.62f - std::round(p.z / 0.62f)));
            return {mix(paint(128, 84, 50), paint(190, 142, 92), grain) * (0.4f + 0.6f * gap), 0.16f, 22, 0, {}};
        }
        if (cup(p) < 0.01f)
            return {p.y < 0.42f && std::hypot(p.x - 1.62f, p.z + 0.55f) < 0.17f ? paint(52, 32, 20) : paint(216, 214, 206),
                    0.7f,
                    60,
                    0.1f,
                    {}};
        if (screen(p) < 0.004f) {
            const Vec3 q = in_lid(p);
            if (q.z > 0.02f && std::abs(q.x) < 1.04f && q.y > 0.14f && q.y < 1.38f)
                return {paint(8, 9, 12), 0.5f, 120, 0, picture(q) * 0.82f};
            if (q.z > 0.02f) return {paint(24, 24, 27), 0.4f, 60, 0, {}};
            return {paint(186, 188, 192), 0.5f, 30, 0, {}};
        }
        if (keys(p) < 0.004f) {
            // A light mark on each key.
            const float u = p.x / 0.163f - std::floor(p.x / 0.163f) - 0.5f;
            const float v = (p.z + 0.22f) / 0.138f - std::round((p.z + 0.22f) / 0.138f);
            const bool mark = std::abs(u) < 0.10f && std::abs(v) < 0.14f && noise2(p.x * 70, p.z * 70, 6) > 0.45f && p.z < 0.0f;
            return {mark ? paint(190, 190, 190) : paint(34, 34, 38), 0.25f, 26, 0, {}};
        }
        const float brushed = 0.92f + 0.16f * noise2(p.x * 6, p.z * 160, 2);
        return {paint(176, 178, 184) * brushed, 0.45f, 26, 0, {}};
    }

    Vec3 behind(float x, float y, Vec3) const {
        // The room, far out of focus: a bright window and a plant.
        Vec3 wall = mix(paint(150, 144, 136), paint(188, 184, 176), clamp01(0.5f - 0.4f * x + 0.2f * y));
        const float window = ramp(0.16f, -0.05f, std::max(std::abs(x + 0.62f) - 0.34f, 0.42f - y));
        const float bar = ramp(0.07f, 0.0f, std::abs(x + 0.60f));
        wall = mix(wall, paint(236, 240, 244) * (1 - 0.35f * bar), window * 0.9f);
        const float leaves = cloud2(x * 5, y * 4, 3, 77) + 0.5f - 2.4f * std::hypot(x - 0.78f, (y - 0.45f) * 0.8f);
        return mix(wall, paint(76, 98, 66), 0.8f * ramp(0.1f, 0.5f, leaves));
    }
};

}  // namespace

Image draw_laptop(int size) {
    Lamps lamps;
    lamps.key_from = {-0.65f, 0.9f, 0.25f};
    lamps.key = {1.15f, 1.13f, 1.10f};
    lamps.sky = {0.44f, 0.45f, 0.47f};
    lamps.ground = {0.20f, 0.17f, 0.14f};
    lamps.shadow = 5;
    lamps.reach = 2.2f;
    const Laptop laptop;
    const Camera camera{{-1.25f, 2.35f, 4.6f}, {0.10f, 0.52f, -0.2f}, 2.9f};
    return develop(March(laptop, camera, lamps, 8.2f).take(size, size * 3 / 4), {.gain = 1.05f, .vignette = 0.4f, .seed = 71});
}

}  // namespace tactics::samples
