// SPDX-License-Identifier: Apache-2.0
#include "filters/legend_frame.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

#include "filters/darken.h"

namespace tactics {

namespace {

constexpr int kFrameInk = 240;        // of 255 is the ground: frames may be as pale
constexpr double kFrameAround = 2.5;  // heights of letters from what is in it
constexpr double kWholeSide = 0.85;   // of its length is ink: corners may be round
constexpr double kLongestTick = 2;    // heights of letters

// Pixels, for letters of that height: more is a bar, no side.
int thickest_side(double height) { return std::max(6, static_cast<int>(height / 4)); }
// What fades around a side that goes is none of a side that stays.
int fading(double height) { return std::max(3, static_cast<int>(height / 8)); }

// One side of a rectangle, seen as if it were the left one.
struct KeySide {
    int outer = 0, inner = 0;  // the line is from the one up to the other
};

// Pixels of a picture that is turned so that a side is at the left.
struct TurnedInk {
    const Image& ink;
    int quarter = 0;  // 0: left, 1: top, 2: right, 3: bottom

    int across() const { return quarter % 2 == 0 ? ink.width : ink.height; }
    int down() const { return quarter % 2 == 0 ? ink.height : ink.width; }
    bool at(int x, int y) const {
        const int u = quarter < 2 ? x : across() - 1 - x;
        return (quarter % 2 == 0 ? ink.row(y)[u] : ink.row(u)[y]) < kFrameInk;
    }
    PixelBox turned(const PixelBox& box) const {
        const PixelBox own = quarter % 2 == 0 ? box : PixelBox{box.top, box.left, box.bottom, box.right};
        return quarter < 2 ? own : PixelBox{across() - own.right, own.top, across() - own.left, own.bottom};
    }
    PixelBox back(const PixelBox& box) const {
        const PixelBox own = quarter < 2 ? box : PixelBox{across() - box.right, box.top, across() - box.left, box.bottom};
        return quarter % 2 == 0 ? own : PixelBox{own.top, own.left, own.bottom, own.right};
    }
};

double inked_share(const TurnedInk& ink, int x, int top, int bottom) {
    int count = 0;
    for (int y = top; y < bottom; ++y) count += ink.at(x, y) ? 1 : 0;
    return bottom > top ? static_cast<double>(count) / (bottom - top) : 0;
}

// The nearest line at the left of what is inside.
std::optional<KeySide> side_of(const TurnedInk& ink, const PixelBox& inside, double height) {
    const int last = std::max(0, inside.left - static_cast<int>(kFrameAround * height));
    for (int x = inside.left - 1; x >= last; --x) {
        if (inked_share(ink, x, inside.top, inside.bottom) < kWholeSide) continue;
        KeySide side{x, x + 1};
        while (side.outer > 0 && inked_share(ink, side.outer - 1, inside.top, inside.bottom) >= kWholeSide) --side.outer;
        if (side.inner - side.outer > thickest_side(height)) return std::nullopt;
        return side;
    }
    return std::nullopt;
}

// Beyond a corner of the frame there is more of it than a tick.
bool goes_on_beyond(const TurnedInk& ink, const PixelBox& frame, double height) {
    const int more = std::max(3, static_cast<int>(kLongestTick * height));
    const auto inked = [&](int top, int bottom) {
        top = std::clamp(top, 0, ink.down());
        bottom = std::clamp(bottom, 0, ink.down());
        double most = 0;
        for (int x = frame.left; x < std::min(frame.left + thickest_side(height), ink.across()); ++x)
            most = std::max(most, inked_share(ink, x, top, bottom));
        return most >= kWholeSide;
    };
    return inked(frame.top - more, frame.top - 1) || inked(frame.bottom + 1, frame.bottom + more);
}

bool holds_more(const Image& ink, const PixelBox& frame, const std::vector<PixelBox>& legend, double height) {
    const int beside = std::max(3, static_cast<int>(height / 3)), corner = thickest_side(height);
    int more = 0;
    for (int y = frame.top + corner; y < frame.bottom - corner; ++y)
        for (int x = frame.left + corner; x < frame.right - corner; ++x)
            if (ink.row(y)[x] < kFrameInk && std::none_of(legend.begin(), legend.end(), [&](const PixelBox& box) {
                    return x >= box.left - beside && x < box.right + beside && y >= box.top - beside && y < box.bottom + beside;
                }))
                ++more;
    return more > height;  // a few pixels are what is left of letters
}

}  // namespace

std::vector<PixelBox> legend_frame(const Image& picture, const std::vector<PixelBox>& legend, double height) {
    if (legend.empty()) return {};
    PixelBox inside = legend.front();
    for (const PixelBox& box : legend) inside = around(inside, box);
    const Image ink = ink_on_white(picture);
    std::array<PixelBox, 4> sides;
    for (int quarter = 0; quarter < 4; ++quarter) {
        const TurnedInk turned{ink, quarter};
        const PixelBox own = turned.turned(inside);
        const auto side = side_of(turned, own, height);
        if (!side) return {};
        sides[static_cast<std::size_t>(quarter)] = turned.back({side->outer, own.top, side->inner, own.bottom});
    }
    const PixelBox frame{sides[0].left, sides[1].top, sides[2].right, sides[3].bottom};
    if (holds_more(ink, frame, legend, height)) return {};
    std::array<bool, 4> stays{};
    for (int quarter = 0; quarter < 4; ++quarter) {
        const TurnedInk turned{ink, quarter};
        stays[static_cast<std::size_t>(quarter)] = goes_on_beyond(turned, turned.turned(frame), height);
    }
    // Corners belong to what stays.
    const int from_axis = fading(height);
    const PixelBox going{stays[0] ? sides[0].right + from_axis : frame.left, stays[1] ? sides[1].bottom + from_axis : frame.top,
                         stays[2] ? sides[2].left - from_axis : frame.right, stays[3] ? sides[3].top - from_axis : frame.bottom};
    std::vector<PixelBox> found;
    for (std::size_t quarter = 0; quarter < 4; ++quarter) {
        const PixelBox& side = sides[quarter];
        if (stays[quarter]) continue;
        found.push_back(quarter % 2 == 0 ? PixelBox{side.left, going.top, side.right, going.bottom}
                                         : PixelBox{going.left, side.top, going.right, side.bottom});
    }
    return found;
}

}  // namespace tactics
