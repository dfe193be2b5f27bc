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
    PixelBox box{map.width, map.height, 0, 0};
    for (std::size_t i = 0; i < piece.size(); ++i) {
        const int x = skeleton.x_of(piece[i]), y = skeleton.y_of(piece[i]);
        box = around(box, {x, y, x + 1, y + 1});
        for (const PixelStep step : kSteps) {
            const std::uint32_t next = skeleton.pixel_at(x + step.x, y + step.y);
            if (map.bytes[next] == 0) continue;
            map.bytes[next] = 0;
            piece.push_back(next);
        }
    }
    InkMap ink(box.width(), box.height());
    for (const std::uint32_t at : piece) ink.row(skeleton.y_of(at) - box.top)[skeleton.x_of(at) - box.left] = 1;
    Outline outline = std::move(outlines_of(ink).front());
    for (OutlineRing& ring : outline.rings)
        for (Point& p : ring.points) p = {p.x + box.left, p.y + box.top};
    return outline;
}

}  // namespace tactics
