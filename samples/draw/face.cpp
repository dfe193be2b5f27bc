// SPDX-License-Identifier: Apache-2.0
#include "samples/draw/face.h"

#include "samples/draw/noise.h"
#include "samples/draw/solid.h"

namespace tactics::samples {

namespace {

constexpr Vec3 kEye{0.295f, 0.06f, 0.6f};
constexpr float kEyeRadius = 0.142f;

// The slit of the lids: the part that two circles share, seen from the front. Negative inside, x mirrored.
float lid_slit(float x, float y) {
    const float dx = x - kEye.x, dy = y - kEye.y - 0.06f * (x - kEye.x);
    const float upper = std::sqrt(dx * dx + (dy + 0.160f) * (dy + 0.160f)) - 0.222f;
    const float lower = std::sqrt(dx * dx + (dy - 0.245f) * (dy - 0.245f)) - 0.292f;
    return std::max(upper, lower);
}

float mouth_height(const Person& who, float x) { return -0.60f - who.length + who.smile * 9 * x * x - 0.010f * std::cos(x * 20); }

}  // namespace

float Face::head(Vec3 q) const {
    const Vec3 m{std::abs(q.x), q.y, q.z};
    const float low = who_.length;
    float d = ellipsoid(q, {0, 0.34f, -0.14f}, {0.71f, 0.80f, 0.88f});
    if (d > 1.1f) return d - 0.5f;  // far away nothing else matters
    d = join(d, ellipsoid(q, {0, -0.28f - 0.5f * low, 0.12f}, {who_.jaw + 0.05f, 0.78f + 0.5f * low, 0.62f}), 0.22f);
    if (d > 0.5f) return d - 0.3f;
    d = join(d, rod(m, {0, -0.95f - low, 0.44f}, {0.13f, -0.93f - low, 0.40f}, 0.15f, 0.14f), 0.26f);                 // chin
    d = join(d, rod(m, {0.66f * who_.jaw, -0.56f - low, 0.04f}, {0.14f, -0.86f - low, 0.34f}, 0.13f, 0.14f), 0.25f);  // jaw
    d = join(d, ball(m, {0.36f, -0.16f, 0.44f}, 0.22f), 0.2f);                                                        // cheeks
    d = join(d, rod(m, {0, 0.26f, 0.66f}, {0.40f, 0.25f, 0.52f}, 0.10f, 0.09f), 0.14f);                               // brow
    d = q.z > 0.2f ? features(q, d) : ears(m, d);
    if (who_.beard > 0 && d < 0.2f) {
        const float hairs = 0.6f + 0.8f * noise(q * Vec3{22, 8, 22});
        d -= who_.beard * 0.05f * beard_at(q) * hairs;
    }
    return d;
}

float Face::ears(Vec3 m, float d) const {
    const float rim = ellipsoid(m, {0.73f, 0.0f, -0.08f}, {0.07f, 0.21f, 0.14f});
    return join(d, carve(rim, ellipsoid(m, {0.81f, 0.03f, -0.02f}, {0.05f, 0.14f, 0.08f}), 0.04f), 0.05f);
}

// How much of a beard grows at a place: below a line from the ear to the corner of the mouth, round the lips, and above.
float Face::beard_at(Vec3 q) const {
    const float x = std::abs(q.x), above = q.y - mouth_height(who_, q.x);
    const float edge = 0.03f * (noise({q.x * 20, q.y * 20, 2}) - 0.5f);
    float region = ramp(0.05f, -0.05f, q.y + 0.58f - 2.0f * std::max(x - 0.34f, 0.0f) + edge) * ramp(-0.40f, -0.15f, q.z) *
                   ramp(-1.22f, -1.08f, q.y - 0.35f * std::min(0.25f - q.z, 0.0f));
    const float moustache =
        ramp(0.36f, 0.30f, x) * ramp(0.075f, 0.10f, above + edge) * ramp(0.23f, 0.18f, above + 0.25f * x + edge);
    region = std::max(region, moustache);
    return region * ramp(1.0f, 1.35f, std::hypot(x / 0.26f, (above + 0.015f) / 0.10f));
}

// Everything from the brow to the lips; `d` is the head without it.
float Face::features(Vec3 q, float d) const {
    const Vec3 m{std::abs(q.x), q.y, q.z};
    const float low = who_.length;
    d = carve(d, ellipsoid(m, {0.29f, 0.07f, 0.84f}, {0.19f, 0.12f, 0.16f}), 0.16f);    // sockets
    d = join(d, ellipsoid(q, {0, -0.62f - low, 0.50f}, {0.33f, 0.24f, 0.22f}), 0.15f);  // round the mouth
    const float tip = who_.nose;
    d = join(d, rod(q, {0, 0.16f, 0.68f}, {0, -0.25f, 0.90f + 0.3f * tip}, 0.062f, 0.8f * tip), 0.11f);
    d = join(d, rod(m, {0.03f, -0.27f, 0.90f}, {0.7f * tip + 0.045f, -0.305f, 0.79f}, 0.055f, 0.062f), 0.05f);
    d = carve(d, ellipsoid(m, {0.06f, -0.37f, 0.89f}, {0.034f, 0.028f, 0.05f}), 0.03f);  // nostrils
    // Lids: a shell round the eyeball, open at the slit, thicker above.
    const float shell = ball(m, kEye, kEyeRadius + 0.022f);
    d = join(d, carve(shell, std::max(lid_slit(m.x, m.y), 0.5f - m.z), 0.012f), 0.05f);
    d = std::max(d, -std::max({lid_slit(m.x, m.y), 0.55f - m.z, ball(m, kEye, kEyeRadius + 0.05f)}));
    // Lips meet at the mouth's line, which rises with the smile.
    const float line = mouth_height(who_, q.x);
    const float full = who_.lips;
    const Vec3 lip{m.x, q.y - line, q.z};
    d = join(d, rod(lip, {0.05f, 0.042f * full, 0.70f}, {0.27f, 0.006f, 0.59f}, 0.042f * full, 0.012f), 0.05f);
    d = join(d, rod(lip, {0, -0.055f * full, 0.69f}, {0.23f, -0.020f, 0.60f}, 0.055f * full, 0.016f), 0.05f);
    d = carve(d, rod(lip, {0, -0.002f, 0.765f}, {0.30f, 0.0f, 0.62f}, 0.013f, 0.008f), 0.03f);
    return d;
}

float Face::hair(Vec3 q) const {
    const Vec3 m{std::abs(q.x), q.y, q.z};
    const float parting = 0.05f * std::sin(q.x * 3 + 0.8f);
    float d = ellipsoid(q, {0, 0.40f, -0.18f}, {0.79f, 0.84f, 0.93f});
    const bool falls = who_.style == Person::Hair::long_;
    if (d > (falls ? 1.5f : 0.8f)) return d - (falls ? 1.2f : 0.35f);
    const float ragged = d < 0.1f ? 0.07f * (noise({q.x * 16, q.y * 7, q.z * 7}) - 0.5f) : 0.0f;
    switch (who_.style) {
        case Person::Hair::long_: {
            // The face looks out of an oval; two falls of hair go down beside it to the shoulders.
            const float oval = ellipsoid(q, {0, -0.22f + parting, 0.9f}, {0.60f, 0.86f, 0.95f});
            const float wave = 0.05f * std::sin(q.y * 6 + (q.x > 0 ? 1.0f : 0.0f));
            d = join(d, rod({m.x + wave, q.y, q.z}, {0.60f, 0.2f, -0.12f}, {0.70f, -1.85f, 0.10f}, 0.27f, 0.20f), 0.3f);
            d = join(d, ellipsoid(q, {0, -0.5f, -0.5f}, {0.72f, 1.1f, 0.4f}), 0.2f);
            d = carve(d, oval + 0.4f * ragged, 0.06f);
            break;
        }
        case Person::Hair::short_: {
            d += 0.02f;
            d = carve(d, ellipsoid(q, {0, -0.33f - parting, 0.72f}, {0.70f, 1.03f, 0.84f}) + ragged, 0.03f);
            d = std::max(d, -0.02f - q.y + 0.6f * (m.x - 0.7f) + ragged - 0.5f * std::max(-q.z - 0.1f, 0.0f));
            d = std::max(d, std::min(q.z - 0.05f - 1.1f * (q.y - 0.2f), q.z - 0.10f) + ragged);
            break;
        }
        case Person::Hair::bun: {
            const float front = ellipsoid(q, {0, -0.30f, 0.74f}, {0.72f, 1.0f, 0.86f});
            d = carve(d, front + 0.5f * ragged, 0.04f);
            d = std::max(d, -0.35f - q.y);
            d = join(d, ball(q, {0.05f, 1.22f, -0.4f}, 0.29f), 0.1f);
            break;
        }
        case Person::Hair::bald: {
            d = std::max({d + 0.055f, q.y - 0.42f + 0.3f * q.z + ragged, -0.25f - q.y, q.z - 0.12f + 2 * ragged});
            break;
        }
    }
    // Locks.
    if (d < 0.12f) d -= 0.035f * (cloud({q.x * 11, q.y * 2.5f, q.z * 9}, 2) - 0.5f);
    return d;
}

float Face::body(Vec3 p) const {
    const Vec3 m{std::abs(p.x), p.y, p.z};
    float d = rod(m, {0.25f, -1.72f, -0.28f}, {1.12f, -2.02f, -0.32f}, 0.34f, 0.36f);
    d = join(d, ellipsoid(p, {0, -2.5f, -0.15f}, {1.35f, 0.95f, 0.62f}), 0.25f);
    if (d < 0.2f) d -= 0.05f * noise({p.x * 2.2f + 3, p.y * 1.4f, p.z * 2.0f});
    // Open at the neck.
    d = carve(d, ellipsoid(p, {0, -1.36f, 0.06f}, {0.50f, 0.36f, 0.56f}), 0.05f);
    return d;
}

float Face::spectacles(Vec3 q) const {
    const Vec3 m{std::abs(q.x), q.y, q.z};
    float d = ring({m.x, (m.y - 0.02f) * 1.12f, m.z}, {0.30f, 0.02f, 0.86f}, 0.22f, 0.02f);
    d = std::min(d, rod(m, {0, 0.07f, 0.90f}, {0.09f, 0.06f, 0.87f}, 0.016f, 0.016f));
    return std::min(d, rod(m, {0.51f, 0.06f, 0.85f}, {0.78f, 0.08f, -0.1f}, 0.018f, 0.018f));
}

Face::Near Face::nearest(Vec3 p) const {
    const Vec3 q = turn_.into(p);
    Near near{head(q), Part::skin};
    near.distance = join(near.distance, rod(p, {0, -0.75f, -0.22f}, {0, -1.85f, -0.30f}, 0.35f, 0.42f), 0.16f);
    const auto take = [&](float d, Part part) {
        if (d < near.distance) near = {d, part};
    };
    take(ball({std::abs(q.x), q.y, q.z}, kEye, kEyeRadius), Part::eye);
    take(hair(q), Part::hair);
    take(p.y > -0.9f ? p.y + 1.3f : body(p), Part::cloth);  // the shoulders end below -1.3
    if (who_.glasses) take(spectacles(q), Part::frame);
    return near;
}

float Face::distance(Vec3 p) const { return 0.8f * nearest(p).distance; }

Surface Face::eye(Vec3 q) const {
    const Vec3 m{std::abs(q.x), q.y, q.z};
    const Vec3 out = unit(m - kEye);
    const float angle = std::hypot(out.x + (q.x < 0 ? 0.02f : -0.02f), out.y + 0.02f) * kEyeRadius;
    Vec3 colour = mix(paint(226, 218, 212), paint(190, 150, 140), ramp(0.07f, 0.14f, std::abs(m.x - kEye.x)));
    const float spokes = noise2(std::atan2(out.y, out.x) * 9, angle * 20, who_.seed);
    const Vec3 iris = who_.iris * (0.6f + 0.8f * spokes) * ramp(0.075f, 0.055f, angle);
    colour = mix(colour, iris, ramp(0.071f, 0.063f, angle));
    colour = colour * ramp(0.022f, 0.029f, angle);
    const float lash = ramp(0.0f, -0.03f, lid_slit(m.x, m.y - 0.01f));
    return {colour * (0.45f + 0.55f * lash), 1.6f, 260, 0, {}};
}

Surface Face::skin(Vec3 q) const {
    const Vec3 m{std::abs(q.x), q.y, q.z};
    Vec3 colour = who_.skin * (0.86f + 0.28f * cloud(q * 5 + Vec3{static_cast<float>(who_.seed), 0, 0}, 4));
    // Blood shows in the cheeks, the nose and the ears.
    const float flush = std::exp(-8 * ((m.x - 0.4f) * (m.x - 0.4f) + (q.y + 0.25f) * (q.y + 0.25f))) +
                        0.8f * std::exp(-40 * (q.x * q.x + (q.y + 0.27f) * (q.y + 0.27f))) + ramp(0.68f, 0.78f, m.x);
    colour = colour * mix(Vec3{1, 1, 1}, Vec3{1.06f, 0.80f, 0.76f}, clamp01(flush * 0.7f));
    if (q.z > 0.3f) {
        const float line = mouth_height(who_, q.x);
        const float above = (q.y - line) / who_.lips;
        const float bow = 0.066f - 0.016f * std::exp(-300 * q.x * q.x) - 0.78f * q.x * q.x;
        const float below = -0.108f + 1.25f * q.x * q.x;
        const float lips = ramp(0.010f, -0.010f, above - bow) * ramp(-0.012f, 0.012f, above - below) * ramp(0.29f, 0.26f, m.x);
        colour = mix(colour, who_.lip * (0.8f + 0.4f * noise({q.x * 60, q.y * 8, 0})), 0.8f * lips);
        const float gap = std::abs(q.y - line) + 0.05f * ramp(0.25f, 0.31f, m.x);
        colour = colour * mix(0.16f, 1.0f, ramp(0.004f, 0.020f, gap));
        // Lashes along the slit, stronger above.
        const float slit = lid_slit(m.x, m.y);
        const float strength = q.y > kEye.y ? 0.022f : 0.011f;
        colour = colour * mix(0.12f, 1.0f, ramp(0.2f * strength, strength, std::abs(slit)));
        // The crease of the upper lid.
        colour = colour * mix(0.62f, 1.0f, ramp(0.006f, 0.016f, std::abs(slit - 0.052f) + (q.y > kEye.y + 0.02f ? 0.0f : 1.0f)));
        // Brows.
        const float arch = 0.285f + 0.05f * std::sin((m.x - 0.1f) * 6.0f) - 0.06f * ramp(0.4f, 0.56f, m.x);
        const float thick = who_.brow * ramp(0.6f, 0.25f, m.x) * ramp(0.08f, 0.14f, m.x);
        const float hairs = 0.65f + 0.7f * noise({(m.x + q.y) * 60, (q.y - m.x) * 14, 3});
        const float brow = ramp(thick, 0.35f * thick, std::abs(q.y - arch)) * hairs;
        if (thick > 0.003f) colour = mix(colour, who_.hair * 0.55f, clamp01(brow * 0.92f));
    }
    float gloss = 0.10f;
    if (who_.beard > 0) {
        const float region = beard_at(q);
        const float hairs = noise(q * Vec3{55, 12, 55});
        colour = mix(colour, who_.hair * (0.5f + 1.1f * hairs), clamp01(region * who_.beard * (0.7f + 0.6f * hairs)));
        gloss *= 1 - region;
    }
    return {colour, gloss, 18, 0.28f, {}};
}

Surface Face::strands(Vec3 q) const {
    // Fine streaks along the fall of the hair, with broader locks under them.
    const float across = std::atan2(q.x, q.z + 0.2f);
    const float fine = noise({across * 70, q.y * 4, 1}), broad = noise({across * 14, q.y * 2.2f, 5});
    const Vec3 colour = who_.hair * (0.35f + 0.75f * fine + 0.5f * broad);
    return {colour, 0.10f + 0.22f * fine, 14, 0.15f, {}};
}

Surface Face::surface(Vec3 p, Vec3 normal) const {
    const Vec3 q = turn_.into(p);
    switch (nearest(p).part) {
        case Part::eye: return eye(q);
        case Part::hair: return strands(q);
        case Part::frame: return {paint(38, 30, 28), 0.9f, 60, 0, {}};
        case Part::cloth: {
            const float weave = 0.85f + 0.3f * noise({p.x * 90, p.y * 90, p.z * 90});
            const Vec3 colour = who_.cloth * weave;
            return {colour * (0.9f + 0.1f * normal.y), 0.03f, 8, 0.1f, {}};
        }
        case Part::skin: break;
    }
    return skin(q);
}

Vec3 Face::behind(float x, float y, Vec3) const {
    // A room out of focus: a wall, brighter on one side, and a few soft lights and dark things.
    const float fall = 0.85f + 0.25f * (0.5f - 0.5f * x) + 0.18f * y;
    Vec3 colour = who_.wall * fall * (0.92f + 0.16f * cloud2(x * 1.6f + 7, y * 1.6f, 3, who_.seed));
    for (int i = 0; i < 4; ++i) {
        const float cx = 2 * chance(i, 1, who_.seed) - 1, cy = 1.6f * chance(i, 2, who_.seed) - 0.6f;
        const float radius = 0.12f + 0.16f * chance(i, 3, who_.seed);
        const float d = std::hypot(x - cx, y - cy);
        colour = colour * (1 + (chance(i, 4, who_.seed) - 0.45f) * 0.35f * ramp(radius + 0.14f, radius - 0.08f, d));
    }
    return colour;
}

}  // namespace tactics::samples
