// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/left_print.h"

#include <algorithm>
#include <cstddef>

#include "tactics/geometry/course.h"

namespace tactics {

namespace {

// Something of the drawing is there or right beside it.
bool is_drawn_at(const Box& box, const Drawing& drawing) {
    const double reach = std::max(box.width(), box.height()) / 2;
    const auto passes = [&](const std::vector<Point>& points, bool closed) {
        for (std::size_t i = 0; i < points.size(); ++i)
            if ((i + 1 < points.size() || closed) &&
                distance_to_segment(box.middle(), points[i], points[(i + 1) % points.size()]) <= reach)
                return true;
        return false;
    };
    return std::any_of(drawing.strokes.begin(), drawing.strokes.end(),
                       [&](const Stroke& stroke) { return passes(stroke.points, stroke.closed); }) ||
           std::any_of(drawing.areas.begin(), drawing.areas.end(), [&](const Area& area) {
               return std::any_of(area.rings.begin(), area.rings.end(),
                                  [&](const std::vector<Point>& ring) { return passes(ring, true); });
           });
}

}  // namespace

std::vector<Box> left_print_in(const PrintWords& words, const Image& picture, const Rect& part) {
    std::vector<Box> left;
    if (words.remove_all) return left;
    const double across = static_cast<double>(picture.width) / words.lettering.width, x = part.left * picture.width,
                 down = static_cast<double>(picture.height) / words.lettering.height, y = part.top * picture.height;
    for (const PrintedWords& one : words.lettering.words)
        if (!one.sure && !one.out)
            left.push_back(
                {one.box.left * across - x, one.box.top * down - y, one.box.right * across - x, one.box.bottom * down - y});
    return left;
}

void tell_lost_print(const std::vector<Box>& print, double mm, const Drawing& drawing, std::vector<Phrase>& told) {
    const auto lost = std::count_if(print.begin(), print.end(), [&](const Box& box) {
        return !is_drawn_at({box.left * mm, box.top * mm, box.right * mm, box.bottom * mm}, drawing);
    });
    if (lost > 0)
        told.push_back(phrases(static_cast<std::size_t>(lost),
                               "{0} place with print that was not read is too small to be drawn and is not on the page.",
                               "{0} places with print that was not read are too small to be drawn and are not on the page."));
}

}  // namespace tactics
