// SPDX-License-Identifier: Apache-2.0
// An STL taken apart, and what a slicer asks of a solid. Written without the writer.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <string>
#include <unordered_map>
#include <vector>

namespace tactics::tests {

using Vertex = std::array<float, 3>;

struct StlMesh {
    std::vector<std::array<Vertex, 3>> triangles;
    std::vector<Vertex> normals;

    double volume() const {  // by the divergence theorem: positive if triangles are turned outwards
        double sum = 0;
        for (const auto& [a, b, c] : triangles)
            sum += static_cast<double>(a[0]) * (static_cast<double>(b[1]) * c[2] - static_cast<double>(b[2]) * c[1]) -
                   static_cast<double>(a[1]) * (static_cast<double>(b[0]) * c[2] - static_cast<double>(b[2]) * c[0]) +
                   static_cast<double>(a[2]) * (static_cast<double>(b[0]) * c[1] - static_cast<double>(b[1]) * c[0]);
        return sum / 6;
    }
};

inline StlMesh mesh_of(const std::string& bytes) {
    StlMesh mesh;
    std::uint32_t count = 0;
    if (bytes.size() >= 84) std::memcpy(&count, bytes.data() + 80, 4);
    EXPECT_EQ(bytes.size(), 84 + 50 * static_cast<std::size_t>(count));
    EXPECT_NE(bytes.substr(0, 5), "solid");
    if (bytes.size() != 84 + 50 * static_cast<std::size_t>(count)) return mesh;
    for (std::size_t i = 0; i < count; ++i) {
        std::array<float, 12> numbers{};
        std::memcpy(numbers.data(), bytes.data() + 84 + 50 * i, 48);
        mesh.normals.push_back({numbers[0], numbers[1], numbers[2]});
        mesh.triangles.push_back({Vertex{numbers[3], numbers[4], numbers[5]}, Vertex{numbers[6], numbers[7], numbers[8]},
                                  Vertex{numbers[9], numbers[10], numbers[11]}});
    }
    return mesh;
}

struct MeshFaults {
    std::size_t flat = 0;        ///< triangles without area
    std::size_t open_edges = 0;  ///< not of exactly two triangles that run along it in opposite ways
    std::size_t crossed = 0;     ///< corners where more than one fan of triangles meets
    std::size_t wrong_normals = 0;
    int pieces = 0;
};

inline MeshFaults faults_of(const StlMesh& mesh) {
    MeshFaults faults;
    std::map<Vertex, std::uint32_t> numbers;
    std::vector<std::array<std::uint32_t, 3>> faces;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        std::array<std::uint32_t, 3> face{};
        for (std::size_t k = 0; k < 3; ++k)
            face[k] = numbers.try_emplace(mesh.triangles[t][k], static_cast<std::uint32_t>(numbers.size())).first->second;
        faces.push_back(face);
        const auto& [a, b, c] = mesh.triangles[t];
        std::array<double, 3> u{}, v{};
        for (std::size_t k = 0; k < 3; ++k) {
            u[k] = static_cast<double>(b[k]) - a[k];
            v[k] = static_cast<double>(c[k]) - a[k];
        }
        const std::array<double, 3> n{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
        const double area = std::hypot(n[0], n[1], n[2]);
        if (!(area > 0)) ++faults.flat;
        for (std::size_t k = 0; k < 3; ++k)
            if (std::abs(n[k] / area - mesh.normals[t][k]) > 1e-4) {
                ++faults.wrong_normals;
                break;
            }
    }
    // Each directed edge once, and its opposite once.
    std::unordered_map<std::uint64_t, int> edges;
    const auto key = [](std::uint32_t from, std::uint32_t to) { return std::uint64_t{from} << 32 | to; };
    for (const auto& face : faces)
        for (std::size_t k = 0; k < 3; ++k) ++edges[key(face[k], face[(k + 1) % 3])];
    for (const auto& [edge, times] : edges) {
        const auto back = edges.find(key(static_cast<std::uint32_t>(edge), static_cast<std::uint32_t>(edge >> 32)));
        if (times != 1 || back == edges.end() || back->second != 1) ++faults.open_edges;
    }
    // Around a corner its triangles must be one closed fan: walking from one to the next meets them all.
    std::vector<std::map<std::uint32_t, std::uint32_t>> fans(numbers.size());
    for (const auto& face : faces)
        for (std::size_t k = 0; k < 3; ++k) fans[face[k]][face[(k + 1) % 3]] = face[(k + 2) % 3];
    for (const auto& fan : fans) {
        std::size_t walked = 0;
        auto at = fan.begin();
        do {
            at = fan.find(at->second);
            ++walked;
        } while (at != fan.end() && at != fan.begin() && walked <= fan.size());
        if (walked != fan.size()) ++faults.crossed;
    }
    std::vector<std::uint32_t> group(numbers.size());
    for (std::uint32_t i = 0; i < group.size(); ++i) group[i] = i;
    const auto root = [&](std::uint32_t i) {
        while (group[i] != i) i = group[i] = group[group[i]];
        return i;
    };
    for (const auto& face : faces) {
        group[root(face[1])] = root(face[0]);
        group[root(face[2])] = root(face[0]);
    }
    for (std::uint32_t i = 0; i < group.size(); ++i) faults.pieces += group[i] == i ? 1 : 0;
    return faults;
}

inline void expect_solid(const StlMesh& mesh) {
    const MeshFaults faults = faults_of(mesh);
    EXPECT_EQ(faults.flat, 0u);
    EXPECT_EQ(faults.open_edges, 0u);
    EXPECT_EQ(faults.crossed, 0u);
    EXPECT_EQ(faults.wrong_normals, 0u);
    EXPECT_EQ(faults.pieces, 1);
    EXPECT_GT(mesh.volume(), 0);
}

}  // namespace tactics::tests
