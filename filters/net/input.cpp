// SPDX-License-Identifier: Apache-2.0
#include "filters/net/input.h"

#include <cmath>
#include <cstdlib>
#include <vector>

namespace tactics {

namespace {

std::int64_t square_root(std::int64_t of) {
    auto root = static_cast<std::int64_t>(std::sqrt(static_cast<double>(of)));
    while (root * root > of) --root;
    while ((root + 1) * (root + 1) <= of) ++root;
    return root;
}

// The picture goes on beyond its border as its mirror image, the outermost pixel not repeated.
int mirrored(int i, int length) {
    if (length == 1) return 0;
    const int period = 2 * (length - 1);
    i = std::abs(i) % period;
    return i < length ? i : period - i;
}

// Gaussians of 1, 2 and 4 pixels, cut at 3 sigma, from the middle on; the whole sums to 4096.
constexpr std::array<std::int16_t, 4> kGauss1 = {1636, 991, 221, 18};
constexpr std::array<std::int16_t, 7> kGauss2 = {816, 722, 496, 266, 111, 36, 9};
constexpr std::array<std::int16_t, 13> kGauss4 = {408, 397, 361, 309, 248, 187, 133, 89, 55, 33, 18, 9, 5};
static_assert(kInputReach == kGauss4.size() - 1 + 1);

// Planes of one channel between the picture and its derivatives, 9 bits of fraction: within 10200, so two fit into an int16.
struct Sheet {
    Sheet(int wide, int high)
        : width(wide), height(high), values(static_cast<std::size_t>(wide) * static_cast<std::size_t>(high)) {}
    std::int16_t* row(int y) { return values.data() + static_cast<std::ptrdiff_t>(y) * width; }
    const std::int16_t* row(int y) const { return values.data() + static_cast<std::ptrdiff_t>(y) * width; }
    int width, height;
    std::vector<std::int16_t> values;
};

using Sums = std::vector<std::int32_t>;

void begin_sums(Sums& sums, const std::int16_t* middle, std::int16_t weight, int width) {
    for (int x = 0; x < width; ++x) sums[static_cast<std::size_t>(x)] = weight * middle[x] + 2048;
}

// Two neighbours at a time, as long as there are: sums are read and written half as often.
template <std::size_t Taps, class Rows>
void smooth_row(const std::array<std::int16_t, Taps>& kernel, const Rows& row_at, Sums& sums, std::int16_t* out, int width) {
    begin_sums(sums, row_at(0), kernel[0], width);
    std::int32_t* sum = sums.data();
    for (int t = 1; t < static_cast<int>(Taps); t += 3) {
        const std::int16_t *a = row_at(-t), *b = row_at(t), *c = row_at(-t - 1), *d = row_at(t + 1), *e = row_at(-t - 2),
                           *f = row_at(t + 2);
        const std::int16_t k0 = kernel[static_cast<std::size_t>(t)], k1 = kernel[static_cast<std::size_t>(t + 1)],
                           k2 = kernel[static_cast<std::size_t>(t + 2)];
        for (int x = 0; x < width; ++x)
            sum[x] += k0 * static_cast<std::int16_t>(a[x] + b[x]) + k1 * static_cast<std::int16_t>(c[x] + d[x]) +
                      k2 * static_cast<std::int16_t>(e[x] + f[x]);
    }
    for (int x = 0; x < width; ++x) out[x] = static_cast<std::int16_t>(sum[x] >> 12);
}

template <std::size_t Taps>
void smooth(const std::array<std::int16_t, Taps>& kernel, const Sheet& from, Sheet& between, Sheet& to) {
    static_assert(Taps % 3 == 1);
    constexpr int kReach = static_cast<int>(Taps) - 1;
    const int width = from.width, height = from.height;
    Sums sums(static_cast<std::size_t>(width));
    std::vector<std::int16_t> wide(static_cast<std::size_t>(width + 2 * kReach));
    for (int y = 0; y < height; ++y) {
        std::int16_t* middle = wide.data() + kReach;
        std::copy_n(from.row(y), width, middle);
        for (int x = 1; x <= kReach; ++x) {
            middle[-x] = from.row(y)[mirrored(-x, width)];
            middle[width - 1 + x] = from.row(y)[mirrored(width - 1 + x, width)];
        }
        smooth_row(
            kernel, [&](int away) { return middle + away; }, sums, between.row(y), width);
    }
    for (int y = 0; y < height; ++y)
        smooth_row(
            kernel, [&](int away) { return between.row(mirrored(y + away, height)); }, sums, to.row(y), width);
}

// Luminance and two opponent colours, from the colours of 2 x 2 pixels.
std::array<Sheet, 3> opponents_of(const NetPlane& input) {
    const int width = input.width(), height = input.height();
    std::array<Sheet, 3> sheets = {Sheet(width, height), Sheet(width, height), Sheet(width, height)};
    for (int y = 0; y < height; ++y) {
        const std::int16_t* in = input.at(0, y);
        for (int x = 0; x < width; ++x, in += input.channels()) {
            const int blue = in[0] + in[1] + in[2] + in[3], green = in[4] + in[5] + in[6] + in[7],
                      red = in[8] + in[9] + in[10] + in[11];
            sheets[0].row(y)[x] = static_cast<std::int16_t>((blue + 2 * green + red + 4) >> 3);
            sheets[1].row(y)[x] = static_cast<std::int16_t>((red - green + 1) >> 1);
            sheets[2].row(y)[x] = static_cast<std::int16_t>((2 * blue - green - red + 2) >> 2);
        }
    }
    return sheets;
}

// |derivative| along the rows, down, and along both diagonals, of one row of one sheet.
void add_derivatives(const Sheet& sheet, int y, std::array<Sums, 4>& sums) {
    const int width = sheet.width;
    const std::int16_t *here = sheet.row(y), *above = sheet.row(std::max(y - 1, 0)),
                       *below = sheet.row(std::min(y + 1, sheet.height - 1));
    std::int32_t *along = sums[0].data(), *down = sums[1].data(), *falling = sums[2].data(), *rising = sums[3].data();
    const auto add = [&](int x, int left, int right) {
        const int a = here[right] - here[left], d = below[x] - above[x];
        along[x] += std::abs(a);
        down[x] += std::abs(d);
        falling[x] += std::abs(a + d);
        rising[x] += std::abs(a - d);
    };
    add(0, 0, std::min(1, width - 1));
    for (int x = 1; x < width - 1; ++x) add(x, x - 1, x + 1);
    if (width > 1) add(width - 1, width - 2, width - 1);
}

void put_derivatives(const std::array<Sheet, 3>& smoothed, int sigma, int first_channel, NetPlane& input) {
    std::array<Sums, 4> sums;
    const int factor = 2 * sigma + 1;  // half of it evens out what smoothing took
    for (int y = 0; y < input.height(); ++y) {
        for (Sums& sum : sums) sum.assign(static_cast<std::size_t>(input.width()), 0);
        for (const Sheet& sheet : smoothed) add_derivatives(sheet, y, sums);
        std::int16_t* out = input.at(0, y) + first_channel;
        for (std::size_t x = 0; x < static_cast<std::size_t>(input.width()); ++x, out += input.channels()) {
            const auto held = [](int value) { return static_cast<std::int16_t>(std::min(value, kMostActivation)); };
            out[0] = held((sums[0][x] * factor + 2) >> 2);
            out[1] = held((sums[1][x] * factor + 2) >> 2);
            out[2] = held((sums[2][x] * factor * 181 + 512) >> 10);  // 181 / 256 is the root of a half
            out[3] = held((sums[3][x] * factor * 181 + 512) >> 10);
        }
    }
}

void put_colours(const Image& image, const NetLevels& levels, int left, int top, NetPlane& input) {
    std::vector<int> columns;
    for (int x = 0; x < 2 * input.width(); ++x) columns.push_back(mirrored(left + x, image.width) * image.channels);
    const int green = image.channels == 3 ? 1 : 0, blue = 2 * green;  // grey is all three
    for (int y = 0; y < 2 * input.height(); ++y) {
        const std::uint8_t* row = image.row(mirrored(top + y, image.height));
        for (std::size_t x = 0; x < columns.size(); ++x) {
            const std::uint8_t* pixel = row + columns[x];
            std::int16_t* out = input.at(static_cast<int>(x / 2), y / 2) + y % 2 * 2 + static_cast<int>(x % 2);
            out[0] = levels[pixel[blue]];
            out[4] = levels[pixel[green]];
            out[8] = levels[pixel[0]];
        }
    }
}

}  // namespace

NetLevels net_levels(const Image& image) {
    std::array<std::int64_t, 256> histogram{};
    const std::size_t count = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    for (std::size_t i = 0; i < count; ++i) ++histogram[image.channels == 3 ? luma(&image.pixels[3 * i]) : image.pixels[i]];
    // All in 256ths of a level; squares of 10^9 pixels still fit.
    const auto pixels = static_cast<std::int64_t>(count);
    std::int64_t sum = 0, squares = 0;
    for (std::int64_t v = 0; v < 256; ++v) sum += histogram[static_cast<std::size_t>(v)] * v;
    const std::int64_t mean = (256 * sum + pixels / 2) / pixels;
    for (std::int64_t v = 0; v < 256; ++v)
        squares += histogram[static_cast<std::size_t>(v)] * (256 * v - mean) * (256 * v - mean);
    const std::int64_t deviation = std::max<std::int64_t>(square_root(squares / pixels), 1);
    // A deviation of 48 levels is what the net was fitted to; gains from 0.7 to 5, 16 bits of fraction.
    const std::int64_t gain = std::clamp<std::int64_t>((48LL << 24) / deviation, 45'875, 327'680);
    NetLevels levels{};
    for (std::int64_t v = 0; v < 256; ++v)
        levels[static_cast<std::size_t>(v)] = static_cast<std::int16_t>(((256 * v - mean) * gain + (1 << 21)) >> 22);
    return levels;
}

void see(const Image& image, const NetLevels& levels, int left, int top, NetPlane& input) {
    put_colours(image, levels, left, top, input);
    const std::array<Sheet, 3> sheets = opponents_of(input);
    Sheet between(input.width(), input.height());
    std::array<Sheet, 3> smoothed = sheets;
    const auto derive = [&](const auto& kernel, int sigma, int first_channel) {
        for (std::size_t i = 0; i < sheets.size(); ++i) smooth(kernel, sheets[i], between, smoothed[i]);
        put_derivatives(smoothed, sigma, first_channel, input);
    };
    derive(kGauss1, 1, 12);
    derive(kGauss2, 2, 16);
    derive(kGauss4, 4, 20);
}

}  // namespace tactics
