// SPDX-License-Identifier: Apache-2.0
#include "filters/lab.h"

#include <algorithm>
#include <cmath>

namespace tactics {

namespace {

// IEC 61966-2-1: from light to X, Y, Z, here divided by their white D65.
constexpr double kToWhite[3][3] = {{0.4124564 / 0.9504700, 0.3575761 / 0.9504700, 0.1804375 / 0.9504700},
                                   {0.2126729, 0.7151522, 0.0721750},
                                   {0.0193339 / 1.0888300, 0.1191920 / 1.0888300, 0.9503041 / 1.0888300}};

double lab_f(double t) { return t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116; }  // CIE 15

Lab from_f(double x, double y, double z) { return {116 * y - 16, 500 * (x - y), 200 * (y - z)}; }

// The cube root is steep near black: a table over the root of light, read between entries, keeps to 1e-5 of lab_f.
struct Tables {
    static constexpr int kSteps = 4096;
    std::array<float, 256> light{};
    std::array<float, kSteps + 2> f{};

    Tables() {
        for (int i = 0; i < 256; ++i) light[static_cast<std::size_t>(i)] = static_cast<float>(srgb_light(i / 255.0));
        for (int i = 0; i < kSteps + 2; ++i) {
            const double root = static_cast<double>(i) / kSteps;
            f[static_cast<std::size_t>(i)] = static_cast<float>(lab_f(root * root));
        }
    }

    float lab_of(float t) const {
        const float at = std::min(std::sqrt(t), 1.0f) * kSteps;
        const int step = static_cast<int>(at);
        const float below = f[static_cast<std::size_t>(step)], above = f[static_cast<std::size_t>(step) + 1];
        return below + (at - static_cast<float>(step)) * (above - below);
    }
};

}  // namespace

InkShare share_of_ink(const std::array<int, 3>& pixel, const std::array<int, 3>& ground, const std::array<int, 3>& ink) {
    double across = 0, whole = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        across += static_cast<double>(ground[c] - pixel[c]) * (ground[c] - ink[c]);
        whole += static_cast<double>(ground[c] - ink[c]) * (ground[c] - ink[c]);
    }
    InkShare found{across / std::max(1.0, whole), 0};
    for (std::size_t c = 0; c < 3; ++c)
        found.rest = std::max(found.rest, std::abs(ground[c] - pixel[c] - found.share * (ground[c] - ink[c])));
    return found;
}

Lab to_lab(double red, double green, double blue) {
    const double light[3] = {srgb_light(red / 255), srgb_light(green / 255), srgb_light(blue / 255)};
    double f[3];
    for (int i = 0; i < 3; ++i) f[i] = lab_f(kToWhite[i][0] * light[0] + kToWhite[i][1] * light[1] + kToWhite[i][2] * light[2]);
    return from_f(f[0], f[1], f[2]);
}

std::vector<std::vector<float>> lab_planes(const Image& picture) {
    static const Tables kTables;
    const std::size_t count = static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
    std::vector<std::vector<float>> planes(3, std::vector<float>(count));
    float weight[3][3];
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) weight[i][j] = static_cast<float>(kToWhite[i][j]);
    const std::uint8_t* pixel = picture.pixels.data();
    for (std::size_t i = 0; i < count; ++i, pixel += 3) {
        const float r = kTables.light[pixel[0]], g = kTables.light[pixel[1]], b = kTables.light[pixel[2]];
        const float x = kTables.lab_of(weight[0][0] * r + weight[0][1] * g + weight[0][2] * b);
        const float y = kTables.lab_of(weight[1][0] * r + weight[1][1] * g + weight[1][2] * b);
        const float z = kTables.lab_of(weight[2][0] * r + weight[2][1] * g + weight[2][2] * b);
        planes[0][i] = 116 * y - 16;
        planes[1][i] = 500 * (x - y);
        planes[2][i] = 200 * (y - z);
    }
    return planes;
}

}  // namespace tactics
