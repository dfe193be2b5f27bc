// SPDX-License-Identifier: Apache-2.0
// Hashes of what the contour net answers to pictures made of whole numbers, for each kernel that this machine has:
//     net_hashes NET
// tests/bench/neon runs it on machines of two kinds and compares.
#include <bit>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include "filters/net/net.h"

namespace {

using namespace tactics;

class Hash {
public:
    void add(std::uint32_t word) {
        for (int i = 0; i < 4; ++i) value_ = (value_ ^ (word >> (8 * i) & 255)) * 0x100000001b3u;
    }
    void add(const EdgeMap& map) {
        for (const auto* values : {&map.strength, &map.normal})
            for (const float value : *values) add(std::bit_cast<std::uint32_t>(value));
    }
    unsigned long long value() const { return value_; }

private:
    std::uint64_t value_ = 0xcbf29ce484222325u;
};

// Discs, boxes and grain before a slope.
Image picture(int width, int height, int channels, std::uint32_t seed) {
    const auto chance = [&](int below) {
        seed = seed * 1664525u + 1013904223u;
        return static_cast<int>((seed >> 8) % static_cast<std::uint32_t>(below));
    };
    Image image = make_image(width, height, channels, 0.25, 0);
    for (int y = 0; y < height; ++y)
        for (int i = 0; i < width * channels; ++i) image.row(y)[i] = static_cast<std::uint8_t>(60 + (i + 2 * y) % 97);
    for (int thing = 0; thing < 12; ++thing) {
        const int x0 = chance(width), y0 = chance(height), reach = 2 + chance(width / 4 + 1), level = chance(256);
        const bool disc = thing % 2 == 0;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const int dx = x - x0, dy = y - y0;
                if (disc ? dx * dx + dy * dy > reach * reach : std::abs(dx) > reach || std::abs(dy) > reach / 2) continue;
                for (int c = 0; c < channels; ++c)
                    image.row(y)[channels * x + c] = static_cast<std::uint8_t>(level ^ (c * thing * 16 & 255));
            }
    }
    for (auto& sample : image.pixels) sample = static_cast<std::uint8_t>(sample * 15 / 16 + chance(16));
    return image;
}

}  // namespace

int main(int count, char** words) {
    if (count < 2) return 1;
    std::ifstream file(words[1], std::ios::binary);
    const std::string bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    const ContourNet net = ContourNet::from_bytes(bytes, words[1]);
    struct Shape {
        int width, height, channels;
    };
    constexpr Shape kShapes[] = {{481, 321, 3}, {33, 16, 3}, {1, 7, 1}, {200, 150, 1}, {97, 131, 3}, {1, 1, 3}, {350, 64, 3}};
    constexpr double kScales[] = {0.7, 1, 1.5};
    for (const NetKernel* kernel : net_kernels()) {
        std::uint32_t seed = 1;
        for (const auto& [width, height, channels] : kShapes) {
            const Image image = picture(width, height, channels, ++seed);
            Hash logits, map, mean;
            for (const std::int16_t value : logits_of(net, image, {.kernel = kernel}).values)
                logits.add(static_cast<std::uint32_t>(value));
            map.add(contour_map(net, image, {}, {.kernel = kernel}));
            mean.add(contour_map(net, image, kScales, {.kernel = kernel}));
            std::printf("%-5s %4d x %3d x %d: %016llx %016llx %016llx\n", std::string(kernel->name).c_str(), width, height,
                        channels, logits.value(), map.value(), mean.value());
        }
    }
    return 0;
}
