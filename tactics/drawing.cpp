#include "tactics/drawing.h"

#include <array>

namespace tactics {

namespace {

constexpr std::array<std::string_view, 3> kRoles{"line", "lead", "pattern"};

}  // namespace

std::string_view name_of(Role role) { return kRoles[static_cast<std::size_t>(role)]; }

Role role_named(std::string_view name) {
    for (std::size_t i = 0; i < kRoles.size(); ++i)
        if (kRoles[i] == name) return static_cast<Role>(i);
    return Role::line;
}

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
