// SPDX-License-Identifier: Apache-2.0
// The contour net once more, slowly: nets made by chance, their files, and what they must answer, by plain loops in int64.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "tests/filters/pictures.h"

namespace tactics::net_twin {

struct Layer {
    int outputs, inputs, side;
    bool each;
    int shift = 1;
    std::vector<int> up, bias, stored{};  // stored[output][input][row][column]

    int seen() const { return (each ? 1 : inputs) * side * side; }
    std::int64_t weight(int output, int input, int row, int column) const {
        const int at = ((output * (each ? 1 : inputs) + (each ? 0 : input)) * side + row) * side + column;
        return static_cast<std::int64_t>(stored[static_cast<std::size_t>(at)]) << up[static_cast<std::size_t>(output)];
    }
};

struct Net {
    std::array<int, 4> channels, blocks;
    std::vector<Layer> layers{};
    std::uint64_t proof = 0;
};

/// Weights by chance. A wild net has weights as large as they may be and shifts that are too small, so that many numbers are cut
/// where the range ends; another has numbers of moderate size all over.
inline Net random_net(std::array<int, 4> channels, std::array<int, 4> blocks, bool wild, std::uint64_t seed) {
    Net net{channels, blocks};
    pictures::Chance chance(seed);
    const auto add = [&](int inputs, int outputs, int side, bool each) {
        Layer layer{outputs, inputs, side, each, 1, {}, {}};
        const double root = std::sqrt(layer.seen());
        int largest = 0;
        while (largest < 8 && layer.seen() * (127LL << (largest + 1)) * 8191 < (1LL << 31) - (1 << 21)) ++largest;
        layer.shift = static_cast<int>(std::lround(std::log2(70 * root))) + (wild ? largest - 1 : 2);
        for (int o = 0; o < outputs; ++o) {
            layer.up.push_back(wild ? largest : chance.below(4));
            layer.bias.push_back((chance.below(2001) - 1000) << (wild ? 4 : layer.shift - 3));
            for (int i = 0; i < layer.seen(); ++i) layer.stored.push_back(chance.below(255) - 127);
        }
        net.layers.push_back(layer);
    };
    const auto residual = [&](int width, int side, bool each) {
        add(width, width, side, each);
        add(width, width, each ? 1 : side, false);
    };
    int inputs = 24;
    for (std::size_t s = 0; s < 4; ++s) {
        add(inputs, channels[s], s == 3 ? 1 : 3, false);
        for (int i = 0; i < blocks[s]; ++i) residual(channels[s], s < 2 ? 3 : 5, s > 1);
        inputs = channels[s];
    }
    add(channels[3], channels[2], 1, false);
    residual(channels[2], 5, true);
    add(channels[2], channels[1], 1, false);
    residual(channels[1], 3, true);
    add(channels[1], channels[0], 1, false);
    add(channels[0], channels[0], 3, false);
    add(channels[0], 1, 1, false);
    return net;
}

inline void append(std::string& bytes, std::uint64_t value, int size) {
    for (int i = 0; i < size; ++i) bytes += static_cast<char>(value >> (8 * i) & 255);
}

inline std::uint32_t crc_of(const std::string& bytes) {
    std::uint32_t crc = ~0u;
    for (const char c : bytes)
        for (int bit = 0; bit < 8; ++bit) {
            const bool odd = ((crc ^ (static_cast<unsigned char>(c) >> bit)) & 1) != 0;
            crc = crc >> 1 ^ (odd ? 0xedb88320u : 0u);
        }
    return ~crc;
}

/// The file's bytes with a checksum that is right.
inline std::string sealed(std::string bytes) {
    append(bytes, crc_of(bytes), 4);
    return bytes;
}

/// The file but for its checksum.
inline std::string unsealed_file(const Net& net) {
    std::string bytes = "TNET";
    append(bytes, 1, 2);
    append(bytes, net.layers.size(), 2);
    for (const int c : net.channels) append(bytes, static_cast<std::uint64_t>(c), 2);
    for (const int b : net.blocks) append(bytes, static_cast<std::uint64_t>(b), 2);
    append(bytes, net.proof, 8);
    for (const Layer& layer : net.layers) {
        append(bytes, static_cast<std::uint64_t>(layer.outputs), 2);
        append(bytes, static_cast<std::uint64_t>(layer.inputs), 2);
        for (const int v : {layer.side, layer.each ? 1 : 0, layer.shift, 0}) append(bytes, static_cast<std::uint64_t>(v), 1);
    }
    for (const Layer& layer : net.layers) {
        for (const int v : layer.up) append(bytes, static_cast<std::uint64_t>(v), 1);
        for (const int v : layer.bias) append(bytes, static_cast<std::uint64_t>(static_cast<std::int64_t>(v)), 4);
        for (const int v : layer.stored) append(bytes, static_cast<std::uint64_t>(static_cast<std::int64_t>(v)), 1);
    }
    return bytes;
}

inline std::string file_of(const Net& net) { return sealed(unsealed_file(net)); }

/// Numbers by channel, row, column; 0 outside.
struct Cube {
    Cube(int c, int h, int w) : channels(c), height(h), width(w), values(static_cast<std::size_t>(c * h * w)) {}
    int channels, height, width;
    std::vector<std::int64_t> values;
    std::int64_t& at(int c, int y, int x) { return values[static_cast<std::size_t>((c * height + y) * width + x)]; }
    std::int64_t get(int c, int y, int x) const {
        if (y < 0 || x < 0 || y >= height || x >= width) return 0;
        return values[static_cast<std::size_t>((c * height + y) * width + x)];
    }
    std::int64_t near(int c, int y, int x) const { return get(c, std::clamp(y, 0, height - 1), std::clamp(x, 0, width - 1)); }
};

template <class Value>
Cube cube_of(int channels, int height, int width, Value value) {
    Cube cube(channels, height, width);
    for (int c = 0; c < channels; ++c)
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) cube.at(c, y, x) = value(c, y, x);
    return cube;
}

