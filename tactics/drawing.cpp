#include "tactics/drawing.h"

#include <cmath>

namespace tactics {

double length_of(const Stroke& stroke) {
    double length = 0;
    for (std::size_t i = 1; i < stroke.points.size(); ++i)
        length += std::hypot(stroke.points[i].x - stroke.points[i - 1].x, stroke.points[i].y - stroke.points[i - 1].y);
    if (stroke.closed && !stroke.points.empty())
        length += std::hypot(stroke.points.front().x - stroke.points.back().x,
                             stroke.points.front().y - stroke.points.back().y);
    return length;
}

double total_stroke_length(const Drawing& drawing) {
    double length = 0;
    for (const auto& stroke : drawing.strokes) length += length_of(stroke);
    return length;
}

}  // namespace tactics
