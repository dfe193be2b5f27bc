// SPDX-License-Identifier: Apache-2.0
#include "filters/dots.h"

#include <algorithm>
#include <utility>

namespace tactics {

Outline take_piece(Skeleton& skeleton, std::uint32_t pixel) {
    InkMap& map = skeleton.map;
    std::vector<std::uint32_t> piece{pixel};
    if (map.bytes[pixel] == 0) return {};
    map.bytes[pixel] = 0;
    int left = map.width, top = map.height, right = 0, bottom = 0;
    for (std::size_t i = 0; i < piece.size(); ++i) {
        const int x = skeleton.x_of(piece[i]), y = skeleton.y_of(piece[i]);
        left = std::min(left, x);
        right = std::max(right, x);
        top = std::min(top, y);
        bottom = std::max(bottom, y);
        for (const PixelStep step : kSteps) {
            const std::uint32_t next = skeleton.pixel_at(x + step.x, y + step.y);
            if (map.bytes[next] == 0) continue;
            map.bytes[next] = 0;
            piece.push_back(next);
        }
    }
    InkMap ink(right - left + 1, bottom - top + 1);
    for (const std::uint32_t at : piece) ink.row(skeleton.y_of(at) - top)[skeleton.x_of(at) - left] = 1;
    Outline outline = std::move(outlines_of(ink).front());
    for (OutlineRing& ring : outline.rings)
        for (Point& p : ring.points) p = {p.x + left, p.y + top};
    return outline;
}

}  // namespace tactics
