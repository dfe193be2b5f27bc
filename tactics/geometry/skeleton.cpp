// SPDX-License-Identifier: Apache-2.0
#include "tactics/geometry/skeleton.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <utility>

namespace tactics {

namespace {

constexpr std::uint8_t kInk = 1;
constexpr std::uint8_t kQueued = 2;
constexpr int kLayerShift = 2;
constexpr int kMostLayers = 63;

// Which ink pixels go in each of the two half passes, by their neighbours. The conditions are those of Z. Guo and
// R. W. Hall, "Parallel thinning with two-subiteration algorithms", CACM 32(3), 1989, algorithm A1. Against the better
// known method of Zhang and Suen it keeps 2 x 2 blocks and thins slanted lines down to one pixel.
constexpr bool goes(unsigned code, bool second) {
    const auto p = [code](unsigned bit) { return ((code >> bit) & 1u) != 0; };
    const bool n = p(0), ne = p(1), e = p(2), se = p(3), s = p(4), sw = p(5), w = p(6), nw = p(7);
    const int crossings = (!n && (ne || e)) + (!e && (se || s)) + (!s && (sw || w)) + (!w && (nw || n));
    const int pairs_one = (nw || n) + (ne || e) + (se || s) + (sw || w);
    const int pairs_two = (n || ne) + (e || se) + (s || sw) + (w || nw);
    const int pairs = std::min(pairs_one, pairs_two);
    const bool held = second ? ((s || sw || !nw) && w) : ((n || ne || !se) && e);
    return crossings == 1 && pairs >= 2 && pairs <= 3 && !held;
}

constexpr auto make_table() {
    std::array<std::array<bool, 256>, 2> table{};
    for (unsigned code = 0; code < 256; ++code) {
        table[0][code] = goes(code, false);
        table[1][code] = goes(code, true);
    }
    return table;
}
constexpr auto kGoes = make_table();

// Calls `visit` with the offset of every ink pixel, row by row; eight white pixels cost one comparison.
template <typename Visit>
void for_ink(const InkMap& map, Visit visit) {
    constexpr std::uint64_t kEight = 0x0101010101010101u;
    const std::uint8_t* bytes = map.bytes.data();
    const std::size_t size = map.bytes.size();
    std::size_t at = 0;
    for (; at + 8 <= size; at += 8) {
        std::uint64_t word;
        std::memcpy(&word, bytes + at, 8);
        if constexpr (std::endian::native == std::endian::little) {
            for (word &= kEight; word != 0; word &= word - 1)
                visit(static_cast<std::uint32_t>(at + static_cast<std::size_t>(std::countr_zero(word)) / 8));
        } else if ((word & kEight) != 0) {
            for (std::size_t i = at; i < at + 8; ++i)
                if ((bytes[i] & kInk) != 0) visit(static_cast<std::uint32_t>(i));
        }
    }
    for (; at < size; ++at)
        if ((bytes[at] & kInk) != 0) visit(static_cast<std::uint32_t>(at));
}

std::array<std::ptrdiff_t, 8> offsets_of(std::ptrdiff_t stride) {
    std::array<std::ptrdiff_t, 8> offsets{};
    for (std::size_t i = 0; i < 8; ++i) offsets[i] = kSteps[i].y * stride + kSteps[i].x;
    return offsets;
}

}  // namespace

InkMap::InkMap(int w, int h)
    : width(w), height(h), stride(w + 2), bytes(static_cast<std::size_t>(w + 2) * static_cast<std::size_t>(h + 2), 0) {}

InkMap ink_of(const Image& grey) {
    InkMap map(grey.width, grey.height);
    const int width = grey.width;  // bytes written might alias what is not a local
    for (int y = 0; y < grey.height; ++y) {
        const std::uint8_t* from = grey.row(y);
        std::uint8_t* to = map.row(y);
        for (int x = 0; x < width; ++x) to[x] = from[x] < 128;
    }
    return map;
}

InkMap ink_of(const EdgeMap& edges) {
    InkMap map(edges.width, edges.height);
    const int width = edges.width;
    for (int y = 0; y < edges.height; ++y) {
        const float* from = edges.strength.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
        std::uint8_t* to = map.row(y);
        for (int x = 0; x < width; ++x) to[x] = from[x] > 0;
    }
    return map;
}

double Skeleton::half_width(std::uint32_t pixel) const {
    const std::uint8_t* at = map.bytes.data() + pixel;
    int deepest = 0;
    for (const std::ptrdiff_t offset : offsets_of(map.stride)) deepest = std::max(deepest, at[offset] >> kLayerShift);
    return deepest + 0.5;
}

Skeleton thin(InkMap ink) {
    std::uint8_t* bytes = ink.bytes.data();
    const std::ptrdiff_t stride = ink.stride;
    const auto offsets = offsets_of(stride);

    // Only these can go: at first those that the tables name, later those whose neighbours have changed meanwhile.
    std::vector<std::uint32_t> active, gone;
    for_ink(ink, [&](std::uint32_t pixel) {
        const unsigned code = neighbours_of(bytes + pixel, stride);
        if (!kGoes[0][code] && !kGoes[1][code]) return;
        bytes[pixel] |= kQueued;
        active.push_back(pixel);
    });
    const auto queue_around = [&](std::uint32_t pixel) {
        for (const std::ptrdiff_t offset : offsets) {
            const auto next = static_cast<std::uint32_t>(static_cast<std::ptrdiff_t>(pixel) + offset);
            if ((bytes[next] & (kInk | kQueued)) != kInk) continue;
            bytes[next] |= kQueued;
            active.push_back(next);
        }
    };
    for (int layer = 1; !active.empty(); ++layer) {
        const auto mark = static_cast<std::uint8_t>(std::min(layer, kMostLayers) << kLayerShift);
        gone.clear();
        for (const auto& table : kGoes) {
            // First all are judged, then all that go are taken, as if at the same moment.
            const std::size_t before = gone.size();
            for (const std::uint32_t pixel : active)
                if ((bytes[pixel] & kInk) != 0 && table[neighbours_of(bytes + pixel, stride)]) gone.push_back(pixel);
            for (std::size_t i = before; i < gone.size(); ++i) bytes[gone[i]] = mark;
            for (std::size_t i = before; i < gone.size(); ++i) queue_around(gone[i]);
        }
        for (const std::uint32_t pixel : active) bytes[pixel] &= static_cast<std::uint8_t>(~kQueued);
        active.clear();
        for (const std::uint32_t pixel : gone) queue_around(pixel);
    }

    Skeleton skeleton{std::move(ink), {}};
    for_ink(skeleton.map, [&](std::uint32_t pixel) { skeleton.pixels.push_back(pixel); });
    return skeleton;
}

}  // namespace tactics
