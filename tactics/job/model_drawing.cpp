// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/model_drawing.h"

#include <algorithm>
#include <cmath>

#include "tactics/geometry/triangulate.h"
#include "tactics/layout/place.h"
#include "tactics/solid/views.h"
#include "tactics/text/json.h"
#include "tactics/text/number.h"

namespace tactics {

namespace {

constexpr std::size_t kMostNamed = 5;  // in a line of names

std::string_view name_of(FoldedObject::Fate fate) {
    switch (fate) {
        case FoldedObject::Fate::drawn: return "drawn";
        case FoldedObject::Fate::small: return "too small";
        case FoldedObject::Fate::hidden: return "hidden";
    }
    return "";
}

std::string listed(const std::vector<const FoldedObject*>& objects) {
    std::string text;
    for (std::size_t i = 0; i < std::min(objects.size(), kMostNamed); ++i)
        text += (i == 0 ? "" : ", ") + (objects[i]->path.empty() ? "one without a name" : objects[i]->path);
    return objects.size() > kMostNamed ? text + " and " + std::to_string(objects.size() - kMostNamed) + " more" : text;
}

std::vector<const FoldedObject*> with_fate(const FoldOut& made, FoldedObject::Fate fate) {
    std::vector<const FoldedObject*> found;
    for (const FoldedObject& one : made.objects)
        if (one.fate == fate) found.push_back(&one);
    return found;
}

}  // namespace

bool is_terrain(const Model& model) {
    if (model.objects.size() != 1 || !model.objects.front().name.empty() || model.objects.front().primitive != Primitive::none)
        return false;
    // All faces look up, or all down.
    double up = 0, down = 0, level = 0;
    for (const ModelFace& face : model.faces) {
        const Point3 area =
            doubled_area(face.count, [&](std::size_t i) { return model.vertices[model.corners[face.first + i]]; });
        const double size = length_of(area);
        (area.z > 0.01 * size ? up : area.z < -0.01 * size ? down : level) += size;
    }
    return std::min(up, down) + level < 0.01 * (up + down + level);
}

const FoldOut& ModelDrawing::on(const Sheet& sheet) {
    const Rect room = place_on(sheet, 1).live;
    if (medium_ != sheet.medium || width_ != room.width || height_ != room.height) {
        notes_.clear();
        made_ = (wish_.view == ModelView::views ? views_of : fold_out)(*model_, room.width, room.height, *sheet.medium,
                                                                       wish_.fold, notes_);
        medium_ = sheet.medium;
        width_ = room.width;
        height_ = room.height;
    }
    return made_;
}

std::vector<std::string> fold_lines(const FoldOut& made) {
    std::vector<std::string> lines;
    int folded = 0, flattened = 0, wedges = 0, straightened = 0, lying = 0, left_out = 0;
    for (const FoldedObject& one : made.objects) {
        folded += one.folded;
        flattened += one.flattened;
        wedges += one.wedges;
        straightened += one.straightened;
        lying += one.lying;
        left_out += one.fate == FoldedObject::Fate::drawn ? one.left_out : 0;
    }
    std::string what;
    const auto count = [&](int number, const std::string& one, const std::string& many) {
        if (number > 0) what += (what.empty() ? "" : ", ") + std::to_string(number) + " " + (number == 1 ? one : many);
    };
    count(folded, "face folded out", "faces folded out");
    count(flattened, "slender part laid flat", "slender parts laid flat");
    count(straightened, "part turned upright", "parts turned upright");
    count(lying, "upright face laid down", "upright faces laid down");
    count(wedges, "slender part shown by a wedge, thick where it is near",
          "slender parts shown by wedges, thick where they are near");
    count(left_out, "face without room left out", "faces without room left out");
    if (!what.empty()) lines.push_back(std::string(seen(made.plane)) + ": " + what);
    if (made.spread > 1)
        lines.push_back("things are moved apart, " + to_text(made.spread) +
                        " times as far from the middle, so that their faces have room");
    if (const auto small = with_fate(made, FoldedObject::Fate::small); !small.empty())
        lines.push_back("too small to be felt at this size: " + listed(small) + "; draw a part alone to feel them");
    if (const auto hidden = with_fate(made, FoldedObject::Fate::hidden); !hidden.empty())
        lines.push_back("under or behind other things: " + listed(hidden));
    return lines;
}

std::string fold_json(const FoldOut& made) {
    std::string text = "{\"seen_from\":" + json_text(tactics::name_of(made.plane)) + ",\"scale\":" + to_text(made.scale) +
                       ",\"spread\":" + to_text(made.spread) + ",\"rating\":{\"shown\":" + to_text(made.rating.shown) +
                       ",\"asked\":" + to_text(made.rating.asked) + "},\"objects\":[";
    for (std::size_t i = 0; i < made.objects.size(); ++i) {
        const FoldedObject& one = made.objects[i];
        text += std::string(i == 0 ? "" : ",") + "{\"name\":" + json_text(one.name) + ",\"path\":" + json_text(one.path) +
                ",\"form\":" + json_text(tactics::name_of(one.form)) + ",\"fate\":" + json_text(name_of(one.fate)) +
                ",\"size_mm\":" + to_text(one.size) + ",\"kept\":" + std::to_string(one.kept) +
                ",\"folded\":" + std::to_string(one.folded) + ",\"flattened\":" + std::to_string(one.flattened) +
                ",\"straightened\":" + std::to_string(one.straightened) + ",\"lying\":" + std::to_string(one.lying) +
                ",\"wedges\":" + std::to_string(one.wedges) + ",\"doubled\":" + std::to_string(one.doubled) +
                ",\"left_out\":" + std::to_string(one.left_out);
        if (one.fate == FoldedObject::Fate::drawn)
            text += ",\"x_percent\":" + to_text(100 * one.at.x / made.drawing.width) +
                    ",\"y_percent\":" + to_text(100 * one.at.y / made.drawing.height);
        text += "}";
    }
    return text + "]}";
}

}  // namespace tactics
