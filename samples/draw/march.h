// SPDX-License-Identifier: Apache-2.0
// A camera that walks along each ray until a distance function says that it has arrived.
//
// A scene has:
//     float distance(Vec3 p) const;                      how far the nearest surface is at most
//     Surface surface(Vec3 p, Vec3 normal) const;        what is there
//     Vec3 behind(float x, float y, Vec3 ray) const;     what is seen where there is nothing; x, y in [-1, 1]
// It is a template so that the distance, which is asked for some tens of times a pixel, is compiled into the loop.
#pragma once

#include "samples/draw/film.h"
#include "samples/draw/vector.h"

namespace tactics::samples {

struct Surface {
    Vec3 colour;
    float gloss = 0;   ///< strength of the highlight
    float shine = 20;  ///< its sharpness
    float soft = 0;    ///< how far light creeps round into the shade (skin 0.3, leaves 0.4)
    Vec3 glow;         ///< light of its own
};

struct Camera {
    Vec3 eye;
    Vec3 target;
    float zoom = 2;  ///< distance of the image plane, half its longer side being 1
};

struct Lamps {
    Vec3 key_from;  ///< direction towards the main light
    Vec3 key = {1.6f, 1.5f, 1.35f};
    Vec3 sky = {0.45f, 0.52f, 0.62f};    ///< from above
    Vec3 ground = {0.22f, 0.2f, 0.18f};  ///< from below
    Vec3 rim;                            ///< a lamp behind, along the outline
    float shadow = 8;                    ///< sharpness of its shadows
    float reach = 3;                     ///< how far shadows are followed
};

template <class Scene>
class March {
public:
    March(const Scene& scene, const Camera& camera, const Lamps& lamps, float far)
        : scene_(scene), camera_(camera), lamps_(lamps), far_(far), key_(unit(lamps.key_from)) {
        forward_ = unit(camera.target - camera.eye);
        right_ = unit(cross(forward_, Vec3{0, 1, 0}));
        up_ = cross(right_, forward_);
    }

    /// Small pictures are averages of 3 x 3 rays a pixel, as a camera would give them; large ones are left to the lens.
    Light take(int width, int height) const {
        constexpr int kSmall = 200, kRays = 3;
        if (std::max(width, height) >= kSmall) return rays(width, height);
        const Light fine = rays(width * kRays, height * kRays);
        Light light(width, height);
        for (int y = 0; y < fine.height; ++y)
            for (int x = 0; x < fine.width; ++x) {
                Vec3& sum = light.at(x / kRays, y / kRays);
                sum = sum + fine.at(x, y) * (1.0f / (kRays * kRays));
            }
        return light;
    }

private:
    static constexpr int kTile = 8;
    static constexpr float kTouch = 0.004f;  ///< what scenes rely on when they ask what was hit

    Light rays(int width, int height) const {
        Light light(width, height);
        const float half = 0.5f * static_cast<float>(std::max(width, height));
        const float pixel = 1 / (half * camera_.zoom);
        for (int top = 0; top < height; top += kTile)
            for (int left = 0; left < width; left += kTile) {
                const int bottom = std::min(top + kTile, height), right = std::min(left + kTile, width);
                // The whole tile first, as one cone: its pixels start where the cone first touches something.
                const auto at = [&](float x, float y) {
                    return Vec3{(x - 0.5f * static_cast<float>(width)) / half, (0.5f * static_cast<float>(height) - y) / half, 0};
                };
                const Vec3 middle = at(0.5f * static_cast<float>(left + right), 0.5f * static_cast<float>(top + bottom));
                const float start = cone(ray(middle), pixel * kTile * 0.75f);
                for (int y = top; y < bottom; ++y)
                    for (int x = left; x < right; ++x) {
                        const Vec3 place = at(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
                        light.at(x, y) = seen(place, start, pixel);
                    }
            }
        return light;
    }

    Vec3 ray(Vec3 place) const { return unit(forward_ * camera_.zoom + right_ * place.x + up_ * place.y); }

    float cone(Vec3 direction, float spread) const {
        float t = 0;
        for (int i = 0; i < 96 && t < far_; ++i) {
            const float d = scene_.distance(camera_.eye + direction * t);
            if (d < spread * t) return std::max(t - spread * t, 0.0f);
            t += d - 0.5f * spread * t;
        }
        return t;
    }

    Vec3 seen(Vec3 place, float start, float pixel) const {
        const Vec3 direction = ray(place);
        float t = start;
        for (int i = 0; i < 64 && t < far_; ++i) {
            const Vec3 p = camera_.eye + direction * t;
            const float d = scene_.distance(p);
            if (d < std::min(0.5f * pixel * t, kTouch)) return lit(p, direction, pixel * t);
            t += d;
        }
        return scene_.behind(place.x, place.y, direction);
    }

    Vec3 normal(Vec3 p, float step) const {
        // Four corners of a tetrahedron give the gradient with the fewest questions.
        const Vec3 a{1, -1, -1}, b{-1, -1, 1}, c{-1, 1, -1}, d{1, 1, 1};
        return unit(a * scene_.distance(p + a * step) + b * scene_.distance(p + b * step) + c * scene_.distance(p + c * step) +
                    d * scene_.distance(p + d * step));
    }

    float shadow(Vec3 p, float start) const {
        float open = 1;
        float t = start;
        for (int i = 0; i < 14 && t < lamps_.reach; ++i) {
            const float d = scene_.distance(p + key_ * t);
            open = std::min(open, lamps_.shadow * d / t);
            if (open < 0.01f) return 0;
            t += std::clamp(d, 0.02f + 0.06f * t, 0.5f);
        }
        return open * open * (3 - 2 * open);
    }

    float openness(Vec3 p, Vec3 n) const {
        // Ambient light is lost where the surface nearby closes in.
        float lost = 0;
        for (const float h : {0.06f, 0.2f}) lost += std::max(h - scene_.distance(p + n * h), 0.0f) / h * 0.5f;
        return clamp01(1 - lost);
    }

    Vec3 lit(Vec3 p, Vec3 direction, float footprint) const {
        const Vec3 n = normal(p, std::max(footprint, 0.0008f));
        const Surface s = scene_.surface(p, n);
        const float facing = dot(n, key_);
        const float key = clamp01((facing + s.soft) / (1 + s.soft));
        const float shade = key > 0 ? shadow(p + n * 0.012f, 0.03f) : 0;
        const float open = openness(p, n);
        Vec3 light = lamps_.key * (key * shade) + mix(lamps_.ground, lamps_.sky, 0.5f + 0.5f * n.y) * open;
        // Light that has crept through skin comes out redder at the edge of the shade.
        light = light + lamps_.key * Vec3{0.22f, 0.07f, 0.03f} * (s.soft * shade * clamp01(1 - std::abs(facing) * 2.5f));
        const float edge = 1 + dot(n, direction);
        light = light + lamps_.rim * (edge * edge * open);
        const float lobe = std::pow(std::max(dot(n, unit(key_ - direction)), 0.0f), s.shine);
        const float graze = edge * edge * edge * edge;
        return s.colour * light + lamps_.key * (s.gloss * lobe * shade) + lamps_.sky * (s.gloss * 0.6f * graze * open) + s.glow;
    }

    const Scene& scene_;
    Camera camera_;
    Lamps lamps_;
    float far_;
    Vec3 key_, forward_, right_, up_;
};

}  // namespace tactics::samples
