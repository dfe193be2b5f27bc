#include "tactics/dashed_line.h"

namespace tactics {

std::size_t last_of_line(const Page& page, std::size_t first) {
    constexpr double kSameLine =
        2;  // a gap longer than so many of its dash is no gap in a line but its end; as rules/dashes has it
    const auto is_dash = [](const PageStroke& stroke) {
        return stroke.role == Role::dash && !stroke.closed && !stroke.points.empty();
    };
    std::size_t last = first;
    while (last + 1 < page.strokes.size() && is_dash(page.strokes[last]) && is_dash(page.strokes[last + 1])) {
        const PageStroke &dash = page.strokes[last], &next = page.strokes[last + 1];
        const double gap = distance(dash.points.back(), next.points.front()) - dash.width;
        if (dash.width != next.width || gap > kSameLine * (length_of(Stroke{dash.points, false}) + dash.width)) break;
        ++last;
    }
    return last;
}

std::vector<Point> whole_line(const Page& page, std::size_t first, std::size_t last) {
    std::vector<Point> points;
    for (std::size_t i = first; i <= last; ++i)
        points.insert(points.end(), page.strokes[i].points.begin(), page.strokes[i].points.end());
    return points;
}

}  // namespace tactics
