// SPDX-License-Identifier: Apache-2.0
#include "tactics/layout/chosen_heights.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <tuple>

#include "print/display_parts.h"
#include "print/embosser.h"
#include "print/format.h"
#include "print/machines/punched.h"
#include "tactics/layout/lay_out.h"

namespace tactics::chosen_heights_test {
namespace {

PageStroke line(Role role, double x, double length) { return {{{x, 5}, {x, 5 + length}}, false, 1.6, role}; }

Page page_of(std::initializer_list<std::pair<Role, double>> lines) {
    Page page;
    page.width = 150;
    page.height = 100;
    double x = 10;
    for (const auto& [role, length] : lines) {
        page.strokes.push_back(line(role, x, length));
        x += 20;
    }
    return page;
}

KindHeights heights_of(const Page& page, int most) { return kind_heights({&page, 1}, {.levels = most + 1}); }

TEST(KindHeights, AsManyAreTakenAsThereAreKindsAndNoMore) {
    EXPECT_EQ(heights_of(page_of({}), 4).used, 1);
    EXPECT_EQ(heights_of(page_of({{Role::line, 50}, {Role::dash, 3}, {Role::arrow, 3}}), 4).used, 1);
    EXPECT_EQ(heights_of(page_of({{Role::grid, 50}}), 4).share(LineKind::grid), 1);
    Page photograph = page_of({{Role::line, 50}, {Role::line, 20}});
    photograph.strokes.back().inner = true;
    EXPECT_EQ(heights_of(photograph, 2).used, 2);
    EXPECT_EQ(heights_of(photograph, 2).share(LineKind::inner), 0.5);
    const KindHeights three = heights_of(page_of({{Role::line, 50}, {Role::axis, 60}, {Role::pattern, 20}}), 4);
    EXPECT_EQ(three.used, 3);
    EXPECT_EQ(three.losses.back(), 0);
    EXPECT_EQ(three.share(LineKind::drawn), 1);
    EXPECT_NEAR(three.share(LineKind::values), 2.0 / 3, 1e-12);
    EXPECT_NEAR(three.share(LineKind::pattern), 1.0 / 3, 1e-12);
}

// With too few of them those kinds share one of which it is least missed: tried here over all ways to share.
TEST(KindHeights, LoseTheLeastThatSoManyCan) {
    std::mt19937 random(5);
    const Role roles[] = {Role::line, Role::line, Role::axis, Role::grid, Role::pattern};  // the second of them inside things
    for (int trial = 0; trial < 60; ++trial) {
        Page page;
        std::vector<double> lengths;
        for (const Role role : roles) {
            const double length = random() % 4 == 0 ? 0 : static_cast<double>(random() % 90 + 1);
            if (length > 0) page.strokes.push_back(line(role, 10, length));
            if (length > 0) page.strokes.back().inner = lengths.size() == 1;
            lengths.push_back(length > 0 ? length + 1.6 : 0);
        }
        const auto bits = [&](const std::map<int, double>& parts) {
            double all = 0, sum = 0;
            for (const auto& [height, length] : parts) all += length;
            for (const auto& [height, length] : parts)
                if (length > 0) sum -= length / all * std::log2(length / all);
            return sum;
        };
        const double whole = bits({{0, lengths[0]}, {1, lengths[1]}, {2, lengths[2]}, {3, lengths[3]}, {4, lengths[4]}});
        double before = 1;
        for (int most = 1; most <= 5; ++most) {
            double least = whole > 0 ? 1 : 0;
            for (int ways = 0; ways < 8 * 8 * 8 * 8 * 8; ++ways) {
                int height[5];
                bool falls = true;
                for (int kind = 0; kind < 5; ++kind) {
                    height[kind] = ways >> (3 * kind) & 7;
                    falls = falls && height[kind] < most && (kind == 0 || height[kind] >= height[kind - 1]);
                }
                if (!falls || !(whole > 0)) continue;
                std::map<int, double> parts;
                for (int kind = 0; kind < 5; ++kind) parts[height[kind]] += lengths[static_cast<std::size_t>(kind)];
                least = std::min(least, 1 - bits(parts) / whole);
            }
            const KindHeights heights = heights_of(page, most);
            const double loss = heights.losses.empty() ? 0 : heights.losses[static_cast<std::size_t>(heights.used) - 1];
            EXPECT_NEAR(loss, least, 1e-9);
            EXPECT_LE(heights.used, most);
            EXPECT_LE(loss, before + 1e-12) << "more heights never lose more";
            before = loss;
            for (std::size_t kind = 1; kind < kLineKinds; ++kind) EXPECT_GE(heights.rank[kind], heights.rank[kind - 1]);
        }
    }
}

Page on_bed(Page page, const Format& format, const Settings& settings) {
    const DotSetting dots = format.dots(settings);
    page.cell = dots.cell;
    page.bed = dots.bed;
    page.live = {0, 0, page.width, page.height};
    page.heights = kind_heights({&page, 1}, dots.heights);
    return page;
}

// A stretch of a chart that has no grid, and one of nothing but it, stand as the whole does.
TEST(KindHeights, AreTheSameOnAllSheetsOfADrawing) {
    Drawing drawing;
    drawing.width = 300;
    drawing.height = 100;
    const auto add = [&](Role role, double x) {
        drawing.strokes.push_back({{{x, 10}, {x, 90}}, false, LineClass::normal, 0, role});
    };
    add(Role::line, 20);
    add(Role::axis, 40);
    add(Role::grid, 280);
    Sheet sheet;
    sheet.paper = find_paper("a5", "");
    sheet.medium = &find_medium("embosser", "");
    sheet.tiles = {3, 1};
    const auto shares = [](const Page& page) {
        return std::tuple(page.heights.share(LineKind::values), page.heights.share(LineKind::grid));
    };
    for (const int levels : {2, 3, 5}) {
        sheet.heights.levels = levels;
        const Pages pages = pages_of(drawing, sheet);
        ASSERT_GE(pages.all.size(), 3u);
        std::size_t with_other_kinds = 0;
        for (const Page& page : pages.all) {
            EXPECT_EQ(shares(page), shares(pages.whole()));
            with_other_kinds += kind_heights({&page, 1}, sheet.heights).there != pages.whole().heights.there;
        }
        EXPECT_GT(with_other_kinds, 0u) << "or there would be nothing to differ";
        EXPECT_EQ(pages.whole().heights.differ(), levels > 2);
        for (const Page& part : parts_of({&pages.whole(), 1}, 150, 100)) EXPECT_EQ(shares(part), shares(pages.whole()));
    }
    sheet.heights.wished[static_cast<std::size_t>(LineKind::values)] = 0.8;
    EXPECT_EQ(std::get<0>(shares(pages_of(drawing, sheet).whole())), 0.8);
}

// The machines' own twins tell how high each dot stands.
TEST(KindHeights, AreThoseThatMachinesRaise) {
    for (const std::string_view name : {"graphiti", "viewplus"}) {
        const Format& format = *find_format(name);
        Settings settings(format.options);
        const auto shown = [&](std::initializer_list<std::pair<Role, double>> lines) {
            std::map<int, int> dots;  // how many of each height, in percent
            const std::string bytes = format.encode(on_bed(page_of(lines), format, settings), settings);
            const PunchedSheet sheet = format.embosser->punch(bytes, settings).sheets.at(0);
            for (std::size_t dot = 0; dot < sheet.dots.size(); ++dot)
                ++dots[static_cast<int>(std::lround(100 * sheet.height_of(dot)))];
            std::vector<int> heights;
            for (const auto& [height, count] : dots) heights.push_back(height);
            return heights;
        };
        EXPECT_EQ(shown({{Role::line, 50}}), std::vector<int>{100}) << name;
        EXPECT_EQ(shown({{Role::line, 50}, {Role::pattern, 50}}), (std::vector<int>{50, 100})) << name;
        EXPECT_EQ(shown({{Role::line, 50}, {Role::axis, 50}}), (std::vector<int>{50, 100})) << name;
        if (name == "graphiti") {
            EXPECT_EQ(shown({{Role::line, 50}, {Role::axis, 50}, {Role::grid, 50}, {Role::pattern, 50}}),
                      (std::vector<int>{25, 50, 75, 100}));
        }
        settings.set("axes", name == "graphiti" ? "3" : "75", "test", name);
        EXPECT_EQ(shown({{Role::line, 50}, {Role::axis, 50}}), (std::vector<int>{75, 100})) << name;
    }
}

}  // namespace
}  // namespace tactics::chosen_heights_test
