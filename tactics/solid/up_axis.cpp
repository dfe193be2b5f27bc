// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/up_axis.h"

namespace tactics {

namespace {

// In the axes of the file; one with y upwards was turned when it was read.
Point3 as_in_file(const Model& model, const Point3& at) { return model.had_y_up ? Point3{at.x, at.z, -at.y} : at; }

Point3 upwards(const Point3& at, UpAxis up) {
    switch (up) {
        case UpAxis::x: return {at.y, at.z, at.x};
        case UpAxis::y: return {at.x, -at.z, at.y};
        default: return at;
    }
}

}  // namespace

Model turned_up(Model model, UpAxis up) {
    if (up == UpAxis::of_file) return model;
    const auto turn = [&](Point3& at) { at = upwards(as_in_file(model, at), up); };
    for (Point3& at : model.vertices) turn(at);
    for (ModelObject& object : model.objects)
        for (Point3* at : {&object.frame.middle, &object.frame.a, &object.frame.b, &object.frame.c}) turn(*at);
    turn(model.viewed_from);
    return model;
}

}  // namespace tactics
