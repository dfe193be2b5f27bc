// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <numeric>

#include "tactics/geometry/evidence.h"
#include "tactics/repair/means.h"

namespace tactics {

Mends thin_out(Drawing& drawing, const Medium& medium, double times) {
    const auto room_of = [&](const Stroke& stroke) { return length_of(stroke) * (width_of(stroke.line, medium) + medium.gap); };
    double room = 0;
    for (const Stroke& stroke : drawing.strokes) room += room_of(stroke);
    const double most = times * drawing.width * drawing.height;
    Mends changes;
    if (!(room > most)) return changes;
    std::vector<std::size_t> order = by_evidence(drawing.strokes);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return drawing.strokes[a].line > drawing.strokes[b].line; });
    // Without the one that matters most nothing would be left to be told of.
    if (room_of(drawing.strokes[order.front()]) > most) return changes;
    std::vector<bool> goes(drawing.strokes.size());
    for (; room > most && order.size() > 1; order.pop_back()) {
        const Stroke& stroke = drawing.strokes[order.back()];
        room -= room_of(stroke);
        goes[order.back()] = true;
        changes.push_back({Mend::Kind::left_out, stroke.points.empty() ? Point{} : stroke.points[0], length_of(stroke)});
    }
    std::vector<Stroke> left;
    for (std::size_t i = 0; i < goes.size(); ++i)
        if (!goes[i]) left.push_back(std::move(drawing.strokes[i]));
    drawing.strokes = std::move(left);
    return changes;
}

}  // namespace tactics
