// SPDX-License-Identifier: Apache-2.0
// Models of boxes and the like, mm, z upwards.
#pragma once

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "tactics/drawing.h"
#include "tactics/model.h"

namespace tactics::tests {

inline int add_group(Model& model, const std::string& name, int parent = -1) {
    ModelObject object;
    object.name = name;
    object.parent = parent;
    model.objects.push_back(object);
    return static_cast<int>(model.objects.size()) - 1;
}

inline void add_face(Model& model, const std::vector<Point3>& corners) {
    const auto first = static_cast<std::uint32_t>(model.corners.size());
    for (const Point3& corner : corners) {
        model.corners.push_back(static_cast<std::uint32_t>(model.vertices.size()));
        model.vertices.push_back(corner);
    }
    model.faces.push_back({first, static_cast<std::uint32_t>(corners.size())});
    ++model.objects.back().count;
}

inline int add_object(Model& model, const std::string& name, int parent = -1) {
    const int place = add_group(model, name, parent);
    model.objects.back().first = static_cast<std::uint32_t>(model.faces.size());
    return place;
}

inline int add_box(Model& model, const std::string& name, int parent, const Point3& middle, const Point3& size) {
    const int place = add_object(model, name, parent);
    const auto at = [&](double x, double y, double z) {
        return Point3{middle.x + x * size.x / 2, middle.y + y * size.y / 2, middle.z + z * size.z / 2};
    };
    add_face(model, {at(-1, -1, -1), at(-1, 1, -1), at(1, 1, -1), at(1, -1, -1)});
    add_face(model, {at(-1, -1, 1), at(1, -1, 1), at(1, 1, 1), at(-1, 1, 1)});
    add_face(model, {at(-1, -1, -1), at(1, -1, -1), at(1, -1, 1), at(-1, -1, 1)});
    add_face(model, {at(-1, 1, -1), at(-1, 1, 1), at(1, 1, 1), at(1, 1, -1)});
    add_face(model, {at(-1, -1, -1), at(-1, -1, 1), at(-1, 1, 1), at(-1, 1, -1)});
    add_face(model, {at(1, -1, -1), at(1, 1, -1), at(1, 1, 1), at(1, -1, 1)});
    return place;
}

inline int add_cylinder(Model& model, const std::string& name, int parent, const Point3& middle, double radius, double height,
                        bool open = false) {
    const int place = add_object(model, name, parent);
    constexpr int kSides = 24;
    std::vector<Point3> low, high;
    for (int i = 0; i < kSides; ++i) {
        const double angle = 2 * std::numbers::pi * i / kSides;
        low.push_back({middle.x + radius * std::cos(angle), middle.y + radius * std::sin(angle), middle.z - height / 2});
        high.push_back({low.back().x, low.back().y, middle.z + height / 2});
    }
    for (std::size_t i = 0; i < kSides; ++i) {
        const std::size_t next = (i + 1) % kSides;
        add_face(model, {low[i], low[next], high[next], high[i]});
    }
    if (!open) add_face(model, high);
    add_face(model, {low.rbegin(), low.rend()});
    model.objects.back().primitive = Primitive::cylinder;
    model.objects.back().frame = {middle, {radius, 0, 0}, {0, radius, 0}, {0, 0, height / 2}};
    return place;
}

/// A profile turned about the upright line through `at`: corners by their distance from it and their height; `tri` cuts its
/// squares into triangles, one way and the other.
inline int add_turned(Model& model, const std::string& name, const Point3& at, const std::vector<Point>& profile, int sides,
                      bool tri = false) {
    const int place = add_object(model, name);
    const auto corner = [&](int i, std::size_t j) {
        const double angle = 2 * std::numbers::pi * (i % sides) / sides;
        return at + Point3{profile[j].x * std::cos(angle), profile[j].x * std::sin(angle), profile[j].y};
    };
    for (std::size_t j = 0; j + 1 < profile.size(); ++j)
        for (int i = 0; i < sides; ++i) {
            const Point3 a = corner(i, j), b = corner(i + 1, j), c = corner(i + 1, j + 1), d = corner(i, j + 1);
            if (profile[j].x == 0)
                add_face(model, {a, c, d});
            else if (profile[j + 1].x == 0)
                add_face(model, {a, b, c});
            else if (!tri)
                add_face(model, {a, b, c, d});
            else if ((static_cast<std::size_t>(i) + j) % 2 == 0) {
                add_face(model, {a, b, c});
                add_face(model, {a, c, d});
            } else {
                add_face(model, {a, b, d});
                add_face(model, {b, c, d});
            }
        }
    return place;
}

/// 90 high, with walls of 4; its opening has a radius of 36, its bottom one of 30.
inline std::vector<Point> cup_profile() { return {{0, 0}, {30, 0}, {40, 90}, {36, 90}, {27, 5}, {0, 5}}; }

/// To the last object: a bow of that reach to the right, from 20 to 70 above `at`, 8 broad.
inline void add_handle(Model& model, const Point3& at, double from, double reach) {
    constexpr int kSteps = 12;
    const auto middle = [&](int i) {
        const double turn = std::numbers::pi * i / kSteps;
        return at + Point3{from + reach * std::sin(turn), 0, 20 + 50.0 * i / kSteps};
    };
    for (int i = 0; i < kSteps; ++i)
        for (const double side : {-4.0, 4.0}) {
            const Point3 a = middle(i), b = middle(i + 1), out{4, 0, 0}, aside{0, side, 0};
            add_face(model, {a - out + aside, b - out + aside, b + out + aside, a + out + aside});
            add_face(model, {a + (side / 4) * out - aside, a + (side / 4) * out + aside, b + (side / 4) * out + aside,
                             b + (side / 4) * out - aside});
        }
}

/// A table of that length, 800 deep and 740 high, with four legs.
inline Model table(double length) {
    Model model;
    const int all = add_group(model, "Table");
    add_box(model, "Top", all, {0, 0, 720}, {length, 800, 40});
    for (const int x : {-1, 1})
        for (const int y : {-1, 1}) add_box(model, "Leg", all, {x * (length / 2 - 50), y * 350.0, 350}, {50, 50, 700});
    return model;
}

}  // namespace tactics::tests
