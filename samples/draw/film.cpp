// SPDX-License-Identifier: Apache-2.0
#include "samples/draw/film.h"

#include "samples/draw/noise.h"

namespace tactics::samples {

namespace {

// Separable Gaussian over 5 pixels, the border repeated.
void blur(Light& light, float sigma) {
    float weights[3];
    float sum = 0;
    for (int i = 0; i < 3; ++i) {
        weights[i] = std::exp(-0.5f * static_cast<float>(i * i) / (sigma * sigma));
        sum += i == 0 ? weights[i] : 2 * weights[i];
    }
    for (float& w : weights) w /= sum;
    std::vector<Vec3> line;
    const auto run = [&](int count, auto at) {
        line.resize(static_cast<std::size_t>(count));
        for (int i = 0; i < count; ++i) line[static_cast<std::size_t>(i)] = at(i);
        const auto get = [&](int i) { return line[static_cast<std::size_t>(std::clamp(i, 0, count - 1))]; };
        for (int i = 0; i < count; ++i)
            at(i) = get(i) * weights[0] + (get(i - 1) + get(i + 1)) * weights[1] + (get(i - 2) + get(i + 2)) * weights[2];
    };
    for (int y = 0; y < light.height; ++y) run(light.width, [&](int x) -> Vec3& { return light.at(x, y); });
    for (int x = 0; x < light.width; ++x) run(light.height, [&](int y) -> Vec3& { return light.at(x, y); });
}

// Bell-shaped chance: the sum of four even ones, scaled to a standard deviation of 1.
float bell(int x, int y, int seed) {
    const std::uint32_t a = scramble(x, y, seed);
    const float sum = static_cast<float>((a & 255u) + ((a >> 8) & 255u) + ((a >> 16) & 255u) + (a >> 24));
    return (sum - 510.0f) / 147.8f;
}

// The shoulder keeps highlights from burning out; the rest is the sRGB curve in its short form.
float tone(float light) {
    const float held = light < 0.6f ? light : 0.6f + 0.4f * (1 - std::exp(-(light - 0.6f) / 0.4f));
    return std::pow(std::max(held, 0.0f), 1 / 2.2f);
}

}  // namespace

Image develop(Light light, const Exposure& exposure) {
    // The lens is as sharp as the sensor is fine: a small picture is a large one shrunk.
    if (std::max(light.width, light.height) >= 200) blur(light, exposure.blur);
    Image image = make_image(light.width, light.height, 3, 0, 0);
    const float half = 0.5f * static_cast<float>(std::max(light.width, light.height));
    for (int y = 0; y < light.height; ++y) {
        std::uint8_t* to = image.row(y);
        for (int x = 0; x < light.width; ++x, to += 3) {
            const float dx = (static_cast<float>(x) + 0.5f - 0.5f * static_cast<float>(light.width)) / half;
            const float dy = (static_cast<float>(y) + 0.5f - 0.5f * static_cast<float>(light.height)) / half;
            const float gain = exposure.gain * (1 - 0.5f * exposure.vignette * (dx * dx + dy * dy));
            const Vec3 c = light.at(x, y) * gain;
            // A sensor's noise is mostly common to the channels after demosaicing; some is not.
            const float common = bell(x, y, exposure.seed) * exposure.grain;
            const float values[3] = {tone(c.x), tone(c.y), tone(c.z)};
            for (int i = 0; i < 3; ++i) {
                const float own = bell(x, y, exposure.seed * 7 + i + 100) * exposure.grain * 0.5f;
                // Photon noise: weaker in the highlights of the curved signal.
                const float value = values[i] + (common + own) * (1.25f - 0.6f * values[i]);
                to[i] = static_cast<std::uint8_t>(std::lround(clamp01(value) * 255.0f));
            }
        }
    }
    return image;
}

}  // namespace tactics::samples
