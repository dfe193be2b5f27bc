// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/svg/svg_shapes.h"

#include <algorithm>
#include <cmath>

#include "tactics/error.h"
#include "tactics/readers/svg/svg_numbers.h"

namespace tactics {

namespace {

[[noreturn]] void refuse(const Element& element, const std::string& file, const Phrase& why) {
    throw Error(Fault::failed, file + ":" + std::to_string(element.line), why);
}

double length(const Element& element, std::string_view name, double whole, double fallback, const std::string& file) {
    const auto text = element.attribute(name);
    if (text.empty() || text == "auto") return fallback;
    const auto value = parse_svg_length(text, whole);
    if (!value) refuse(element, file, phrase("\"{0}\" is no length; mend the attribute {1}", text.substr(0, 40), name));
    return *value;
}

}  // namespace

double SvgLengths::across(const Element& element, std::string_view name, double fallback) const {
    return length(element, name, width, fallback, file);
}

double SvgLengths::down(const Element& element, std::string_view name, double fallback) const {
    return length(element, name, height, fallback, file);
}

double SvgLengths::whole() const { return std::sqrt((width * width + height * height) / 2); }

bool draw_outline(const Element& element, const SvgLengths& lengths, Pen& pen, std::size_t* broken) {
    const auto across = [&](std::string_view name, double fallback = 0) { return lengths.across(element, name, fallback); };
    const auto down = [&](std::string_view name, double fallback = 0) { return lengths.down(element, name, fallback); };
    if (element.name == "path") {
        const auto data = element.attribute("d");
        const auto fault = draw_path(data, pen);
        if (fault && data != "none" && broken != nullptr)
            ++*broken;
        else if (fault && data != "none")
            refuse(element, lengths.file,
                   phrase("this path cannot be read at \"{0}\"; mend it or save the drawing again", data.substr(*fault, 20)));
    } else if (element.name == "line") {
        pen.move({across("x1"), down("y1")});
        pen.line({across("x2"), down("y2")});
    } else if (element.name == "polyline" || element.name == "polygon") {
        if (!draw_points(element.attribute("points"), element.name == "polygon", pen))
            refuse(element, lengths.file, phrase("these points are not pairs of numbers; mend them or save the drawing again"));
    } else if (element.name == "rect") {
        const double width = across("width"), height = down("height");
        if (!(width > 0) || !(height > 0)) return false;
        const double rx = across("rx", -1), ry = down("ry", -1);
        draw_rectangle(across("x"), down("y"), width, height, rx < 0 ? std::max(ry, 0.0) : rx, ry < 0 ? std::max(rx, 0.0) : ry,
                       pen);
    } else if (element.name == "circle" || element.name == "ellipse") {
        const double r = across("r"), rx = across("rx", r), ry = down("ry", r);
        if (!(rx > 0) || !(ry > 0)) return false;
        draw_ellipse({across("cx"), down("cy")}, rx, ry, pen);
    } else {
        return false;
    }
    return true;
}

std::optional<Rect> upright_box(const Element& element, const SvgLengths& lengths, const Transform& transform) {
    if (transform.turns_or_skews()) return std::nullopt;
    const double x = lengths.across(element, "x"), y = lengths.down(element, "y");
    const Point from = transform({x, y}),
                to = transform({x + lengths.across(element, "width"), y + lengths.down(element, "height")});
    return Rect{from.x, from.y, to.x - from.x, to.y - from.y};
}

std::optional<Rect> clip_rectangle(const Element& clip, const SvgLengths& lengths, const Transform& transform) {
    if (clip.children.size() != 1) return std::nullopt;
    const Element& shape = clip.children.front();
    if (shape.name != "rect" || !shape.attribute("transform").empty()) return std::nullopt;
    return upright_box(shape, lengths, transform);
}

}  // namespace tactics