inline std::int64_t half_up(std::int64_t value, int shift) { return (value + (std::int64_t{1} << shift >> 1)) >> shift; }

inline Cube convolved(const Layer& layer, const Cube& in, bool relu, const Cube* add = nullptr) {
    return cube_of(layer.outputs, in.height, in.width, [&](int o, int y, int x) {
        std::int64_t sum = layer.bias[static_cast<std::size_t>(o)];
        for (int i = layer.each ? o : 0; i < (layer.each ? o + 1 : layer.inputs); ++i)
            for (int r = 0; r < layer.side; ++r)
                for (int c = 0; c < layer.side; ++c)
                    sum += in.get(i, y + r - layer.side / 2, x + c - layer.side / 2) * layer.weight(o, i, r, c);
        const std::int64_t value = half_up(sum, layer.shift) + (add != nullptr ? add->get(o, y, x) : 0);
        return std::clamp<std::int64_t>(value, relu ? 0 : -8191, 8191);
    });
}

inline int bounced(int i, int length) {
    while (length > 1 && (i < 0 || i >= length)) i = i < 0 ? -i : 2 * length - 2 - i;
    return length > 1 ? i : 0;
}

inline Cube smoothed(const Cube& in, int sigma) {
    std::vector<std::int64_t> kernel;
    double whole = 0;
    for (int i = -3 * sigma; i <= 3 * sigma; ++i) whole += std::exp(-0.5 * i * i / sigma / sigma);
    for (int i = -3 * sigma; i <= 3 * sigma; ++i)
        kernel.push_back(static_cast<std::int64_t>(std::floor(std::exp(-0.5 * i * i / sigma / sigma) / whole * 4096 + 0.5)));
    std::int64_t rest = 4096;
    for (const auto k : kernel) rest -= k;
    kernel[static_cast<std::size_t>(3 * sigma)] += rest;
    const auto along = [&](const Cube& from, int dy, int dx) {
        return cube_of(from.channels, from.height, from.width, [&](int c, int y, int x) {
            std::int64_t sum = 0;
            for (int i = -3 * sigma; i <= 3 * sigma; ++i)
                sum += kernel[static_cast<std::size_t>(i + 3 * sigma)] *
                       from.get(c, bounced(y + i * dy, from.height), bounced(x + i * dx, from.width));
            return half_up(sum, 12);
        });
    };
    return along(along(in, 0, 1), 1, 0);
}

