// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/model_drawing.h"

#include <algorithm>
#include <cmath>

#include "tactics/geometry/shape.h"
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

Phrase named_objects(const std::vector<const FoldedObject*>& objects) {
    std::vector<Phrase> names;
    for (std::size_t i = 0; i < std::min(objects.size(), kMostNamed); ++i)
        names.push_back(objects[i]->path.empty() ? phrase("one without a name") : Phrase(objects[i]->path));
    if (objects.size() <= kMostNamed) return row_of(names);
    return phrase("{0} and {1} more", row_of(names), std::to_string(objects.size() - kMostNamed));
}

std::vector<const FoldedObject*> with_fate(const FoldOut& made, FoldedObject::Fate fate) {
    std::vector<const FoldedObject*> found;
    for (const FoldedObject& one : made.objects)
        if (one.fate == fate) found.push_back(&one);
    return found;
}

std::vector<const FoldedObject*> moved_ones(const FoldOut& made) {
    std::vector<const FoldedObject*> found = with_fate(made, FoldedObject::Fate::drawn);
    std::erase_if(found, [](const FoldedObject* one) { return !(one->moved > 0); });
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
    const bool turns = sheet.orientation == Orientation::automatic && !sheet.binding;
    if (medium_ != sheet.medium || width_ != room.width || height_ != room.height || turns_ != turns) {
        notes_.clear();
        FoldWish fold = wish_.fold;
        fold.language = sheet.language;
        fold.turns = turns;
        made_ =
            (wish_.view == ModelView::views ? views_of : fold_out)(*model_, room.width, room.height, *sheet.medium, fold, notes_);
        medium_ = sheet.medium;
        width_ = room.width;
        height_ = room.height;
        turns_ = turns;
    }
    return made_;
}

std::vector<Phrase> fold_lines(const FoldOut& made) {
    std::vector<Phrase> lines, what;
    int folded = 0, flattened = 0, wedges = 0, straightened = 0, lying = 0, hanging = 0, left_out = 0;
    for (const FoldedObject& one : made.objects) {
        folded += one.folded;
        flattened += one.flattened;
        wedges += one.wedges;
        straightened += one.straightened;
        lying += one.lying;
        hanging += one.hanging;
        left_out += one.fate == FoldedObject::Fate::drawn ? one.left_out : 0;
    }
    const auto count = [&](int number, auto words) {
        if (number > 0) what.push_back(words(static_cast<std::size_t>(number)));
    };
    count(folded, [](std::size_t n) { return phrases(n, "{0} face folded out", "{0} faces folded out"); });
    count(flattened, [](std::size_t n) { return phrases(n, "{0} slender part laid flat", "{0} slender parts laid flat"); });
    count(straightened, [](std::size_t n) { return phrases(n, "{0} part turned upright", "{0} parts turned upright"); });
    count(lying, [](std::size_t n) { return phrases(n, "{0} upright face laid down", "{0} upright faces laid down"); });
    count(hanging, [](std::size_t n) {
        return phrases(n, "{0} view from a side beside what hides it", "{0} views from a side beside what hides them");
    });
    count(wedges, [](std::size_t n) {
        return phrases(n, "{0} slender part shown by a wedge, thick where it is near",
                       "{0} slender parts shown by wedges, thick where they are near");
    });
    count(left_out,
          [](std::size_t n) { return phrases(n, "{0} face without room left out", "{0} faces without room left out"); });
    if (!what.empty()) lines.push_back(phrase("{0}: {1}", seen(made.plane), row_of(what)));
    if (made.spread > 1)
        lines.push_back(phrase("things are moved apart, {0} times as far from the middle, so that their faces have room",
                               numeral(made.spread)));
    if (const auto moved = moved_ones(made); !moved.empty()) {
        double most = 0;
        for (const FoldedObject* one : moved) most = std::max(most, one->moved);
        lines.push_back(phrase("moved off what was too close, by up to {0} on the page: {1}", spoken_length(most * made.scale),
                               named_objects(moved)));
    }
    if (const auto small = with_fate(made, FoldedObject::Fate::small); !small.empty())
        lines.push_back(phrase("too small to be felt at this size: {0}; draw a part alone to feel them", named_objects(small)));
    if (const auto hidden = with_fate(made, FoldedObject::Fate::hidden); !hidden.empty())
        lines.push_back(phrase("under or behind other things: {0}", named_objects(hidden)));
    return lines;
}

std::string fold_json(const FoldOut& made) {
    std::string text = "{\"seen_from\":" + json_text(tactics::name_of(made.plane)) +
                       ",\"up\":" + json_text(tactics::name_of(made.up)) + ",\"scale\":" + to_text(made.scale) +
                       ",\"spread\":" + to_text(made.spread) + ",\"rating\":{\"shown\":" + to_text(made.rating.shown) +
                       ",\"asked\":" + to_text(made.rating.asked) + "},\"objects\":[";
    for (std::size_t i = 0; i < made.objects.size(); ++i) {
        const FoldedObject& one = made.objects[i];
        text += std::string(i == 0 ? "" : ",") + "{\"name\":" + json_text(one.name) + ",\"path\":" + json_text(one.path) +
                ",\"form\":" + json_text(tactics::name_of(one.form)) + ",\"fate\":" + json_text(name_of(one.fate)) +
                ",\"shape\":" + json_text(one.shape) + ",\"size_mm\":" + to_text(one.size) +
                ",\"moved_mm\":" + to_text(one.moved) + ",\"kept\":" + std::to_string(one.kept) +
                ",\"folded\":" + std::to_string(one.folded) + ",\"flattened\":" + std::to_string(one.flattened) +
                ",\"straightened\":" + std::to_string(one.straightened) + ",\"lying\":" + std::to_string(one.lying) +
                ",\"hanging\":" + std::to_string(one.hanging) + ",\"wedges\":" + std::to_string(one.wedges) +
                ",\"doubled\":" + std::to_string(one.doubled) + ",\"left_out\":" + std::to_string(one.left_out);
        if (one.fate == FoldedObject::Fate::drawn)
            text += ",\"x_percent\":" + to_text(100 * one.at.x / made.drawing.width) +
                    ",\"y_percent\":" + to_text(100 * one.at.y / made.drawing.height);
        text += "}";
    }
    return text + "]}";
}

}  // namespace tactics
