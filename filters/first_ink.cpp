// SPDX-License-Identifier: Apache-2.0
#include "filters/first_ink.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <vector>

namespace tactics {

namespace {

constexpr double kFrameStrip = 0.02;    // of the longer side: nearer to the edge stands no more than a frame. A setting
constexpr int kDrawnInk = 64;           // grey levels from the ground: what is paler is a grid or a shade
constexpr int kPaleFrame = 32;          // frames may be paler
constexpr double kLineAlongSide = 0.8;  // of its length; corners may be round

int ground_below(const Image& grey, int frame) {
    const std::uint8_t* const inside = grey.row(std::min(frame, grey.height / 2));  // the first row that is no frame
    std::vector<std::uint8_t> row(inside, inside + grey.width);
    std::nth_element(row.begin(), row.begin() + grey.width / 2, row.end());
    return row[static_cast<std::size_t>(grey.width / 2)];
}

enum class PictureEdge { top, bottom, left, right };

// Whether a line runs along one edge of the picture, no farther in than a frame.
bool has_line(const Image& grey, int ground, int frame, PictureEdge edge) {
    const bool level = edge == PictureEdge::top || edge == PictureEdge::bottom;
    const int length = level ? grey.width : grey.height, across = level ? grey.height : grey.width;
    for (int in = 0; in < std::min(frame, across); ++in) {
        const int line = edge == PictureEdge::top || edge == PictureEdge::left ? in : across - 1 - in;
        int count = 0;
        for (int at = 0; at < length; ++at)
            count += std::abs((level ? grey.row(line)[at] : grey.row(at)[line]) - ground) > kPaleFrame ? 1 : 0;
        if (count >= kLineAlongSide * length) return true;
    }
    return false;
}

}  // namespace

FirstInk first_ink(const Image& grey) {
    if (grey.width == 0 || grey.height == 0) return {0};
    const int frame = static_cast<int>(kFrameStrip * std::max(grey.width, grey.height));
    const int ground = ground_below(grey, frame);
    const auto line_at = [&](PictureEdge edge) { return has_line(grey, ground, frame, edge); };
    if (line_at(PictureEdge::top) && !(line_at(PictureEdge::bottom) && line_at(PictureEdge::left) && line_at(PictureEdge::right)))
        return {0};
    int top = grey.height, left = grey.width, right = 0, end = grey.height;
    for (int y = std::min(frame, grey.height / 2); y < end; ++y)
        for (int x = std::min(frame, grey.width / 2); x < grey.width - frame; ++x) {
            if (std::abs(grey.row(y)[x] - ground) <= kDrawnInk) continue;
            if (top == grey.height) end = std::min(end, y + 1 + static_cast<int>(kFirstPart / 100 * grey.height));
            top = std::min(top, y);
            left = std::min(left, x);
            right = std::max(right, x + 1);
        }
    if (top == grey.height) return {};
    return {100.0 * top / grey.height, 100.0 * left / grey.width, 100.0 * right / grey.width};
}

}  // namespace tactics
