// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/coarse.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "tactics/error.h"
#include "tactics/geometry/triangulate.h"

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

// Which cell each vertex is in, by the number of the cell; gives how many there are.
std::size_t find_cells(const Model& model, const Frame& frame, int cells, std::vector<std::uint32_t>& into) {
    constexpr std::uint32_t kNone = ~0u;
    const double cell = frame.size > 0 ? frame.size / cells : 1;  // all in one place
    std::unordered_map<std::uint64_t, std::uint32_t> numbers;
    into.assign(model.vertices.size(), kNone);
    each_corner(model, [&](std::uint32_t vertex) {
        if (into[vertex] != kNone) return;
        std::uint64_t key = 0;
        for (double Point3::*axis : {&Point3::x, &Point3::y, &Point3::z}) {
            const double number = std::floor((model.vertices[vertex].*axis - frame.low.*axis) / cell);
            key = key << 20 | static_cast<std::uint64_t>(std::clamp(number, 0.0, cells - 1.0));
        }
        into[vertex] = numbers.emplace(key, static_cast<std::uint32_t>(numbers.size())).first->second;
    });
    return numbers.size();
}

// The place from which the planes of some faces are least far.
class NearestCorners {
public:
    // `at`: from the middle of the vertices, so that large coordinates cost no digits.
    void add_plane(const Point3& normal, const Point3& at, double weight) {
        const double n[] = {normal.x, normal.y, normal.z}, off = dot(normal, at);
        for (std::size_t i = 0, k = 0; i < 3; ++i) {
            for (std::size_t j = i; j < 3; ++j) a_[k++] += weight * n[i] * n[j];
            b_[i] += weight * off * n[i];
        }
    }
    // Along what the planes leave open it stays at the middle.
    Point3 place() const {
        const double hold = 1e-6 * (a_[0] + a_[3] + a_[5]);
        if (!(hold > 0)) return {};
        const Point3 x{a_[0] + hold, a_[1], a_[2]}, y{a_[1], a_[3] + hold, a_[4]}, z{a_[2], a_[4], a_[5] + hold};
        const Point3 b{b_[0], b_[1], b_[2]};
        return (1 / dot(x, cross(y, z))) * Point3{dot(b, cross(y, z)), dot(x, cross(b, z)), dot(x, cross(y, b))};
    }

private:
    double a_[6] = {}, b_[3] = {};  // a_: the upper triangle of a symmetric matrix
};

// One vertex for each cell.
std::vector<Point3> vertices_of(const Model& model, double cell, const std::vector<std::uint32_t>& into, std::size_t count) {
    std::vector<Point3> middles(count);
    std::vector<double> corners(count, 0);
    each_corner(model, [&](std::uint32_t vertex) {
        middles[into[vertex]] = middles[into[vertex]] + model.vertices[vertex];
        ++corners[into[vertex]];
    });
    for (std::size_t i = 0; i < count; ++i) middles[i] = (1 / corners[i]) * middles[i];
    std::vector<NearestCorners> nearest(count);
    for (const ModelObject& object : model.objects)
        for (std::uint32_t f = object.first; f < object.first + object.count; ++f) {
            const auto vertex = [&](std::size_t c) { return model.corners[model.faces[f].first + c]; };
            const Point3 area = doubled_area(model.faces[f].count, [&](std::size_t c) { return model.vertices[vertex(c)]; });
            const double size = length_of(area);
            if (!(size > 0)) continue;
            for (std::uint32_t c = 0; c < model.faces[f].count; ++c) {
                const std::uint32_t number = into[vertex(c)];
                nearest[number].add_plane((1 / size) * area, model.vertices[vertex(c)] - middles[number], size);
            }
        }
    for (std::size_t i = 0; i < count; ++i)
        if (const Point3 to = nearest[i].place(); length_of(to) <= cell) middles[i] = middles[i] + to;
    return middles;
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

// Objects that had faces and have none: they are named, for nothing else on the page tells of them.
void tell_vanished(const Model& model, const Model& made, std::vector<Phrase>& notes) {
    constexpr std::size_t kMostNamed = 12;
    std::size_t count = 0;
    std::vector<Phrase> names;
    for (std::size_t i = 0; i < model.objects.size(); ++i) {
        if (model.objects[i].count == 0 || made.objects[i].count != 0) continue;
        ++count;
        const std::string name = spoken_name(model, static_cast<std::uint32_t>(i));
        if (names.size() < kMostNamed && !name.empty()) names.emplace_back(name);
    }
    if (count == 0) return;
    const auto vanished = [](std::size_t n) {
        return phrases(n, "{0} object is so small that none of its faces is left",
                       "{0} objects are so small that none of their faces is left");
    };
    notes.push_back(names.empty() ? vanished(count) : phrase("{0}: {1}", vanished(count), row_of(names)));
}

}  // namespace

std::size_t corners_of(const Model& model) {
    std::size_t corners = 0;
    for (const ModelObject& object : model.objects)
        for (std::uint32_t f = object.first; f < object.first + object.count; ++f) corners += model.faces[f].count;
    return corners;
}

Model coarse(const Model& model, std::vector<Phrase>& notes) {
    const Frame frame = frame_of(model);
    Model made;
    made.title = model.title;
    made.viewed_from = model.viewed_from;
    made.objects = model.objects;
    std::vector<std::uint32_t> into;
    for (int cells = kFinest; cells >= kCoarsest; cells /= 2) {
        const std::size_t count = find_cells(model, frame, cells, into);
        take_faces(made, model, into);
        if (made.corners.size() > kMostWorkedCorners) continue;
        made.vertices = vertices_of(model, frame.size / cells, into, count);
        notes.push_back(
            phrase("of {0} faces {1} are left, as corners nearer to each other than about 1/{2} of the model were put together; "
                   "draw a part alone for more of it",
                   std::to_string(model.faces.size()), std::to_string(made.faces.size()), std::to_string(cells)));
        tell_vanished(model, made, notes);
        return made;
    }
    throw Error(Fault::failed, "the model",
                phrase("its {0} faces are too many to be folded out; simplify it in a program for models, or draw a part of it",
                       std::to_string(model.faces.size())));
}

}  // namespace tactics
