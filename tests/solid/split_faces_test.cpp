// SPDX-License-Identifier: Apache-2.0
// A model is the same however its planes are cut into faces.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "tactics/solid/part.h"
#include "tactics/solid/welded.h"
#include "tests/solid/models.h"

namespace tactics::split_faces_test {
namespace {

using tests::add_box;
using tests::add_face;
using tests::add_object;

using Ring = std::vector<Point3>;

std::vector<Ring> rings_of(const Model& model) {
    std::vector<Ring> rings;
    for (const ModelFace& face : model.faces) {
        Ring& ring = rings.emplace_back();
        for (std::uint32_t i = 0; i < face.count; ++i) ring.push_back(model.vertices[model.corners[face.first + i]]);
    }
    return rings;
}

// All in one object.
Model object_of(
    const std::vector<Ring>& rings, const std::function<Point3(const Point3&)>& to = [](const Point3& at) { return at; }) {
    Model model;
    add_object(model, "Thing");
    for (Ring ring : rings) {
        for (Point3& at : ring) at = to(at);
        add_face(model, ring);
    }
    return model;
}

std::vector<Ring> box(const Point3& low, const Point3& high) {
    Model model;
    add_box(model, "Box", -1, 0.5 * (low + high), high - low);
    return rings_of(model);
}

std::vector<Ring> for_both_sides(std::vector<Ring> rings) {
    const std::size_t count = rings.size();
    for (std::size_t i = 0; i < count; ++i) rings.push_back({rings[i].rbegin(), rings[i].rend()});
    return rings;
}

// Four sides round a bottom, all without thickness.
std::vector<Ring> tray() {
    std::vector<Ring> rings = box({0, 0, 0}, {300, 200, 60});
    rings.erase(rings.begin() + 1);
    return rings;
}

std::vector<Ring> both(std::vector<Ring> one, const std::vector<Ring>& other) {
    one.insert(one.end(), other.begin(), other.end());
    return one;
}

// Top and legs touch: their corners do, and no edge of one is one of the other.
std::vector<Ring> stool() {
    std::vector<Ring> rings = box({0, 0, 400}, {400, 300, 430});
    for (const double x : {0.0, 360.0})
        for (const double y : {0.0, 260.0}) rings = both(rings, box({x, y, 0}, {x + 40, y + 40, 400}));
    return rings;
}

std::vector<Ring> cubes() {
    std::vector<Ring> rings;
    for (const Point3& at : {Point3{0, 0, 0}, Point3{100, 0, 0}, Point3{0, 100, 0}, Point3{0, 0, 100}})
        rings = both(rings, box(at, at + Point3{100, 100, 100}));
    return rings;
}

std::vector<Ring> stairs() {
    std::vector<Ring> rings;
    for (int i = 0; i < 4; ++i) rings = both(rings, box({0, 100.0 * i, 0}, {300, 100.0 * i + 100, 60.0 * i + 60}));
    return rings;
}

std::vector<Ring> with_back(std::vector<Ring> rings, std::size_t of) {
    rings.push_back({rings[of].rbegin(), rings[of].rend()});
    return rings;
}

// Rhomboids with a side of 50 mm, each bent by far more than welding forgives and, in part, by less than a finger feels.
std::vector<Ring> dune(double high) {
    std::mt19937 engine(3);
    double heights[5][5];
    for (auto& row : heights)
        for (double& one : row) one = high * static_cast<double>(engine()) / 4294967295.0;
    std::vector<Ring> rings;
    const auto at = [&](int i, int j) { return Point3{50.0 * i + 15 * j, 50.0 * j, heights[i][j]}; };
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) rings.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    return rings;
}

class Cutter {
public:
    explicit Cutter(unsigned seed) : engine_(seed) {}
    double next() { return static_cast<double>(engine_()) / 4294967295.0; }
    // Four corners become triangles, of a plane from any corner, some of them cut again at a place on a side that no other face
    // knows of.
    void cut(Ring ring, std::vector<Ring>& into) {
        const bool bent = std::abs(dot(cross(ring[1] - ring[0], ring[2] - ring[0]), ring[3] - ring[0])) > 1;
        const bool on = bent ? length_of(ring[3] - ring[1]) < length_of(ring[2] - ring[0]) : engine_() % 2 == 0;
        if (on) std::rotate(ring.begin(), ring.begin() + 1, ring.end());
        cut({ring[0], ring[1], ring[2]}, 2, into);
        cut({ring[0], ring[2], ring[3]}, 2, into);
    }
    void shuffle(std::vector<Ring>& rings) { std::shuffle(rings.begin(), rings.end(), engine_); }

private:
    void cut(std::array<Point3, 3> one, int deep, std::vector<Ring>& into) {
        std::rotate(one.begin(), one.begin() + static_cast<std::ptrdiff_t>(engine_() % 3), one.end());
        if (deep == 0 || next() < 0.4) {
            into.push_back({one.begin(), one.end()});
            return;
        }
        const Point3 at = one[0] + (0.2 + 0.6 * next()) * (one[1] - one[0]);
        cut({one[0], at, one[2]}, deep - 1, into);
        cut({at, one[1], one[2]}, deep - 1, into);
    }
    std::mt19937 engine_;
};

std::vector<ModelPart> parts(const Model& model) {
    std::vector<Phrase> notes;
    return parts_of(model, {}, {}, notes);
}

std::vector<double> areas_of(const ModelPart& part) {
    std::vector<double> areas;
    for (const Patch& patch : part.solid.patches) areas.push_back(patch.area);
    std::sort(areas.begin(), areas.end());
    return areas;
}

void expect_same(const std::vector<ModelPart>& one, const std::vector<ModelPart>& other, const std::string& what) {
    ASSERT_EQ(one.size(), other.size()) << what;
    for (std::size_t i = 0; i < one.size(); ++i) {
        EXPECT_EQ(one[i].form, other[i].form) << what;
        EXPECT_EQ(one[i].solid.closed, other[i].solid.closed) << what;
        EXPECT_EQ(one[i].solid.seams.size(), other[i].solid.seams.size()) << what;
        for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(one[i].box.half[k], other[i].box.half[k], 0.05) << what;
        const std::vector<double> areas = areas_of(one[i]), others = areas_of(other[i]);
        ASSERT_EQ(areas.size(), others.size()) << what;
        for (std::size_t k = 0; k < areas.size(); ++k) EXPECT_NEAR(areas[k], others[k], 1e-4 * areas.back()) << what;
    }
}

Point3 turned(const Point3& at) {
    const double x = 0.8 * at.x - 0.6 * at.y, y = 0.6 * at.x + 0.8 * at.y;
    return {x, 0.96 * y - 0.28 * at.z, 0.28 * y + 0.96 * at.z};
}

TEST(SplitFaces, HaveTheSameParts) {
    const std::pair<const char*, std::vector<Ring>> all[] = {
        {"box", box({0, 0, 0}, {100, 80, 60})},
        {"tray", tray()},
        {"dune", dune(8)},
        {"tray for both sides", for_both_sides(tray())},
        {"dune for both sides", for_both_sides(dune(8))},
        {"stool", stool()},
        {"cubes", cubes()},
        {"stairs", stairs()},
        {"box on a tray for both sides", both(for_both_sides(tray()), box({50, 50, 0}, {120, 150, 40}))},
        {"tray of which one side is for both", with_back(tray(), 2)},
    };
    for (const auto& [name, rings] : all)
        for (const bool turns : {false, true}) {
            const auto to = [turns](const Point3& at) { return turns ? turned(at) : at; };
            const std::vector<ModelPart> whole = parts(object_of(rings, to));
            for (unsigned seed = 1; seed < 6; ++seed) {
                Cutter cutter(seed);
                std::vector<Ring> cut;
                for (Ring ring : rings) {
                    for (Point3& at : ring) at = to(at);
                    cutter.cut(ring, cut);
                }
                cutter.shuffle(cut);
                expect_same(whole, parts(object_of(cut)),
                            std::string(name) + (turns ? ", turned, " : ", ") + std::to_string(seed));
            }
        }
}

TEST(SplitFaces, SheetsForBothSidesAreSheets) {
    const std::vector<ModelPart> made = parts(object_of(for_both_sides(tray())));
    ASSERT_EQ(made.size(), 1u);
    EXPECT_EQ(made[0].solid.patches.size(), 5u);
    EXPECT_FALSE(made[0].solid.closed);
    const std::vector<ModelPart> closed = parts(object_of(for_both_sides(box({0, 0, 0}, {100, 80, 60}))));
    ASSERT_EQ(closed.size(), 1u);
    EXPECT_EQ(closed[0].solid.patches.size(), 6u);
    EXPECT_TRUE(closed[0].solid.closed);
    for (const Patch& patch : closed[0].solid.patches) EXPECT_GT(dot(patch.normal, middle_of(patch) - Point3{50, 40, 30}), 0);
}

TEST(SplitFaces, SolidsThatTouchAreSeveralButForThoseThatShareAnEdge) {
    EXPECT_EQ(parts(object_of(stool())).size(), 5u);
    EXPECT_EQ(parts(object_of(cubes())).size(), 1u);
}

TEST(SplitFaces, OfWhatIsBentAreTheSameWhereverItBegins) {
    for (const std::vector<Ring>& rings :
         {dune(8), dune(1), std::vector<Ring>{{{0, 0, 0}, {50, 0, 3}, {80, 40, 0}, {40, 70, 5}, {0, 40, 0}}}})
        for (Ring ring : rings) {
            std::set<std::set<std::array<double, 3>>> kinds;
            for (std::size_t begin = 0; begin < ring.size(); ++begin) {
                std::set<std::array<double, 3>> middles;
                for (const auto& one : cut_if_bent(ring, 1e-3)) {
                    const Point3 sum = ring[one[0]] + ring[one[1]] + ring[one[2]];
                    middles.insert({std::round(1e6 * sum.x), std::round(1e6 * sum.y), std::round(1e6 * sum.z)});
                }
                EXPECT_EQ(middles.size(), ring.size() - 2);
                kinds.insert(middles);
                std::rotate(ring.begin(), ring.begin() + 1, ring.end());
            }
            EXPECT_EQ(kinds.size(), 1u);
        }
    EXPECT_TRUE(cut_if_bent({{0, 0, 0}, {50, 0, 0}, {50, 50, 0}, {0, 50, 0}}, 1e-3).empty());
}

}  // namespace
}  // namespace tactics::split_faces_test
