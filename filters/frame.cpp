// SPDX-License-Identifier: Apache-2.0
#include "filters/frame.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "filters/lab.h"

namespace tactics {

namespace {

constexpr int kAlike = 12;           // levels: JPEG of quality 50 and more, in a plain bar
constexpr double kStray = 0.02;      // of a bar's samples may differ by more: where it meets the picture, JPEG rings
constexpr int kMean = 4;             // levels that a row's mean may be off; a sky that darkens slowly gets no further
constexpr int kBarStep = 24;         // levels from the bar to what is in the picture, in any channel
constexpr double kAlone = 0.95;      // of a side's length where a bar must end at once if no other bar backs it
constexpr double kBacked = 0.5;      // if there is one on the opposite side: there may be dark places at the edge of a picture
constexpr double kTogether = 0.75;   // of all of their lengths
constexpr double kCorners = 0.03;    // of a side's length at either end is not looked at: corners may be round
constexpr int kSoftened = 150;       // a longest side of as many pixels more blurs an edge by a pixel more
constexpr double kLeastLeft = 0.25;  // of a side must be left: an upright picture on a wide screen has 0.32

enum FrameSide { kLeft, kTop, kRight, kBottom };

using FrameColour = std::array<int, 3>;

// A rectangle of an image seen from one of its sides: line 0 is the outermost.
class View {
public:
    View(const Image& image, const PixelBox& part, FrameSide side) : image_(image), part_(part), side_(side) {}

    bool upright() const { return side_ == kLeft || side_ == kRight; }
    int lines() const { return upright() ? part_.width() : part_.height(); }
    int length() const { return upright() ? part_.height() : part_.width(); }
    FrameColour at(int line, int along) const {
        const int inside = side_ == kRight || side_ == kBottom ? lines() - 1 - line : line;
        const int x = part_.left + (upright() ? inside : along), y = part_.top + (upright() ? along : inside);
        const std::uint8_t* sample = image_.row(y) + static_cast<std::ptrdiff_t>(x) * image_.channels;
        if (image_.channels == 1) return {sample[0], sample[0], sample[0]};
        return {sample[0], sample[1], sample[2]};
    }

private:
    const Image& image_;
    PixelBox part_;
    FrameSide side_;
};

struct Bar {
    int depth = 0;  // lines; 0 for none
    FrameColour colour{};
    int length = 0;  // of the edge, as far as it is looked at
    int ends = 0;    // of it, where the bar ends at once
    double share() const { return length == 0 ? 0 : static_cast<double>(ends) / length; }
};

// Of a few places of the outermost line: whether all of it is like that is looked at then.
FrameColour middle_of(const View& view) {
    constexpr int kPlaces = 15;
    FrameColour colour{};
    for (std::size_t c = 0; c < 3; ++c) {
        std::array<int, kPlaces> levels{};
        for (int i = 0; i < kPlaces; ++i)
            levels[static_cast<std::size_t>(i)] = view.at(0, (2 * i + 1) * view.length() / (2 * kPlaces))[c];
        std::nth_element(levels.begin(), levels.begin() + kPlaces / 2, levels.end());
        colour[c] = levels[kPlaces / 2];
    }
    return colour;
}

bool plain(const View& view, int line, const FrameColour& colour) {
    int stray = static_cast<int>(kStray * view.length());
    std::array<int, 3> off{};
    for (int i = 0; i < view.length(); ++i) {
        const FrameColour here = view.at(line, i);
        if (channels_apart(here, colour) > kAlike && --stray < 0) return false;
        for (std::size_t c = 0; c < 3; ++c) off[c] += here[c] - colour[c];
    }
    return std::all_of(off.begin(), off.end(), [&](int sum) { return std::abs(sum) <= kMean * view.length(); });
}

Bar bar_at(const View& view) {
    Bar bar;
    bar.colour = middle_of(view);
    const int most = static_cast<int>((1 - kLeastLeft) * view.lines());
    while (bar.depth < most && plain(view, bar.depth, bar.colour)) ++bar.depth;
    if (bar.depth == most) bar.depth = 0;  // a plain picture
    return bar;
}

// Where the bar's last line is followed, within the blur of an edge, by something else that goes on.
void measure(Bar& bar, const View& view, int before, int after) {
    const int blur = 2 + std::max(view.lines(), view.length()) / kSoftened, beyond = 3 * blur;
    const int inside = view.length() - before - after, corner = static_cast<int>(std::ceil(kCorners * inside));
    if (bar.depth + beyond >= view.lines()) return;
    for (int i = before + corner; i < view.length() - after - corner; ++i) {
        ++bar.length;
        const bool ends = channels_apart(view.at(bar.depth + blur, i), bar.colour) > kBarStep;
        const bool goes_on = channels_apart(view.at(bar.depth + beyond, i), bar.colour) > kBarStep;
        bar.ends += ends && goes_on ? 1 : 0;
    }
}

PixelBox without_bars(const Image& image, const PixelBox& part) {
    std::array<Bar, 4> bars;
    const auto view = [&](int side) { return View(image, part, static_cast<FrameSide>(side)); };
    for (int side = kLeft; side <= kBottom; ++side) bars[static_cast<std::size_t>(side)] = bar_at(view(side));
    const auto& [left, top, right, bottom] = bars;
    if (left.depth + top.depth + right.depth + bottom.depth == 0) return part;
    for (std::size_t side = 0; side < 4; ++side)
        if (bars[side].depth > 0)
            measure(bars[side], view(static_cast<int>(side)), bars[side % 2 == 0 ? 1 : 0].depth,
                    bars[side % 2 == 0 ? 3 : 2].depth);
    int length = 0, ends = 0;
    for (const Bar& bar : bars) {
        length += bar.length;
        ends += bar.ends;
    }
    const bool together = ends >= kTogether * length;
    std::array<int, 4> depth{};
    for (std::size_t side = 0; side < 4; ++side) {
        const Bar &bar = bars[side], &opposite = bars[(side + 2) % 4];
        const bool backed = together && std::min(bar.share(), opposite.share()) >= kBacked &&
                            channels_apart(bar.colour, opposite.colour) <= kAlike;
        if (bar.share() >= kAlone || backed)
            depth[side] = bar.depth;
        else if (bar.depth > 0)
            return part;  // a plain side that ends in no edge: there is a picture of something on this ground
    }
    const PixelBox inner{part.left + depth[kLeft], part.top + depth[kTop], part.right - depth[kRight],
                         part.bottom - depth[kBottom]};
    return inner.width() >= kLeastLeft * part.width() && inner.height() >= kLeastLeft * part.height() ? inner : part;
}

}  // namespace

PixelBox picture_within(const Image& image) {
    PixelBox part = all_of(image.width, image.height);
    // A passe-partout around a black border, and what a letterbox is shown in.
    for (int layer = 0; layer < 2; ++layer) {
        const PixelBox inner = without_bars(image, part);
        if (inner == part) break;
        part = inner;
    }
    return part;
}

}  // namespace tactics
