// SPDX-License-Identifier: Apache-2.0
#include "tactics/measure/disturbance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "tactics/measure/random.h"
#include "tactics/readers/jpeg_loss.h"
#include "tactics/readers/shrink.h"

namespace tactics {

namespace {

std::uint8_t sample(double value) { return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0))); }

// Of deviation 1: the sum of twelve even ones, which needs no logarithm that rounds differently elsewhere.
double normal(RandomNumbers& random) {
    double sum = -6;
    for (int i = 0; i < 3; ++i)
        for (std::uint64_t bits = random.next(), part = 0; part < 4; ++part, bits >>= 16)
            sum += (static_cast<double>(bits & 0xFFFF) + 0.5) / 65536;
    return sum;
}

Disturbed in_place(Image image) {
    const int width = image.width, height = image.height;
    return {std::move(image), width, height};
}

template <typename Tone>
Disturbed toned(Image image, Tone tone) {
    std::array<std::uint8_t, 256> table{};
    for (std::size_t v = 0; v < table.size(); ++v) table[v] = sample(tone(static_cast<double>(v)));
    for (auto& value : image.pixels) value = table[value];
    return in_place(std::move(image));
}

template <int quality>
Disturbed jpeg(const Image& image) {
    return in_place(through_jpeg(image, quality));
}

Disturbed noise(const Image& image) { return in_place(with_noise(image, 10, 1)); }

// One pixel to the right and down; the first row and column are seen twice.
Disturbed shifted(const Image& image) {
    Disturbed moved = in_place(image);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            std::copy_n(image.row(std::max(y - 1, 0)) + std::max(x - 1, 0) * image.channels, image.channels,
                        moved.image.row(y) + x * image.channels);
    moved.shift_x = moved.shift_y = -1;
    return moved;
}

// About the middle, between the pixels by straight lines. Beyond the border the outermost pixels go on.
Disturbed turned(const Image& image) {
    Disturbed moved = in_place(image);
    moved.angle = std::numbers::pi / 180;
    const double c = std::cos(moved.angle), s = std::sin(moved.angle);
    const double middle_x = image.width / 2.0, middle_y = image.height / 2.0;
    moved.shift_x = middle_x - c * middle_x + s * middle_y;
    moved.shift_y = middle_y - s * middle_x - c * middle_y;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const double from_x = std::clamp(c * (x + 0.5) - s * (y + 0.5) + moved.shift_x - 0.5, 0.0, image.width - 1.0);
            const double from_y = std::clamp(s * (x + 0.5) + c * (y + 0.5) + moved.shift_y - 0.5, 0.0, image.height - 1.0);
            const int left = static_cast<int>(from_x), top = static_cast<int>(from_y);
            const int right = std::min(left + 1, image.width - 1), below = std::min(top + 1, image.height - 1);
            const double u = from_x - left, v = from_y - top;
            for (int k = 0; k < image.channels; ++k) {
                const auto at = [&](int column, int row) {
                    return static_cast<double>(image.row(row)[column * image.channels + k]);
                };
                moved.image.row(y)[x * image.channels + k] = sample((1 - v) * ((1 - u) * at(left, top) + u * at(right, top)) +
                                                                    v * ((1 - u) * at(left, below) + u * at(right, below)));
            }
        }
    return moved;
}

Disturbed halved(const Image& image) {
    const Size from{image.width, image.height};
    const Size to = shrunk_size(from, std::max(1, (std::max(image.width, image.height) + 1) / 2));
    RowShrinker<std::uint8_t> shrinker(from, to, image.channels);
    for (int y = 0; y < image.height; ++y) shrinker.add(image.row(y));
    Image small = make_image(to.width, to.height, image.channels, 2 * image.mm_per_pixel, 0);
    small.pixels = shrinker.take();
    return {std::move(small), image.width, image.height};
}

// A twentieth of each side at each end. What is left keeps its scale: to be enlarged would be another change.
Disturbed cropped(const Image& image) {
    const int left = image.width / 20, top = image.height / 20;
    Image inner = make_image(image.width - 2 * left, image.height - 2 * top, image.channels, image.mm_per_pixel, 0);
    for (int y = 0; y < inner.height; ++y)
        std::copy_n(image.row(y + top) + left * image.channels, inner.row_bytes(), inner.row(y));
    const int width = inner.width, height = inner.height;
    return {std::move(inner), width, height, 0, static_cast<double>(left), static_cast<double>(top)};
}

