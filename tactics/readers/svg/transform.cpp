// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/svg/transform.h"

#include <algorithm>
#include <numbers>
#include <vector>

#include "tactics/readers/svg/svg_numbers.h"

namespace tactics {

bool Transform::stretches() const {
    // Columns of one length that stand square on each other turn circles into circles.
    const double one = a * a + b * b, other = c * c + d * d, dot = a * c + b * d, most = std::max(one, other);
    return std::abs(one - other) > 0.02 * most || std::abs(dot) > 0.02 * most;
}

Transform operator*(const Transform& o, const Transform& i) {
    return {o.a * i.a + o.c * i.b, o.b * i.a + o.d * i.b,       o.a * i.c + o.c * i.d,
            o.b * i.c + o.d * i.d, o.a * i.e + o.c * i.f + o.e, o.b * i.e + o.d * i.f + o.f};
}

namespace {

Transform turned(double degrees) {
    const double angle = degrees * std::numbers::pi / 180, cosine = std::cos(angle), sine = std::sin(angle);
    return {cosine, sine, -sine, cosine, 0, 0};
}

bool one_transform(std::string_view name, const std::vector<double>& n, Transform& step) {
    const auto given = [&](std::size_t least, std::size_t most) { return n.size() >= least && n.size() <= most; };
    if (name == "matrix" && given(6, 6)) {
        step = {n[0], n[1], n[2], n[3], n[4], n[5]};
    } else if (name == "translate" && given(1, 2)) {
        step = {1, 0, 0, 1, n[0], n.size() > 1 ? n[1] : 0};
    } else if (name == "scale" && given(1, 2)) {
        step = {n[0], 0, 0, n.size() > 1 ? n[1] : n[0], 0, 0};
    } else if (name == "rotate" && (given(1, 1) || given(3, 3))) {
        step = turned(n[0]);
        if (n.size() == 3) step = Transform{1, 0, 0, 1, n[1], n[2]} * step * Transform{1, 0, 0, 1, -n[1], -n[2]};
    } else if (name == "skewX" && given(1, 1)) {
        step = {1, 0, std::tan(n[0] * std::numbers::pi / 180), 1, 0, 0};
    } else if (name == "skewY" && given(1, 1)) {
        step = {1, std::tan(n[0] * std::numbers::pi / 180), 0, 1, 0, 0};
    } else {
        return false;
    }
    return true;
}

}  // namespace

bool parse_transform(std::string_view text, Transform& transform) {
    transform = {};
    for (;;) {
        while (!text.empty() && (is_svg_blank(text[0]) || text[0] == ',')) text.remove_prefix(1);
        if (text.empty() || text == "none") return true;
        const auto open = text.find('('), close = text.find(')');
        if (open == std::string_view::npos || close == std::string_view::npos || close < open) return false;
        std::string_view name = text.substr(0, open), rest = text.substr(open + 1, close - open - 1);
        while (!name.empty() && is_svg_blank(name.back())) name.remove_suffix(1);
        std::vector<double> numbers;
        while (numbers.size() < 7)
            if (const auto number = take_svg_number(rest))
                numbers.push_back(*number);
            else
                break;
        Transform step;
        if (!rest.empty() || !one_transform(name, numbers, step)) return false;
        transform = transform * step;
        text.remove_prefix(close + 1);
    }
}

Transform fit_view(const double view[4], double width, double height, std::string_view preserve) {
    double across = width / view[2], down = height / view[3];
    double left = 0.5, top = 0.5;
    if (preserve.find("none") == std::string_view::npos) {
        const bool slice = preserve.find("slice") != std::string_view::npos;
        across = down = slice ? std::max(across, down) : std::min(across, down);
        if (preserve.find("xMin") != std::string_view::npos) left = 0;
        if (preserve.find("xMax") != std::string_view::npos) left = 1;
        if (preserve.find("YMin") != std::string_view::npos) top = 0;
        if (preserve.find("YMax") != std::string_view::npos) top = 1;
    }
    return Transform{across, 0, 0, down, left * (width - view[2] * across), top * (height - view[3] * down)} *
           Transform{1, 0, 0, 1, -view[0], -view[1]};
}

}  // namespace tactics
