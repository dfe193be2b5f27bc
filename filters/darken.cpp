// SPDX-License-Identifier: Apache-2.0
// What was drawn with, whatever its colour, on whatever ground: chalk on a board, yellow on white, a light curve of a dark chart.
//
// To an eye a yellow line on white is as much a line as a black one; in grey it is nearly nothing. A colour counts as dark as the
// channel in which it is farthest from the ground's.
#include "filters/darken.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <utility>
#include <vector>

#include "filters/lab.h"
#include "tactics/filter.h"

namespace tactics {

namespace {

using Colour = std::array<int, 3>;

// Up to which pixel, in rows one after the other, the picture goes on in the colour of that one, as most of what was drawn does.
std::size_t end_of_colour(const Image& image, std::size_t pixel, std::size_t end) {
    const auto channels = static_cast<std::size_t>(image.channels);
    const std::uint8_t* first = &image.pixels[pixel * channels];
    const std::size_t bytes = (end - pixel - 1) * channels;  // that may be as those a pixel before them
    std::size_t same = 0;
    for (std::uint64_t here = 0, before = 0; same + sizeof here <= bytes; same += sizeof here) {
        std::memcpy(&before, first + same, sizeof before);
        std::memcpy(&here, first + same + channels, sizeof here);
        if (here != before) break;
    }
    while (same < bytes && first[same] == first[same + channels]) ++same;
    return pixel + 1 + same / channels;
}

// 1: ink is darker than the ground, -1: lighter. It begins sharply, which paper that is lit unevenly does not.
int sign_of_ink(const Image& image, const Colour& ground) {
    constexpr int kInk = 48, kGround = 24;  // grey levels off the ground
    constexpr int kReach = 3;               // pixels in which a line has begun
    const auto channels = static_cast<std::size_t>(image.channels);
    const std::size_t row = static_cast<std::size_t>(image.width) * channels;
    const auto off = [&](std::size_t at) {
        int most = 0;
        for (std::size_t c = 0; c < channels; ++c)
            if (const int by = ground[c] - image.pixels[at + c]; std::abs(by) > std::abs(most)) most = by;
        return most;
    };
    std::size_t darker = 0, lighter = 0;
    const auto width = static_cast<std::size_t>(image.width);
    for (std::size_t y = kReach; y < static_cast<std::size_t>(image.height); ++y)
        for (std::size_t x = kReach; x < width;) {
            const std::size_t end = end_of_colour(image, y * width + x, (y + 1) * width) - y * width;
            const int here = off(y * row + x * channels);
            for (; x < end && std::abs(here) > kInk; ++x) {
                const std::size_t at = y * row + x * channels;
                if (std::abs(off(at - kReach * channels)) <= kGround || std::abs(off(at - kReach * row)) <= kGround)
                    ++(here > 0 ? darker : lighter);
            }
            x = end;
        }
    return lighter > darker ? -1 : 1;
}

}  // namespace

// The commonest colour, within an eighth of the range: grain spreads a ground over some levels. Paper is white, and less may be
// left of it than is painted in one colour, most of all where the margins are cut off. A paler colour may be paper in the shade.
std::array<int, 3> ground_of(const Image& image) {
    constexpr int kShift = 5, kCells = 8;
    constexpr double kWhiteOfMost = 0.4;        // setting
    constexpr int kWhite = 240, kPainted = 96;  // levels: paper is no darker, and paint so far off it in a channel
    struct Cell {
        std::size_t count = 0;
        std::array<std::size_t, 3> sum{};
    };
    std::vector<Cell> cells(kCells * kCells * kCells);
    Cell white;
    const auto channels = static_cast<std::size_t>(image.channels);
    const std::size_t pixels = image.pixels.size() / channels;
    for (std::size_t i = 0, next = 0; i < pixels; i = next) {
        const std::uint8_t* pixel = &image.pixels[i * channels];
        next = end_of_colour(image, i, pixels);
        const std::size_t count = next - i;
        const std::array<int, 3> colour{pixel[0], pixel[channels == 3 ? 1 : 0], pixel[channels == 3 ? 2 : 0]};
        Cell& cell = cells[static_cast<std::size_t>(((colour[0] >> kShift) * kCells + (colour[1] >> kShift)) * kCells +
                                                    (colour[2] >> kShift))];
        const auto add = [&](Cell& to) {
            to.count += count;
            for (std::size_t c = 0; c < 3; ++c) to.sum[c] += count * static_cast<std::size_t>(colour[c]);
        };
        add(cell);
        if (std::min({colour[0], colour[1], colour[2]}) >= kWhite) add(white);
    }
    const auto mean = [](const Cell& cell) {
        Colour colour{};
        for (std::size_t c = 0; c < 3; ++c) colour[c] = static_cast<int>(cell.sum[c] / std::max<std::size_t>(1, cell.count));
        return colour;
    };
    const Cell& most =
        *std::max_element(cells.begin(), cells.end(), [](const Cell& a, const Cell& b) { return a.count < b.count; });
    const bool is_paper = static_cast<double>(white.count) >= kWhiteOfMost * static_cast<double>(most.count) &&
                          channels_apart(mean(white), mean(most)) >= kPainted;
    return mean(is_paper ? white : most);
}

std::vector<Image> inks_on_white(const Image& image) {
    const Colour ground = ground_of(image);
    const int sign = sign_of_ink(image, ground);
    const auto channels = static_cast<std::size_t>(image.channels);
    std::vector<Image> inks(channels, make_image(image.width, image.height, 1, image.mm_per_pixel, 255));
    for (std::size_t i = 0, next = 0; i < inks.front().pixels.size(); i = next) {
        next = end_of_colour(image, i, inks.front().pixels.size());
        for (std::size_t c = 0; c < channels; ++c) {
            const int off = std::max(0, sign * (ground[c] - image.pixels[i * channels + c]));
            std::fill_n(&inks[c].pixels[i], next - i, static_cast<std::uint8_t>(255 - off));
        }
    }
    return inks;
}

Image ink_on_white(const Image& image) {
    const Colour ground = ground_of(image);
    const int sign = sign_of_ink(image, ground);
    Image ink = make_image(image.width, image.height, 1, image.mm_per_pixel, 255);
    const auto channels = static_cast<std::size_t>(image.channels);
    for (std::size_t i = 0, next = 0; i < ink.pixels.size(); i = next) {
        next = end_of_colour(image, i, ink.pixels.size());
        int most = 0;
        for (std::size_t c = 0; c < channels; ++c) most = std::max(most, sign * (ground[c] - image.pixels[i * channels + c]));
        std::fill_n(&ink.pixels[i], next - i, static_cast<std::uint8_t>(255 - most));
    }
    return ink;
}

namespace {

Artwork apply_darken(Artwork artwork, const Settings&) { return ink_on_white(std::get<Image>(artwork)); }

}  // namespace

extern const Filter darken_filter;
const Filter darken_filter{
    .name = "darken",
    .summary =
        "turns everything that differs from the background into dark ink on white: coloured lines, and light lines on a "
        "dark background",
    .takes = static_cast<Kinds>(Kind::picture),
    .gives = static_cast<Kinds>(Kind::picture),
    .uses_colour = true,
    .apply = apply_darken,
};

Image black_ink(const Image& picture) {
    constexpr std::uint8_t kBlack = 100, kNoInk = 170;
    Image ink = to_grey(picture);
    for (std::uint8_t& sample : ink.pixels) sample = sample < kBlack ? std::uint8_t{0} : std::max(sample, kNoInk);
    return ink;
}

}  // namespace tactics
