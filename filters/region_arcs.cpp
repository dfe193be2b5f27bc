// SPDX-License-Identifier: Apache-2.0
#include "filters/region_arcs.h"

#include <array>

namespace tactics {

namespace {

// The ways from a corner of pixels: right, down, left, up.
constexpr std::array<int, 4> kAcross{1, 0, -1, 0};
constexpr std::array<int, 4> kDown{0, 1, 0, -1};
constexpr int opposite(int way) { return (way + 2) % 4; }

class Corners {
public:
    Corners(std::span<const std::uint32_t> labels, int width, int height)
        : labels_(labels),
          width_(width),
          height_(height),
          ways_(static_cast<std::size_t>(width + 1) * static_cast<std::size_t>(height + 1), 0) {
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                if (x > 0 && label(x - 1, y) != label(x, y)) add(x, y, 1);
                if (y > 0 && label(x, y - 1) != label(x, y)) add(x, y, 0);
            }
    }

    PlanarMap walked() {
        PlanarMap map;
        junction_.assign(ways_.size(), -1);
        for (int y = 0; y <= height_; ++y)
            for (int x = 0; x <= width_; ++x) {
                const int count = __builtin_popcount(ways_[at(x, y)]);
                if (count == 0 || count == 2) continue;
                junction_[at(x, y)] = static_cast<int>(map.junctions.size());
                map.junctions.push_back({static_cast<double>(x), static_cast<double>(y)});
            }
        left_ = ways_;
        for (int y = 0; y <= height_; ++y)
            for (int x = 0; x <= width_; ++x)
                if (junction_[at(x, y)] >= 0)
                    for (int way = 0; way < 4; ++way)
                        if ((left_[at(x, y)] & 1 << way) != 0) map.arcs.push_back(walk(x, y, way));
        for (int y = 0; y <= height_; ++y)
            for (int x = 0; x <= width_; ++x)
                for (int way = 0; way < 4; ++way)
                    if ((left_[at(x, y)] & 1 << way) != 0) map.arcs.push_back(walk(x, y, way));
        return map;
    }

private:
    std::size_t at(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_ + 1) + static_cast<std::size_t>(x);
    }
    std::uint32_t label(int x, int y) const {
        return labels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)];
    }

    void add(int x, int y, int way) {
        const auto u = static_cast<std::size_t>(way);
        ways_[at(x, y)] |= static_cast<std::uint8_t>(1 << way);
        ways_[at(x + kAcross[u], y + kDown[u])] |= static_cast<std::uint8_t>(1 << opposite(way));
    }

    // The faces on the left and on the right of the step that way; y is down.
    std::array<std::uint32_t, 2> beside(int x, int y, int way) const {
        switch (way) {
            case 0: return {label(x, y - 1), label(x, y)};
            case 1: return {label(x, y), label(x - 1, y)};
            case 2: return {label(x - 1, y), label(x - 1, y - 1)};
            default: return {label(x - 1, y - 1), label(x, y - 1)};
        }
    }

    RegionArc walk(int x, int y, int way) {
        RegionArc arc;
        arc.faces = beside(x, y, way);
        const std::size_t start = at(x, y);
        arc.junctions[0] = junction_[start];
        arc.points.push_back({static_cast<double>(x), static_cast<double>(y)});
        for (;;) {
            left_[at(x, y)] &= static_cast<std::uint8_t>(~(1 << way));
            x += kAcross[static_cast<std::size_t>(way)];
            y += kDown[static_cast<std::size_t>(way)];
            left_[at(x, y)] &= static_cast<std::uint8_t>(~(1 << opposite(way)));
            if (at(x, y) == start && junction_[start] < 0) {
                arc.closed = true;
                return arc;
            }
            arc.points.push_back({static_cast<double>(x), static_cast<double>(y)});
            if (junction_[at(x, y)] >= 0) {
                arc.junctions[1] = junction_[at(x, y)];
                return arc;
            }
            way = __builtin_ctz(left_[at(x, y)]);
        }
    }

    std::span<const std::uint32_t> labels_;
    int width_, height_;
    std::vector<std::uint8_t> ways_, left_;  // of each corner, a bit for each way on which there is a boundary
    std::vector<int> junction_;              // of each corner, or -1
};

}  // namespace

PlanarMap planar_map_of(std::span<const std::uint32_t> labels, int width, int height) {
    return Corners(labels, width, height).walked();
}

}  // namespace tactics
