// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/coarse.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "tactics/error.h"

namespace tactics {

namespace {

constexpr int kFinest = 512, kCoarsest = 32;  // cells along the longest side

struct Frame {
    Point3 low;
    double size = 0;  // the longest side
};

template <typename Take>  // the place of a vertex, once for each corner
void each_corner(const Model& model, Take take) {
    for (const ModelObject& object : model.objects)
        for (std::uint32_t f = object.first; f < object.first + object.count; ++f)
            for (std::uint32_t c = 0; c < model.faces[f].count; ++c) take(model.corners[model.faces[f].first + c]);
}

Frame frame_of(const Model& model) {
    constexpr double kNone = std::numeric_limits<double>::infinity();
    Point3 low{kNone, kNone, kNone}, high{-kNone, -kNone, -kNone};
    each_corner(model, [&](std::uint32_t vertex) {
        const Point3& at = model.vertices[vertex];
        low = {std::min(low.x, at.x), std::min(low.y, at.y), std::min(low.z, at.z)};
        high = {std::max(high.x, at.x), std::max(high.y, at.y), std::max(high.z, at.z)};
    });
    return {low, std::max({high.x - low.x, high.y - low.y, high.z - low.z})};
}

bool before(const Point3& a, const Point3& b) { return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z; }

// The vertices that stay, and for each vertex which of them it becomes.
std::vector<Point3> kept_vertices(const Model& model, const Frame& frame, int cells, std::vector<std::uint32_t>& into) {
    const double cell = frame.size / cells;
    std::vector<Point3> kept;
    std::vector<double> off;  // of each from the middle of its cell
    std::unordered_map<std::uint64_t, std::uint32_t> numbers;
    constexpr std::uint32_t kNone = ~0u;
    into.assign(model.vertices.size(), kNone);
    each_corner(model, [&](std::uint32_t vertex) {
        if (into[vertex] != kNone) return;
        const Point3& at = model.vertices[vertex];
        std::uint64_t key = 0;
        Point3 middle = frame.low;
        for (double Point3::*axis : {&Point3::x, &Point3::y, &Point3::z}) {
            const double number = std::clamp(std::floor((at.*axis - frame.low.*axis) / cell), 0.0, cells - 1.0);
            key = key << 20 | static_cast<std::uint64_t>(number);
            middle.*axis += (number + 0.5) * cell;
        }
        const auto [place, fresh] = numbers.emplace(key, static_cast<std::uint32_t>(kept.size()));
        const std::uint32_t number = place->second;
        const double away = length_of(at - middle);
        if (fresh) {
            kept.push_back(at);
            off.push_back(away);
        } else if (away < off[number] || (away == off[number] && before(at, kept[number]))) {
            kept[number] = at;
            off[number] = away;
        }
        into[vertex] = number;
    });
    return kept;
}

// The faces that still have three corners or more.
void take_faces(Model& made, const Model& model, const std::vector<std::uint32_t>& into) {
    made.corners.clear();
    made.faces.clear();
    for (std::size_t i = 0; i < model.objects.size(); ++i) {
        const ModelObject& object = model.objects[i];
        made.objects[i].first = static_cast<std::uint32_t>(made.faces.size());
        for (std::uint32_t f = object.first; f < object.first + object.count; ++f) {
            const auto first = static_cast<std::uint32_t>(made.corners.size());
            for (std::uint32_t c = 0; c < model.faces[f].count; ++c) {
                const std::uint32_t corner = into[model.corners[model.faces[f].first + c]];
                if (made.corners.size() == first || made.corners.back() != corner) made.corners.push_back(corner);
            }
            while (made.corners.size() > first + 1 && made.corners.back() == made.corners[first]) made.corners.pop_back();
            const auto count = static_cast<std::uint32_t>(made.corners.size()) - first;
            if (count < 3)
                made.corners.resize(first);
            else
                made.faces.push_back({first, count});
        }
        made.objects[i].count = static_cast<std::uint32_t>(made.faces.size()) - made.objects[i].first;
    }
}

}  // namespace

std::size_t corners_of(const Model& model) {
    std::size_t corners = 0;
    for (const ModelObject& object : model.objects)
        for (std::uint32_t f = object.first; f < object.first + object.count; ++f) corners += model.faces[f].count;
    return corners;
}

Model coarse(const Model& model, std::vector<std::string>& notes) {
    const Frame frame = frame_of(model);
    Model made;
    made.title = model.title;
    made.objects = model.objects;
    std::vector<std::uint32_t> into;
    for (int cells = kFinest; cells >= kCoarsest; cells /= 2) {
        made.vertices = kept_vertices(model, frame, cells, into);
        take_faces(made, model, into);
        if (made.corners.size() > kMostWorkedCorners) continue;
        notes.push_back("of " + std::to_string(model.faces.size()) + " faces " + std::to_string(made.faces.size()) +
                        " are left, as corners nearer to each other than about 1/" + std::to_string(cells) +
                        " of the model were put together; draw a part alone for more of it");
        return made;
    }
    throw Error(Fault::failed, "the model",
                "its " + std::to_string(model.faces.size()) +
                    " faces are too many to be folded out; simplify it in a program for models, or draw a part of it");
}

}  // namespace tactics
