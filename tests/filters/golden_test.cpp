// SPDX-License-Identifier: Apache-2.0
// What each filter does to the same small photograph, drawing or edge map. Written against the list: a new filter
// without a golden image fails here.
#include "tests/golden/golden.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "filters/list.h"
#include "tests/filters/weights.h"

namespace tactics::golden_test {
namespace {

constexpr double kSquare = 63.5;  // the pictures of the pilot study were 2.5 inches

Image photo(bool colour) {
    Image image = golden::read_golden("samples/house");
    image.mm_per_pixel = kSquare / image.width;
    return colour ? image : to_grey(std::move(image));
}

// Plain differences over two pixels: half a step's height on either side of it, hence the factor 1.
EdgeMap edges() {
    const Image image = photo(false);
    EdgeMap map{image.width, image.height, image.mm_per_pixel, false, {}, {}, 0};
    const auto at = [&](int x, int y) {
        return image.row(std::clamp(y, 0, image.height - 1))[std::clamp(x, 0, image.width - 1)];
    };
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const float dx = static_cast<float>(at(x + 1, y) - at(x - 1, y)),
                        dy = static_cast<float>(at(x, y + 1) - at(x, y - 1));
            map.strength.push_back(std::hypot(dx, dy));
            float angle = std::atan2(dy, dx);
            if (angle < 0) angle += 3.14159265f;
            map.normal.push_back(angle >= 3.14159265f ? 0 : angle);
        }
    return map;
}

// One of each thing that a filter may change: a jagged line, two close ones, a stub, a ring, an area with a hole.
Drawing drawing() {
    Drawing d{60, 45, {}, {}, {}};
    Stroke jagged{{}, false, LineClass::normal, 90};
    for (int i = 0; i <= 40; ++i) jagged.points.push_back({4 + 1.3 * i, 8 + (i % 2) * 0.6 + 4 * std::sin(i * 0.25)});
    d.strokes.push_back(jagged);
    d.strokes.push_back({{{5, 20}, {28, 20}}, false, LineClass::thin, 60});
    d.strokes.push_back({{{5, 21.6}, {28, 22}}, false, LineClass::thick, 40});
    d.strokes.push_back({{{34, 19}, {36, 20}}, false, LineClass::normal, 20});
    Stroke ring{{}, true, LineClass::normal, 70};
    for (int i = 0; i < 24; ++i) ring.points.push_back({47 + 7 * std::cos(i * 0.2618), 22 + 6 * std::sin(i * 0.2618)});
    d.strokes.push_back(ring);
    d.areas.push_back({{{{6, 28}, {26, 28}, {26, 41}, {6, 41}}, {{11, 32}, {21, 32}, {16, 38}}}});
    return d;
}

// What shows best what a filter is for, where its defaults on a photograph would not: what comes before it, its settings.
struct Shown {
    std::string_view filter, before, settings;
};
constexpr Shown kShown[] = {
    {"resample", "", "dpi=25"},
    {"crop", "", "left=20 top=10 right=5"},
    {"morphology", "threshold", "radius=1mm"},
    {"despeckle", "threshold", ""},
    {"fill-holes", "threshold", ""},
    {"trace", "threshold", ""},
    {"nest", "", "map=learned smallest=2mm"},
    {"simplify", "", "tolerance=1mm"},
    {"regions", "kmeans k=3", "smallest=6mm clear=3mm"},
    {"borders", "kmeans k=3", "smallest=3mm"},
    {"levels", "", "smallest=4mm"},
};

Artwork input_for(const Filter& filter, std::string_view before) {
    if (contains(filter.takes, Kind::regions))
        return run(parse_recipe("nest map=learned smallest=2mm", "golden", filters()), photo(true));
    if (!contains(filter.takes, Kind::picture))
        return contains(filter.takes, Kind::edges) ? Artwork(edges()) : Artwork(drawing());
    const Image image = photo(filter.uses_colour);
    return before.empty() ? Artwork(image) : run(parse_recipe(before, "golden", filters()), image);
}

class FilterGolden : public testing::TestWithParam<const Filter*> {};

TEST_P(FilterGolden, LooksAsItDid) {
    const Filter& filter = *GetParam();
    if (filter.name == "nest" || filter.name == "outlines") SKIP_WITHOUT_WEIGHTS();
    Shown shown{filter.name, "", ""};
    for (const Shown& row : kShown)
        if (row.filter == filter.name) shown = row;
    const Step step = parse_step(std::string(filter.name) + " " + std::string(shown.settings), "golden", filters());
    const Artwork result = filter.apply(input_for(filter, shown.before), step.settings);
    golden::expect_golden("filters/" + std::string(filter.name), golden::picture_of(result));
}

std::string test_name(const testing::TestParamInfo<const Filter*>& tested) {
    std::string name(tested.param->name);
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Filters, FilterGolden, testing::ValuesIn(filters().begin(), filters().end()), test_name);

}  // namespace
}  // namespace tactics::golden_test