/// The 24 channels that the net gets.
inline Cube input_of(const Image& image) {
    const int height = (image.height + 15) / 16 * 16, width = (image.width + 15) / 16 * 16;
    const auto sample = [&](int x, int y, int c) { return image.row(y)[x * image.channels + (image.channels == 3 ? c : 0)]; };
    std::int64_t sum = 0, squares = 0;
    const std::int64_t count = static_cast<std::int64_t>(image.width) * image.height;
    std::vector<std::int64_t> lights;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            lights.push_back((19595 * sample(x, y, 0) + 38470 * sample(x, y, 1) + 7471 * sample(x, y, 2) + 32768) / 65536);
    for (const auto v : lights) sum += v;
    const std::int64_t mean = (512 * sum + count) / (2 * count);
    for (const auto v : lights) squares += (256 * v - mean) * (256 * v - mean);
    const auto deviation = static_cast<std::int64_t>(std::sqrt(static_cast<double>(squares / count)));
    const std::int64_t gain = std::clamp<std::int64_t>((48 << 24) / std::max<std::int64_t>(deviation, 1), 45875, 327680);
    const Cube colours = cube_of(3, height, width, [&](int c, int y, int x) {
        return half_up((256 * sample(bounced(x, image.width), bounced(y, image.height), 2 - c) - mean) * gain, 22);
    });
    const Cube opponents = cube_of(3, height / 2, width / 2, [&](int c, int y, int x) {
        std::array<std::int64_t, 3> four{};  // blue, green, red
        for (int k = 0; k < 3; ++k)
            for (int i = 0; i < 4; ++i) four[static_cast<std::size_t>(k)] += colours.get(k, 2 * y + i / 2, 2 * x + i % 2);
        return c == 0   ? half_up(four[0] + 2 * four[1] + four[2], 3)
               : c == 1 ? half_up(four[2] - four[1], 1)
                        : half_up(2 * four[0] - four[1] - four[2], 2);
    });
    std::array<Cube, 3> smooth = {smoothed(opponents, 1), smoothed(opponents, 2), smoothed(opponents, 4)};
    return cube_of(24, height / 2, width / 2, [&](int c, int y, int x) {
        if (c < 12) return colours.get(c / 4, 2 * y + c % 4 / 2, 2 * x + c % 2);
        const Cube& s = smooth[static_cast<std::size_t>((c - 12) / 4)];
        std::int64_t total = 0;
        for (int k = 0; k < 3; ++k) {
            const auto a = s.near(k, y, x + 1) - s.near(k, y, x - 1), d = s.near(k, y + 1, x) - s.near(k, y - 1, x);
            total += std::abs(c % 4 == 0 ? a : c % 4 == 1 ? d : c % 4 == 2 ? a + d : a - d);
        }
        total *= (1 << (1 + (c - 12) / 4)) + 1;
        return std::min<std::int64_t>(c % 4 < 2 ? half_up(total, 2) : half_up(total * 181, 10), 8191);
    });
}

inline Cube pooled(const Cube& in) {
    return cube_of(in.channels, in.height / 2, in.width / 2, [&](int c, int y, int x) {
        return std::max(
            {in.get(c, 2 * y, 2 * x), in.get(c, 2 * y, 2 * x + 1), in.get(c, 2 * y + 1, 2 * x), in.get(c, 2 * y + 1, 2 * x + 1)});
    });
}

inline Cube joined(const Cube& coarse, const Cube& fine) {
    return cube_of(fine.channels, fine.height, fine.width, [&](int c, int y, int x) {
        const int beside = x / 2 + x % 2 * 2 - 1, beyond = y / 2 + y % 2 * 2 - 1;
        const auto sixteenths = 9 * coarse.near(c, y / 2, x / 2) + 3 * coarse.near(c, y / 2, beside) +
                                3 * coarse.near(c, beyond, x / 2) + coarse.near(c, beyond, beside);
        return std::clamp<std::int64_t>(fine.get(c, y, x) + half_up(sixteenths, 4), 0, 8191);
    });
}

/// Half the picture's size, rounded up; row by row.
inline std::vector<std::int16_t> logits_of(const Net& net, const Image& image) {
    auto layer = net.layers.begin();
    std::vector<Cube> scales;
    const auto residual = [&](Cube& cube) {
        const Cube first = convolved(*layer++, cube, true);
        cube = convolved(*layer++, first, true, &cube);
    };
    for (std::size_t s = 0; s < 4; ++s) {
        scales.push_back(convolved(*layer++, s == 0 ? input_of(image) : pooled(scales.back()), true));
        for (int i = 0; i < net.blocks[s]; ++i) residual(scales.back());
    }
    for (std::size_t s = 3; s-- > 0;) {
        scales[s] = joined(convolved(*layer++, scales[s + 1], false), scales[s]);
        if (s > 0) residual(scales[s]);
    }
    const Cube last = convolved(*layer++, scales[0], true);
    const Cube out = convolved(*layer, last, false);
    std::vector<std::int16_t> logits;
    for (int y = 0; y < (image.height + 1) / 2; ++y)
        for (int x = 0; x < (image.width + 1) / 2; ++x) logits.push_back(static_cast<std::int16_t>(out.get(0, y, x)));
    return logits;
}

}  // namespace tactics::net_twin
