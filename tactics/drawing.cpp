#include "tactics/drawing.h"

namespace tactics {

double length_of(const Stroke& stroke) {
    double length = 0;
    for (std::size_t i = 1; i < stroke.points.size(); ++i)
        length += distance(stroke.points[i - 1], stroke.points[i]);
    if (stroke.closed && !stroke.points.empty()) length += distance(stroke.points.back(), stroke.points.front());
    return length;
}

double total_stroke_length(const Drawing& drawing) {
    double length = 0;
    for (const auto& stroke : drawing.strokes) length += length_of(stroke);
    return length;
}

}  // namespace tactics
