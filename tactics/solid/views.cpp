// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/views.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace tactics {

namespace {

constexpr double kBetween = 12;  // mm between two views, so that a finger does not take them for one thing

void add(Drawing& whole, const Drawing& view, double left, double top, std::set<std::string>& named) {
    const auto move = [&](Point at) { return Point{at.x + left, at.y + top}; };
    for (Stroke stroke : view.strokes) {
        for (Point& at : stroke.points) at = move(at);
        whole.strokes.push_back(std::move(stroke));
    }
    for (Area area : view.areas) {
        for (auto& ring : area.rings)
            for (Point& at : ring) at = move(at);
        whole.areas.push_back(std::move(area));
    }
    for (Name name : view.names) {
        if (!named.insert(name.text).second) continue;
        name.at = move(name.at);
        whole.names.push_back(std::move(name));
    }
}

}  // namespace

FoldOut views_of(const Model& model, double width, double height, const Medium& medium, const FoldWish& wish,
                 std::vector<std::string>& notes) {
    std::array<FoldOut, 3> views;
    const std::array<FoldPlane, 3> planes = {FoldPlane::above, FoldPlane::front, FoldPlane::side};
    double scale = INFINITY;
    for (std::size_t i = 0; i < views.size(); ++i) {
        FoldWish flat = wish;
        flat.plane = planes[i];
        flat.parts.fold = flat.move = false;
        flat.effort = 0;
        for (ObjectWish& one : flat.objects) one.parts.fold = false;
        std::vector<std::string> same;
        views[i] = fold_out(model, (width - kBetween) / 2, (height - kBetween) / 2, medium, flat, i == 0 ? notes : same);
        scale = std::min(scale, views[i].scale);
    }
    for (FoldOut& view : views) view.drawing = scaled_to(std::move(view.drawing), view.drawing.width * scale / view.scale);
    FoldOut made = views[0];
    const Drawing &top = views[0].drawing, &front = views[1].drawing, &side = views[2].drawing;
    Drawing whole;
    const double column = std::max(top.width, front.width), row = std::max(front.height, side.height);
    whole.width = column + kBetween + side.width;
    whole.height = top.height + kBetween + row;
    std::set<std::string> named;
    add(whole, top, 0, 0, named);
    add(whole, front, 0, top.height + kBetween + row - front.height, named);
    add(whole, side, column + kBetween, top.height + kBetween + row - side.height, named);
    made.drawing = std::move(whole);
    made.scale = scale;
    return made;
}

}  // namespace tactics
