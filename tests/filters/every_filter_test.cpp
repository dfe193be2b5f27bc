// SPDX-License-Identifier: Apache-2.0
// Laws that hold for every filter in the list, read from its own description.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "filters/list.h"
#include "samples/draw/noise.h"
#include "tactics/units.h"
#include "tests/filters/artwork_laws.h"
#include "tests/filters/weights.h"

namespace tactics::every_filter_test {
namespace {

bool is_kebab(std::string_view name) {
    if (name.empty() || name.front() == '-' || name.back() == '-') return false;
    return std::all_of(name.begin(), name.end(),
                       [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-'; });
}

Image noisy(int width, int height, int channels) {
    Image image = make_image(width, height, channels, 0.5, 0);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        image.pixels[i] = static_cast<std::uint8_t>(255.99f * samples::chance(static_cast<int>(i), width, height));
    return image;
}

// A step, so that there is something to find: dark left of the middle.
Image step(int width, int height, int channels) {
    Image image = make_image(width, height, channels, 0.5, 210);
    for (int y = 0; y < height; ++y) std::fill_n(image.row(y), static_cast<std::size_t>(width / 2 * channels), 40);
    return image;
}

EdgeMap edges_of(const Image& grey, bool with_normals) {
    EdgeMap map{grey.width, grey.height, grey.mm_per_pixel, false, {}, {}, 0};
    for (const std::uint8_t v : grey.pixels) {
        map.strength.push_back(static_cast<float>(v));
        if (with_normals) map.normal.push_back(static_cast<float>(v) / 256 * 3.14f);
    }
    return map;
}

Drawing scribble() {
    Drawing drawing{50, 30, {}, {}, {}};
    for (int i = 0; i < 6; ++i) {
        Stroke stroke{{}, i % 3 == 2, static_cast<LineClass>(i % 3), static_cast<float>(10 * i)};
        for (int k = 0; k < 3 + 4 * i; ++k)
            stroke.points.push_back(
                {50.0 * static_cast<double>(samples::chance(i, k, 1)), 30.0 * static_cast<double>(samples::chance(i, k, 2))});
        drawing.strokes.push_back(stroke);
    }
    drawing.strokes.push_back({{{5, 5}, {5, 5}}, false, LineClass::normal, 1});  // no length
    drawing.areas.push_back({{{{2, 2}, {40, 2}, {40, 25}, {2, 25}}, {{10, 10}, {20, 10}, {15, 20}}}});
    return drawing;
}

struct Case {
    std::string name;
    Artwork artwork;
};

std::vector<Case> cases_for(const Filter& filter) {
    std::vector<Case> cases;
    if (contains(filter.takes, Kind::picture)) {
        for (const auto& [w, h] : {std::pair{1, 1}, {1, 50}, {50, 1}, {2, 2}})
            cases.push_back({std::to_string(w) + "x" + std::to_string(h), noisy(w, h, 1)});
        for (const int grey : {0, 128, 255})
            cases.push_back({"flat " + std::to_string(grey), make_image(24, 20, 1, 0.5, static_cast<std::uint8_t>(grey))});
        cases.push_back({"noise", noisy(40, 30, 1)});
        cases.push_back({"step", step(40, 30, 1)});
        cases.push_back({"colour noise", noisy(40, 30, 3)});
        cases.push_back({"colour step", step(31, 23, 3)});
        cases.push_back({"colour 1x1", noisy(1, 1, 3)});
    }
    if (contains(filter.takes, Kind::edges)) {
        for (const bool normals : {false, true})
            for (const auto& [w, h] : {std::pair{1, 1}, {1, 50}, {50, 1}, {40, 30}})
                cases.push_back({"edges " + std::to_string(w) + "x" + std::to_string(h) + (normals ? " with normals" : ""),
                                 edges_of(noisy(w, h, 1), normals)});
        cases.push_back({"no edges", edges_of(make_image(24, 20, 1, 0.5, 0), true)});
    }
    if (contains(filter.takes, Kind::regions)) {
        const Step nest = parse_step("nest map=plain smallest=2mm", "test", filters());
        for (const auto& [name, picture] : {std::pair{"regions of a pixel", noisy(1, 1, 3)},
                                            {"of a column", noisy(1, 50, 1)},
                                            {"of nothing", make_image(24, 20, 1, 0.5, 128)},
                                            {"of noise", noisy(40, 30, 3)},
                                            {"of a step", step(40, 30, 3)}})
            cases.push_back({name, nest.filter->apply(picture, nest.settings)});
    }
    if (contains(filter.takes, Kind::drawing)) {
        cases.push_back({"empty drawing", Drawing{50, 30, {}, {}, {}}});
        cases.push_back({"scribble", scribble()});
    }
    return cases;
}

// The defaults, then each option at each of its ends (a choice: each of its values), the others at their defaults.
std::vector<Settings> settings_for(const Filter& filter) {
    std::vector<Settings> all{Settings(filter.options)};
    for (const Option& option : filter.options) {
        const auto add = [&](std::string_view text) {
            Settings settings(filter.options);
            settings.set(option.name, text, "test", filter.name);
            all.push_back(settings);
        };
        if (option.type == Option::Type::choice)
            for (const auto choice : choice_names(option)) add(choice);
        else if (option.type == Option::Type::spots)
            for (const auto places : {"", "0%,0%-100%,100%", "40%,0%-100%,90%;10%,20%-60%,90%"}) add(places);
        else
            for (const double value : {option.min, option.max}) add(to_text(value));
        if (option.type == Option::Type::spots && option.choices != kBoxesOnly)
            for (const auto places : {"50%,50%", "0%,0%;100%,100%;10%,20%-60%,90%"}) add(places);
    }
    return all;
}

class EveryFilter : public testing::TestWithParam<const Filter*> {};

TEST_P(EveryFilter, DescribesItself) {
    const Filter& filter = *GetParam();
    EXPECT_TRUE(is_kebab(filter.name)) << filter.name;
    EXPECT_FALSE(filter.summary.empty());
    EXPECT_NE(filter.summary.back(), '.');
    EXPECT_NE(filter.takes, 0u) << "a filter takes something";
    EXPECT_LE(filter.takes, 15u) << "unknown kinds";
    EXPECT_TRUE(filter.gives == 0 || kind_after(filter, Kind::picture) == Kind::picture ||
                kind_after(filter, Kind::picture) == Kind::edges || kind_after(filter, Kind::picture) == Kind::regions ||
                kind_after(filter, Kind::picture) == Kind::drawing)
        << "a filter gives one kind, or 0";
    EXPECT_NE(filter.apply, nullptr);
    std::set<std::string_view> names;
    for (const Option& option : filter.options) {
        EXPECT_TRUE(is_kebab(option.name)) << option.name;
        EXPECT_TRUE(names.insert(option.name).second) << option.name << " is there twice";
        EXPECT_FALSE(option.summary.empty()) << option.name;
        if (option.type == Option::Type::choice) {
            EXPECT_GE(choice_names(option).size(), 2u) << option.name;
            EXPECT_LT(option.fallback, static_cast<double>(choice_names(option).size())) << option.name;
            EXPECT_GE(option.fallback, 0) << option.name;
        } else if (option.type != Option::Type::spots) {
            EXPECT_LT(option.min, option.max) << option.name;
            EXPECT_LE(option.min, option.fallback) << option.name;
            EXPECT_GE(option.max, option.fallback) << option.name;
        }
        if (option.type == Option::Type::length) {
            EXPECT_EQ(option.unit, "mm") << option.name;
        }
    }
}

TEST_P(EveryFilter, KeepsTheLawsAtTheEndsOfItsOptions) {
    const Filter& filter = *GetParam();
    if (filter.name == "nest" || filter.name == "contours") SKIP_WITHOUT_WEIGHTS();
    for (const Case& one : cases_for(filter))
        for (const Settings& settings : settings_for(filter)) {
            SCOPED_TRACE(std::string(filter.name) + " " + settings.to_text() + " on " + one.name);
            const Artwork result = filter.apply(one.artwork, settings);
            ASSERT_EQ(name_of(kind_of(result)), name_of(kind_after(filter, kind_of(one.artwork))));
            ASSERT_EQ(broken_law(result), "");
            ASSERT_TRUE(same(result, filter.apply(one.artwork, settings))) << "another answer the second time";
        }
}

std::string test_name(const testing::TestParamInfo<const Filter*>& tested) {
    std::string name(tested.param->name);
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Filters, EveryFilter, testing::ValuesIn(filters().begin(), filters().end()), test_name);

TEST(Filters, HaveDifferentNames) {
    std::set<std::string_view> names;
    for (const Filter* filter : filters()) EXPECT_TRUE(names.insert(filter->name).second) << filter->name;
}

TEST(Recipes, ThatComeWithTheProgramCanRun) {
    for (const NamedRecipe& named : named_recipes()) {
        SCOPED_TRACE(named.name);
        EXPECT_TRUE(is_kebab(named.name));
        EXPECT_FALSE(named.summary.empty());
        if (named.text.empty()) continue;
        const Recipe recipe = find_recipe(named.name, "test");
        check(recipe);
        EXPECT_EQ(broken_law(run(recipe, step(64, 48, uses_colour(recipe) ? 3 : 1))), "");
        EXPECT_EQ(broken_law(run(recipe, noisy(1, 1, 1))), "");
    }
}

}  // namespace
}  // namespace tactics::every_filter_test
