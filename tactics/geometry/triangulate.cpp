// SPDX-License-Identifier: Apache-2.0
#include "tactics/geometry/triangulate.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tactics/error.h"

namespace tactics {

namespace {

using Corners = std::array<std::uint32_t, 3>;

// From an ear to a corner that may lie in it.
constexpr std::size_t kMostLooks = 4'000'000, kMostLooksOfModel = 1'000'000'000;

struct Flat {
    double x = 0, y = 0;
    bool operator==(const Flat&) const = default;
};

// Over 0: c is to the left of the way from a to b.
double side(const Flat& a, const Flat& b, const Flat& c) { return (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y); }

// Seen against its normal (M. Newell's, which every polygon but one without area has), along the axis nearest to that.
std::vector<Flat> flattened(std::span<const Point3> ring) {
    const Point3 normal = doubled_area(ring.size(), [&](std::size_t i) { return ring[i]; });
    const double x = std::abs(normal.x), y = std::abs(normal.y), z = std::abs(normal.z);
    std::vector<Flat> flat;
    flat.reserve(ring.size());
    for (const Point3& at : ring) {
        if (z >= x && z >= y)
            flat.push_back(normal.z < 0 ? Flat{at.y, at.x} : Flat{at.x, at.y});
        else if (x >= y)
            flat.push_back(normal.x < 0 ? Flat{at.z, at.y} : Flat{at.y, at.z});
        else
            flat.push_back(normal.y < 0 ? Flat{at.x, at.z} : Flat{at.z, at.x});
    }
    return flat;
}

class Ears {
public:
    Ears(std::vector<Flat> ring, std::size_t most_looks)
        : at_(std::move(ring)), before_(at_.size()), after_(at_.size()), most_looks_(most_looks) {
        const auto count = static_cast<std::uint32_t>(at_.size());
        for (std::uint32_t i = 0; i < count; ++i) {
            before_[i] = (i + count - 1) % count;
            after_[i] = (i + 1) % count;
        }
        left_ = count;
        for (std::uint32_t i = 0; i < count; ++i)
            if (turn(i) < 0) inward_.push_back(i);
    }

    std::vector<Corners> cut() {
        if (inward_.empty()) {
            fan(0);
            return std::move(triangles_);
        }
        std::uint32_t here = 0, missed = 0;
        // A ring that crosses itself may have no ear: then what is left goes by turns, corners that point outwards first, and
        // last any.
        while (left_ > 3 && looks_ < most_looks_) {
            const bool cuts = turn(here) > 0 ? missed >= left_ || is_ear(here) : missed >= 2 * left_;
            const std::uint32_t next = after_[here];
            if (cuts) cut_off(here);
            missed = cuts ? 0 : missed + 1;
            here = next;
        }
        fan(here);
        return std::move(triangles_);
    }

    std::size_t looks() const { return looks_; }

private:
    double turn(std::uint32_t i) const { return side(at_[before_[i]], at_[i], at_[after_[i]]); }

    bool is_ear(std::uint32_t i) {
        const Flat &a = at_[before_[i]], &b = at_[i], &c = at_[after_[i]];
        looks_ += inward_.size();
        std::erase_if(inward_, [&](std::uint32_t one) { return after_[one] == one || turn(one) >= 0; });
        return std::none_of(inward_.begin(), inward_.end(), [&](std::uint32_t one) {
            const Flat& p = at_[one];
            return !(p == a || p == b || p == c) && side(a, b, p) >= 0 && side(b, c, p) >= 0 && side(c, a, p) >= 0;
        });
    }
    void cut_off(std::uint32_t i) {
        const std::uint32_t from = before_[i], to = after_[i];
        triangles_.push_back({from, i, to});
        after_[from] = to;
        before_[to] = from;
        before_[i] = after_[i] = i;  // gone
        --left_;
    }
    void fan(std::uint32_t first) {
        for (std::uint32_t i = after_[first]; after_[i] != first; i = after_[i]) triangles_.push_back({first, i, after_[i]});
    }

    std::vector<Flat> at_;
    std::vector<std::uint32_t> before_, after_;
    std::vector<std::uint32_t> inward_;  // corners that point inwards: only they can lie in an ear
    std::uint32_t left_ = 0;
    std::size_t looks_ = 0, most_looks_;
    std::vector<Corners> triangles_;
};

std::vector<Corners> cut(std::span<const Point3> ring, std::size_t& looks) {
    if (ring.size() < 3) return {};
    if (ring.size() == 3) return {{0, 1, 2}};
    Ears ears(flattened(ring), std::min(looks, kMostLooks));
    std::vector<Corners> triangles = ears.cut();
    looks -= std::min(looks, ears.looks());
    return triangles;
}

}  // namespace

std::vector<Corners> triangulate(std::span<const Point3> ring) {
    std::size_t looks = kMostLooks;
    return cut(ring, looks);
}

Mesh mesh_of(const Model& model, const std::string& file) {
    std::size_t count = 0;
    for (const ModelFace& face : model.faces) count += face.count - 2;
    if (count > kMostMeshTriangles)
        throw Error(Fault::failed, file,
                    phrase("has over {0} triangles; make it coarser first", std::to_string(kMostMeshTriangles)));
    Mesh mesh;
    mesh.up = model.up;
    mesh.vertices = model.vertices;
    mesh.triangles.reserve(count);
    std::vector<Point3> ring;
    std::size_t looks = kMostLooksOfModel;
    for (const ModelObject& object : model.objects) {
        if (object.count == 0) continue;
        MeshPart part{spoken_name(model, static_cast<std::size_t>(&object - model.objects.data())),
                      static_cast<std::uint32_t>(mesh.triangles.size()), 0};
        for (std::uint32_t i = object.first; i < object.first + object.count; ++i) {
            const ModelFace& face = model.faces[i];
            const std::uint32_t* corners = model.corners.data() + face.first;
            ring.clear();
            for (std::uint32_t k = 0; k < face.count; ++k) ring.push_back(model.vertices[corners[k]]);
            for (const Corners& one : cut(ring, looks))
                mesh.triangles.push_back({corners[one[0]], corners[one[1]], corners[one[2]]});
        }
        part.count = static_cast<std::uint32_t>(mesh.triangles.size()) - part.first;
        mesh.parts.push_back(std::move(part));
    }
    return mesh;
}

Model model_of(Mesh mesh, bool one_sided) {
    Model model;
    model.up = mesh.up;
    model.vertices = std::move(mesh.vertices);
    for (const Corners& triangle : mesh.triangles) {
        model.faces.push_back({static_cast<std::uint32_t>(model.corners.size()), 3});
        model.corners.insert(model.corners.end(), triangle.begin(), triangle.end());
    }
    if (mesh.parts.empty()) mesh.parts.push_back({"", 0, static_cast<std::uint32_t>(mesh.triangles.size())});
    for (MeshPart& part : mesh.parts) {
        ModelObject& object = model.objects.emplace_back();
        object.name = std::move(part.name);
        object.one_sided = one_sided;
        object.first = part.first;
        object.count = part.count;
    }
    return model;
}

double doubled_area(const std::vector<Point>& ring) {
    double sum = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point a = ring[i], b = ring[(i + 1) % ring.size()];
        sum += a.x * b.y - b.x * a.y;
    }
    return sum;
}

}  // namespace tactics