constexpr double kMiddleGrey = 127.5;

constexpr Disturbance kDisturbances[] = {
    {SourceWords("JPEG 70"), "stored as JPEG of quality 70, colour at half resolution", jpeg<70>},
    {SourceWords("JPEG 50"), "of quality 50", jpeg<50>},
    {SourceWords("noise 10"), "normal noise of 10 grey levels in each colour", noise},
    {SourceWords("shift"), "one pixel to the right and down", shifted},
    {SourceWords("turn"), "by one degree about the middle", turned},
    {SourceWords("crop"), "a twentieth cut off at each side; the rest keeps its scale", cropped},
    {SourceWords("half"), "half as many pixels each way", halved},
    {SourceWords("gamma 0.8"), "lighter: grey values between 0 and 1 to the power 0.8",
     [](const Image& image) { return toned(image, [](double v) { return 255 * std::pow(v / 255, 0.8); }); }},
    {SourceWords("low"), "half the contrast, about middle grey",
     [](const Image& image) { return toned(image, [](double v) { return kMiddleGrey + 0.5 * (v - kMiddleGrey); }); }},
    {SourceWords("very low"), "a fifth of the contrast",
     [](const Image& image) { return toned(image, [](double v) { return kMiddleGrey + 0.2 * (v - kMiddleGrey); }); }},
    {SourceWords("dark 0.3"), "grey values times 0.3",
     [](const Image& image) { return toned(image, [](double v) { return 0.3 * v; }); }},
    {SourceWords("dark 0.1"), "grey values times 0.1",
     [](const Image& image) { return toned(image, [](double v) { return 0.1 * v; }); }},
    {SourceWords("bright 1.2"), "overexposed: grey values times 1.2, what is brighter than white is white",
     [](const Image& image) { return toned(image, [](double v) { return 1.2 * v; }); }},
};

struct At {
    double x, y;
};

At middle_of(std::uint32_t pixel, int width) {
    const auto w = static_cast<std::uint32_t>(width);
    return {static_cast<double>(pixel % w) + 0.5, static_cast<double>(pixel / w) + 0.5};
}

}  // namespace

std::span<const Disturbance> disturbances() { return kDisturbances; }

PixelSet brought_back(const PixelSet& lines, const Disturbed& disturbed, int width, int height) {
    PixelSet back{width, height, {}};
    const double c = std::cos(disturbed.angle), s = std::sin(disturbed.angle);
    for (const std::uint32_t pixel : lines.pixels) {
        const At from = middle_of(pixel, lines.width);
        const double x = std::floor(c * from.x - s * from.y + disturbed.shift_x);
        const double y = std::floor(s * from.x + c * from.y + disturbed.shift_y);
        if (x < 0 || y < 0 || x >= width || y >= height) continue;
        back.pixels.push_back(static_cast<std::uint32_t>(y) * static_cast<std::uint32_t>(width) + static_cast<std::uint32_t>(x));
    }
    std::sort(back.pixels.begin(), back.pixels.end());
    back.pixels.erase(std::unique(back.pixels.begin(), back.pixels.end()), back.pixels.end());
    return back;
}

PixelSet seen_by_both(const PixelSet& lines, const Disturbed& disturbed, double margin) {
    PixelSet seen{lines.width, lines.height, {}};
    const bool moved = disturbed.angle != 0 || disturbed.shift_x != 0 || disturbed.shift_y != 0 ||
                       disturbed.width != lines.width || disturbed.height != lines.height;
    if (!moved) return lines;
    const double c = std::cos(disturbed.angle), s = std::sin(disturbed.angle);
    const auto inside = [&](double x, double y, int width, int height) {
        return x >= margin && y >= margin && x <= width - margin && y <= height - margin;
    };
    for (const std::uint32_t pixel : lines.pixels) {
        const At at = middle_of(pixel, lines.width);
        const double x = at.x - disturbed.shift_x, y = at.y - disturbed.shift_y;
        if (inside(at.x, at.y, lines.width, lines.height) &&
            inside(c * x + s * y, c * y - s * x, disturbed.width, disturbed.height))
            seen.pixels.push_back(pixel);
    }
    return seen;
}

Image with_noise(Image image, double deviation, std::uint64_t seed) {
    RandomNumbers random(seed);
    for (auto& value : image.pixels) value = sample(value + deviation * normal(random));
    return image;
}

}  // namespace tactics
