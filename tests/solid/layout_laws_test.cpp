// SPDX-License-Identifier: Apache-2.0
// What holds of the layout of any model, on random ones.
#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "tactics/solid/space_grid.h"
#include "tactics/solid/spread.h"
#include "tests/solid/folded.h"
#include "tests/solid/models.h"

namespace tactics::layout_laws_test {
namespace {

using namespace tests;

class Chance {
public:
    explicit Chance(unsigned seed) : engine_(seed) {}
    double between(double low, double high) { return low + (high - low) * static_cast<double>(engine_()) / 4294967295.0; }

private:
    std::mt19937 engine_;
};

// On a floor, apart, turned about the vertical by any angle if `turned`.
Model random_boxes(unsigned seed, int count, bool turned) {
    Chance chance(seed);
    Model model;
    for (int i = 0; i < count; ++i) {
        const double x = (i % 15) * 1200.0, y = (i / 15) * 1200.0, height = chance.between(100, 900);
        const std::size_t first = model.vertices.size();
        add_box(model, "Box " + std::to_string(i), -1, {x, y, height / 2},
                {chance.between(200, 800), chance.between(200, 800), height});
        const double angle = turned ? chance.between(0, 2 * std::numbers::pi) : 0;
        for (std::size_t v = first; v < model.vertices.size(); ++v) {
            Point3& at = model.vertices[v];
            const double dx = at.x - x, dy = at.y - y;
            at = {x + dx * std::cos(angle) - dy * std::sin(angle), y + dx * std::sin(angle) + dy * std::cos(angle), at.z};
        }
    }
    return model;
}

// A prism or, with a tip, a pyramid over a convex base of that many corners.
void add_prism(Model& model, Chance& chance, int corners, bool tip, const Point3& at) {
    add_object(model, tip ? "Pyramid" : "Prism");
    const double radius = chance.between(100, 400), height = chance.between(100, 600), start = chance.between(0, 1);
    std::vector<Point3> low, high;
    for (int i = 0; i < corners; ++i) {
        const double angle = start + 2 * std::numbers::pi * (i + chance.between(-0.2, 0.2)) / corners;
        low.push_back(at + Point3{radius * std::cos(angle), radius * std::sin(angle), 0});
        high.push_back(low.back() + Point3{0, 0, height});
    }
    const Point3 apex = at + Point3{chance.between(-50, 50), chance.between(-50, 50), height};
    add_face(model, {low.rbegin(), low.rend()});
    for (std::size_t i = 0; i < low.size(); ++i) {
        const std::size_t next = (i + 1) % low.size();
        if (tip)
            add_face(model, {low[i], low[next], apex});
        else
            add_face(model, {low[i], low[next], high[next], high[i]});
    }
    if (!tip) add_face(model, high);
}

TEST(LayoutLaws, AHundredAndFiftyBoxesKeepTheirShapesAndOverlapNowhere) {
    for (const bool turned : {false, true}) {
        const Folded made = folded(random_boxes(turned ? 2 : 1, 150, turned));
        EXPECT_GT(folded_ones(made), 150u);
        expect_true_shapes(made);
        const int pairs = expect_no_overlap(made);
#if TACTICS_HAS_GEOS
        EXPECT_GT(pairs, 10'000);
#else
        (void)pairs;
#endif
    }
}

TEST(LayoutLaws, PrismsAndPyramidsKeepTheirShapesAndOverlapNowhere) {
    for (unsigned seed = 1; seed <= 20; ++seed) {
        Chance chance(seed);
        Model model;
        for (int i = 0; i < 6; ++i)
            add_prism(model, chance, 3 + (static_cast<int>(seed) + i) % 6, i % 2 == 1, {i * 700.0, chance.between(0, 700), 0});
        for (const ViewPlane& view : {kFromAbove, kFromTheFront}) {
            const Folded made = folded(model, view, seed % 2 == 0);
            EXPECT_GT(folded_ones(made), 0u) << seed;
            expect_true_shapes(made);
            expect_no_overlap(made);
        }
    }
}

#if TACTICS_HAS_GEOS
// What is folded out of one thing is as far from the lines of others as the layout was asked for, or lies on them.
TEST(LayoutLaws, FacesOfDifferentThingsAreApart) {
    const Geos geos;
    int pairs = 0;
    for (unsigned seed = 1; seed <= 4; ++seed) {
        const Folded flat = folded(random_boxes(seed, 40, seed % 2 == 0));
        constexpr double kGap = 60;  // mm of the model
        const FlatLayout layout = lay_flat(flat.parts, flat.panels, flat.thing, kFromAbove, {{}, kGap, 8});
        std::vector<GeosShape> borders;
        for (const PlacedPanel& placed : layout.panels) {
            std::vector<Point> ring = placed.shape.rings.front();
            ring.push_back(ring.front());
            borders.push_back(GeosShape::line(geos, ring));
        }
        const auto thing_of = [&](std::size_t i) { return flat.thing[flat.panels.panels[layout.panels[i].panel].part]; };
        for (std::size_t i = 0; i < borders.size(); ++i)
            for (std::size_t j = 0; j < borders.size(); ++j) {
                if (layout.panels[i].handling == Handling::kept || thing_of(i) == thing_of(j)) continue;
                const double off = borders[i].distance_to(borders[j]);
                EXPECT_TRUE(off >= kGap - 1e-6 || off <= touching_in(flat.parts)) << off << ", seed " << seed;
                pairs += off < 10 * kGap;
            }
    }
    EXPECT_GT(pairs, 500);
}
#endif

// A border of very many corners, straight ones and bent, keeps its shape and costs no square of them.
TEST(LayoutLaws, VeryLongBordersAreMadeOfFewerCorners) {
    Model model;
    add_object(model, "Disc");
    std::vector<Point3> ring;
    constexpr int kCorners = 20'000;
    for (int i = 0; i < kCorners; ++i) {
        const double angle = 2 * std::numbers::pi * i / kCorners;
        ring.push_back({500 * std::cos(angle), 500 * std::sin(angle), 0});
    }
    add_face(model, ring);
    std::vector<Phrase> notes;
    const std::vector<ModelPart> parts = parts_of(model, {}, {}, notes);
    ASSERT_EQ(parts.size(), 1u);
    const std::vector<Point3>& made = parts.front().solid.patches.front().rings.front();
    EXPECT_LT(made.size(), 1001u);
    for (std::size_t i = 0; i < made.size(); ++i) {
        EXPECT_NEAR(length_of(made[i]), 500, 1e-9);
        EXPECT_GT(length_of(0.5 * (made[i] + made[(i + 1) % made.size()])), 499) << "within a thousandth of 1 m";
    }
}

// More of it never rates worse, and the same model gives the same.
TEST(LayoutLaws, MoreEffortIsNoWorseAndBounded) {
    const Model model = random_boxes(3, 12, true);
    Folded made = folded(model);
    double last = -1e9;
    for (const int effort : {0, 4, 16, 64}) {
        const LayoutWish wish{.reader = {}, .gap = 100, .effort = effort};
        const FlatLayout one = lay_flat(made.parts, made.panels, made.thing, kFromAbove, wish);
        EXPECT_GE(one.rating.value(), last - 1e-9) << effort;
        EXPECT_EQ(one.rating.value(), lay_flat(made.parts, made.panels, made.thing, kFromAbove, wish).rating.value());
        last = one.rating.value();
    }
    for (const std::size_t panels : {1u, 200u, 1000u, 100'000u}) {
        EXPECT_LE(layouts_tried(64, panels), 64);
        EXPECT_LE(static_cast<double>(layouts_tried(64, panels)) * static_cast<double>(panels), 64 * 200.0);
    }
    EXPECT_EQ(layouts_tried(64, 200), 64);
}

// Beside looking at all.
TEST(SpaceGrid, FindsTheBoxesThatLookingAtAllFinds) {
    for (const double scale : {1e-4, 1.0, 1e6}) {
        Chance chance(5);
        std::vector<SpaceBox> boxes;
        for (int i = 0; i < 400; ++i) {
            const Point3 low{scale * chance.between(-50, 50), scale * chance.between(-5, 5), scale * chance.between(0, 90)};
            const double size = scale * (i % 40 == 0 ? 60 : chance.between(0, 4));
            boxes.push_back({low, low + Point3{size, size, size}});
        }
        const SpaceGrid grid(boxes);
        for (const SpaceBox& box : boxes) {
            std::vector<std::uint32_t> twin;
            for (std::uint32_t i = 0; i < boxes.size(); ++i)
                if (!(apart(boxes[i], box) > 0)) twin.push_back(i);
            ASSERT_EQ(grid.near(box), twin) << scale;
        }
    }
    EXPECT_TRUE(SpaceGrid({}).near({}).empty());
}

// Whatever stays together goes the same way; joining the pairs that touch, again and again, is the twin.
TEST(Spread, MovesTogetherWhatTouches) {
    for (unsigned seed = 1; seed <= 8; ++seed) {
        Chance chance(seed);
        Model model;
        for (int i = 0; i < 60; ++i)
            add_box(model, "Box", -1, {chance.between(0, 4000), chance.between(0, 4000), 100},
                    {chance.between(50, 500), chance.between(50, 500), 200});
        std::vector<Phrase> notes;
        const std::vector<ModelPart> parts = parts_of(model, {}, {}, notes);
        const std::vector<std::uint32_t> thing = things_of(model, parts);
        std::vector<Box> group;
        std::vector<std::size_t> of;
        for (const ModelPart& part : parts) {
            const SpaceBox box = space_of(part);
            of.push_back(group.size());
            group.push_back({box.low.x, -box.high.y, box.high.x, -box.low.y});
        }
        for (bool changed = true; changed;) {
            changed = false;
            for (std::size_t a = 0; a < of.size(); ++a)
                for (std::size_t b = 0; b < of.size(); ++b) {
                    Box &one = group[of[a]], &other = group[of[b]];
                    const double least = std::min({one.width(), one.height(), other.width(), other.height()});
                    if (of[a] == of[b] || !meet(grown(one, 0.01 * least), other)) continue;
                    one.take({other.left, other.top});
                    one.take({other.right, other.bottom});
                    const std::size_t gone = of[b];
                    std::replace(of.begin(), of.end(), gone, of[a]);
                    changed = true;
                }
        }
        const std::vector<Point3> by = spread_by(parts, thing, kFromAbove, 2);
        ASSERT_TRUE(by.empty() || by.size() == parts.size());
        for (std::size_t a = 0; a < by.size(); ++a)
            for (std::size_t b = 0; b < a; ++b) EXPECT_EQ(of[a] == of[b], length_of(by[a] - by[b]) < 1e-9) << seed;
    }
}

}  // namespace
}  // namespace tactics::layout_laws_test
