// SPDX-License-Identifier: Apache-2.0
// Models laid flat, and what holds of every layout.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tactics/solid/lay_flat.h"
#include "tactics/solid/panels.h"
#include "tactics/solid/reach.h"
#include "tactics/solid/thing.h"
#if TACTICS_HAS_GEOS
#include "tests/geos_shape.h"
#endif

namespace tactics::tests {

struct Folded {
    std::vector<ModelPart> parts;
    std::vector<std::uint32_t> thing;
    Panels panels;
    FlatLayout layout;
};

inline Folded folded(const Model& model, const ViewPlane& view = kFromAbove, bool floor = true) {
    Folded made;
    std::vector<Phrase> notes;
    made.parts = parts_of(model, {}, {}, notes);
    made.thing = things_of(model, made.parts);
    made.panels = panels_of(made.parts, made.thing, view);
    find_reached(made.panels, made.parts, {.floor = floor});
    made.layout = lay_flat(made.parts, made.panels, made.thing, view, {});
    return made;
}

inline double area_of(const FlatShape& shape) {
    double sum = 0;
    for (const auto& ring : shape.rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
            sum += (a.x * b.y - b.x * a.y) / 2;
        }
    return std::abs(sum);
}

inline std::size_t folded_ones(const Folded& made) {
    return static_cast<std::size_t>(std::count_if(made.layout.panels.begin(), made.layout.panels.end(),
                                                  [](const PlacedPanel& one) { return one.handling == Handling::folded; }));
}

// True to area and to every side and angle, which for a polygon is to all distances between its corners.
inline void expect_true_shapes(const Folded& made) {
    for (const PlacedPanel& placed : made.layout.panels) {
        const Panel& panel = made.panels.panels[placed.panel];
        ASSERT_EQ(panel.rings.size(), placed.shape.rings.size());
        EXPECT_NEAR(area_of(placed.shape), panel.area, 1e-6 * panel.area + 1e-9);
        for (std::size_t r = 0; r < panel.rings.size(); ++r)
            for (std::size_t i = 0; i < panel.rings[r].size(); ++i)
                for (std::size_t j = 0; j < i; ++j)
                    EXPECT_NEAR(distance(placed.shape.rings[r][i], placed.shape.rings[r][j]),
                                length_of(panel.rings[r][i] - panel.rings[r][j]), 1e-6 * std::sqrt(panel.area));
    }
}

#if TACTICS_HAS_GEOS
// By GEOS, which shares no code with the layout: what is folded, turned or laid down lies on nothing but what it stands on, which
// lies where it is, below it and all round it. Gives how many pairs were measured.
inline int expect_no_overlap(const Folded& made) {
    const Geos geos;
    std::vector<GeosShape> shapes;
    for (const PlacedPanel& placed : made.layout.panels) shapes.push_back(GeosShape::area(geos, placed.shape.rings));
    const double touching = touching_in(made.parts);
    int pairs = 0;
    for (std::size_t i = 0; i < shapes.size(); ++i)
        for (std::size_t j = 0; j < shapes.size(); ++j) {
            const PlacedPanel &one = made.layout.panels[i], &other = made.layout.panels[j];
            if (i == j || one.handling == Handling::kept || (other.handling != Handling::kept && j < i)) continue;
            // As much as both may reach over their border.
            const double least = 4 * touching * (shapes[i].length() + shapes[j].length());
            const double shared = shapes[i].shared_with(shapes[j]);
            const bool stands_on_it =
                other.handling == Handling::kept && other.height <= one.height + touching && shared > shapes[i].area() - least;
            EXPECT_TRUE(shared < least || stands_on_it)
                << shared << " mm2 of panels " << one.panel << " (" << name_of(one.handling) << ", " << one.height << ") and "
                << other.panel << " (" << name_of(other.handling) << ", " << other.height << "), over " << least;
            ++pairs;
        }
    return pairs;
}
#else
inline int expect_no_overlap(const Folded&) { return 0; }
#endif

}  // namespace tactics::tests
