// SPDX-License-Identifier: Apache-2.0
// The last digits of a file make no difference, and nothing else changes.
#include "tactics/solid/settled.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tactics/solid/fold_out.h"
#include "tests/solid/models.h"

namespace tactics::settled_test {
namespace {

using tests::add_box;
using tests::add_object;

// A corner of a room with furniture; in mm, as files in m, cm and mm are read.
Model furnished() {
    Model model;
    add_box(model, "Floor", -1, {0, 0, -10}, {4000, 3000, 20});
    add_box(model, "Wall", -1, {0, 1475, 1250}, {4000, 50, 2500});
    add_box(model, "Cupboard", -1, {-1200, 1150, 900}, {835, 600, 1800});
    add_box(model, "Table", -1, {600, -300, 720}, {1400, 700, 30});
    for (const double x : {-650.0, 650.0})
        for (const double y : {-310.0, 310.0}) add_box(model, "Leg", -1, {600 + x, -300 + y, 352.5}, {50, 50, 705});
    add_box(model, "Tray", -1, {650, -250, 742.5}, {300, 200, 15});
    return model;
}

double extent(const Model& model) {
    double longest = 0;
    for (const Point3& a : model.vertices)
        for (const Point3& b : model.vertices) longest = std::max(longest, length_of(a - b));
    return longest;
}

Model trembling(Model model, double by, unsigned seed) {
    std::mt19937 engine(seed);
    const auto next = [&] { return by * (static_cast<double>(engine()) / 2147483647.5 - 1); };
    for (Point3& at : model.vertices) at = at + Point3{next(), next(), next()};
    return model;
}

double farthest_moved(const Model& one, const Model& other) {
    double farthest = 0;
    for (std::size_t i = 0; i < one.vertices.size(); ++i) {
        const Point3 by = one.vertices[i] - other.vertices[i];
        farthest = std::max({farthest, std::abs(by.x), std::abs(by.y), std::abs(by.z)});
    }
    return farthest;
}

TEST(Settled, NumbersOfFewDecimalsStayToTheLastBit) {
    const Model model = furnished();
    EXPECT_EQ(farthest_moved(settled(model), model), 0);
    EXPECT_EQ(farthest_moved(settled(Model{}), Model{}), 0);
}

TEST(Settled, WhatTrembledIsAsItWas) {
    const Model model = furnished();
    const double by = 1e-6 * extent(model);
    for (unsigned seed = 0; seed < 20; ++seed) EXPECT_EQ(farthest_moved(settled(trembling(model, by, seed)), model), 0) << seed;
}

TEST(Settled, NothingMovesByMoreThanTheLastDigits) {
    std::mt19937 engine(3);
    const auto next = [&] { return static_cast<double>(engine()) * 1e-7; };
    for (const std::size_t count : {10u, 300u, 20000u}) {
        Model model;
        add_object(model, "cloud");
        std::vector<Point3> places;
        for (std::size_t i = 0; i < count; ++i) places.push_back({next(), next(), i % 7 == 0 ? 1.0 : next()});
        tests::add_face(model, places);
        const double least = 2.2e-6 * 430 * std::sqrt(3.0);
        EXPECT_LE(farthest_moved(settled(model), model), least) << count;
    }
}

TEST(Settled, TurnedThingsKeepTheirShape) {
    Model model;
    add_box(model, "Crate", -1, {0, 0, 0}, {400, 300, 200});
    const double c = std::cos(0.4321), s = std::sin(0.4321);
    for (Point3& at : model.vertices) at = {c * at.x - s * at.y, s * at.x + c * at.y, at.z};
    EXPECT_LT(farthest_moved(settled(model), model), 1e-9 * 540);
}

TEST(Settled, DrawingsOfATremblingModelAreTheSame) {
    const auto drawn = [](const Model& model) {
        std::vector<Phrase> notes;
        return fold_out(model, 180, 267, find_medium("swell", ""), {}, notes);
    };
    const Model model = furnished();
    const FoldOut first = drawn(model);
    for (unsigned seed = 0; seed < 4; ++seed) {
        const FoldOut other = drawn(trembling(model, 1e-6 * extent(model), seed));
        ASSERT_EQ(other.drawing.strokes.size(), first.drawing.strokes.size());
        for (std::size_t i = 0; i < first.drawing.strokes.size(); ++i) {
            const auto &one = first.drawing.strokes[i].points, &its = other.drawing.strokes[i].points;
            ASSERT_EQ(one.size(), its.size());
            for (std::size_t k = 0; k < one.size(); ++k) EXPECT_EQ(distance(one[k], its[k]), 0);
        }
    }
}

}  // namespace
}  // namespace tactics::settled_test
