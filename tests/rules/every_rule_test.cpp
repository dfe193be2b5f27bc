// For every rule a page that just passes and one that just fails. A rule without such a pair fails here.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>

#include "filters/list.h"
#include "print/format.h"
#include "tactics/error.h"
#include "tests/rules/pages.h"

namespace tactics {
namespace {

using namespace tests;

/// A page on which the rule measures just that.
using PageOf = std::function<Page(double measure)>;

BrailleLine letters(Point at, std::size_t count = 3) { return {at, std::vector<std::uint8_t>(count, 0x3f)}; }

Page two_lines(double apart) {
    Page page = blank_page();
    add_line(page, {{20, 50}, {120, 50}});
    add_line(page, {{20, 50 + apart}, {120, 50 + apart}});
    return page;
}

Page inked(double percent) {
    Page page = blank_page();
    page.areas.push_back({{rectangle(10, 0, 200 * percent / 100, 200)}});
    return page;
}

const std::map<std::string, PageOf>& pages() {
    static const std::map<std::string, PageOf> kPages = {
        {"gap", [](double gap) { return two_lines(gap + 1); }},
        {"merging-dots", [](double apart) { return two_lines(apart); }},
        {"crossings",
         [](double count) {
             Page page = blank_page();
             for (int i = 0; i < static_cast<int>(count); ++i) {
                 const double angle = std::numbers::pi * i / count, x = 60 * std::cos(angle), y = 60 * std::sin(angle);
                 add_line(page, {{100 - x, 100 - y}, {100 + x, 100 + y}});
             }
             return page;
         }},
        {"line-width",
         [](double width) {
             Page page = blank_page();
             add_line(page, {{20, 50}, {120, 50}}, width);
             return page;
         }},
        {"line-widths",
         [](double count) {
             Page page = blank_page();
             for (int i = 0; i < static_cast<int>(count); ++i)
                 add_line(page, {{20, 20.0 + 10 * i}, {120, 20.0 + 10 * i}}, 1 + 0.2 * i);
             return page;
         }},
        {"line-length",
         [](double length) {
             Page page = blank_page();
             add_line(page, {{20, 50}, {20 + length - 1, 50}});
             return page;
         }},
        {"side-length",
         [](double side) {
             Page page = blank_page();
             add_line(page, rectangle(20, 20, side, 40), 1, true);
             return page;
         }},
        {"area-size",
         [](double size) {
             Page page = blank_page();
             page.areas.push_back({{rectangle(20, 20, size * 0.8, size * 0.6)}});
             return page;
         }},
        {"detail",
         [](double size) {
             Page page = blank_page();
             page.areas.push_back({{circle({50, 50}, size / 2)}});
             return page;
         }},
        {"textures",
         [](double count) {
             Page page = blank_page();
             for (int i = 0; i < static_cast<int>(count); ++i)
                 page.textured.push_back({{rectangle(20.0 * i, 20, 15, 15)}, i + 1});
             return page;
         }},
        {"texture-size",
         [](double size) {
             Page page = blank_page();
             page.textured.push_back({{rectangle(20, 20, 20, 60)}, 2});
             for (int i = 0; i < 10; ++i)
                 page.strokes.push_back(
                     {{{30, 30.0 + 3 * i}, {30 + size - 1, 30.0 + 3 * i}}, false, 1, Role::pattern});
             return page;
         }},
        {"texture-clearance",
         [](double apart) {
             Page page = blank_page();
             add_line(page, {{20, 50}, {120, 50}});
             for (int i = 0; i < 10; ++i)
                 page.strokes.push_back({{{30.0 + 3 * i, 51 + apart}, {30.0 + 3 * i, 80}}, false, 1, Role::pattern});
             return page;
         }},
        {"braille-clearance",
         [](double apart) {
             Page page = blank_page();
             page.braille.push_back(letters({50, 50}));
             add_line(page, {{20, 50 + 5 + 0.8 + apart + 0.5}, {120, 50 + 5 + 0.8 + apart + 0.5}});
             return page;
         }},
        {"braille-dots",
         [](double off) {
             Page page = blank_page();
             page.braille.push_back(letters({50, 50}));
             page.cell.dot_pitch = 2.5 + off;
             return page;
         }},
        {"braille-cells",
         [](double off) {
             Page page = blank_page();
             page.braille.push_back(letters({50, 50}));
             page.cell.cell_pitch = 6.0 - off;
             return page;
         }},
        {"braille-lines",
         [](double off) {
             Page page = blank_page();
             page.braille.push_back(letters({50, 50}));
             page.braille.push_back(letters({50, 60 - off}));
             return page;
         }},
        {"margin",
         [](double off) {
             Page page = blank_page();
             page.live = {10, 10, 180, 180};
             add_line(page, {{50, 50}, {190 + off, 60}});
             return page;
         }},
        {"paper", [](double square_cm) { return blank_page(100 * square_cm / 300, 300); }},
        {"ink", inked},
        {"ink-limit", inked},
    };
    return kPages;
}

TEST(EveryRule, HasAPageThatJustPassesAndOneThatJustFails) {
    for (const Rule* rule : rules()) {
        const auto page = pages().find(std::string(rule->name));
        ASSERT_NE(page, pages().end()) << rule->name << " has no pair of pages";
        const double step = rule->limit.type == Option::Type::whole ? 1 : 0.01;
        for (const Medium& medium : media()) {
            const auto limit = limit_of(*rule, medium);
            if (!limit) continue;
            const bool least = rule->limit.name == "least";
            const double passing = step == 1 ? *limit : *limit + (least ? step : -step),
                         failing = *limit + (least ? -step : step);
            const Demand demand{rule, *limit};
            const Page good = page->second(passing), bad = page->second(failing);
            EXPECT_TRUE(check_page(good, {&demand, 1})[0].findings.places.empty()) << rule->name << " for " << medium.name;
            const Findings found = check_page(bad, {&demand, 1})[0].findings;
            ASSERT_EQ(found.places.size(), 1u) << rule->name << " for " << medium.name;
            EXPECT_TRUE(found.complete);
            EXPECT_NEAR(found.places[0].measured, failing, 2e-3) << rule->name;
            EXPECT_FALSE(found.places[0].message.empty());
        }
    }
    EXPECT_EQ(pages().size(), rules().size()) << "there are pages for a rule that is not in the list";
}

TEST(EveryRule, SaysNothingAboutABlankPage) {
    const Page page = blank_page();
    for (const Medium& medium : media())
        for (const Verdict& verdict : check_page(page, demands_of(medium)))
            EXPECT_TRUE(verdict.findings.places.empty() && verdict.findings.complete) << verdict.demand.rule->name;
}

TEST(EveryRule, DescribesItself) {
    std::set<std::string_view> names;
    for (const Rule* rule : rules()) {
        EXPECT_TRUE(names.insert(rule->name).second) << rule->name;
        EXPECT_FALSE(rule->summary.empty() || rule->mend.empty() || rule->source.empty() || rule->check == nullptr) << rule->name;
        EXPECT_TRUE(rule->limit.name == "least" || rule->limit.name == "most") << rule->name;
        EXPECT_GE(rule->limit.fallback, rule->limit.min) << rule->name;
        EXPECT_LE(rule->limit.fallback, rule->limit.max) << rule->name;
        // The default is what swell paper asks for, if the rule is about it.
        if (const auto limit = limit_of(*rule, find_medium("swell", ""))) {
            EXPECT_EQ(*limit, rule->limit.fallback) << rule->name;
        }
        // Or --set could not tell them apart.
        EXPECT_EQ(find_filter(filters(), rule->name), nullptr) << rule->name;
        EXPECT_EQ(find_format(rule->name), nullptr) << rule->name;
    }
}

TEST(EveryRule, FindsTheSameOnAPageMovedAndMirrored) {
    Chance chance(7);
    for (int round = 0; round < 20; ++round) {
        Page page = blank_page(400, 400), moved = blank_page(400, 400);
        const auto mirror = [](const std::vector<Point>& points) {
            std::vector<Point> other;
            for (const Point& p : points) other.push_back({350 - p.y, p.x + 30});
            return other;
        };
        for (int i = 0; i < 12; ++i) {
            const auto line =
                wandering_line(chance, {chance.between(120, 200), chance.between(120, 200)}, 2 + chance.below(20), 6);
            add_line(page, line, 1);
            add_line(moved, mirror(line), 1);
        }
        for (int i = 0; i < 3; ++i) {
            const auto ring = starry_ring(chance, {chance.between(130, 190), chance.between(130, 190)}, 1, 12);
            page.areas.push_back({{ring}});
            moved.areas.push_back({{mirror(ring)}});
        }
        const auto measures = [](const Findings& findings) {
            std::vector<double> all;
            for (const Finding& finding : findings.places) all.push_back(finding.measured);
            std::sort(all.begin(), all.end());
            return all;
        };
        for (const std::string rule : {"gap", "crossings", "line-length", "side-length", "area-size", "detail", "ink"}) {
            const auto one = measures(findings_of(page, rule)), other = measures(findings_of(moved, rule));
            ASSERT_EQ(one.size(), other.size()) << rule << " round " << round;
            for (std::size_t i = 0; i < one.size(); ++i) EXPECT_NEAR(one[i], other[i], 1e-3) << rule;
        }
    }
}

// 100,000 lines on a page: every rule comes to an end, and says so if it was before the end of the page.
TEST(EveryRule, IsBoundedOnAVeryBusyPage) {
    Chance chance(3);
    Page page = blank_page(297, 420);
    for (int i = 0; i < 100'000; ++i)
        add_line(page, wandering_line(chance, {chance.between(10, 287), chance.between(10, 410)}, 3, 3), 0.2);
    for (int i = 0; i < 30; ++i) page.braille.push_back(letters({20, 20 + 12.0 * i}, 40));
    for (const Verdict& verdict : check_page(page, demands_of(find_medium("swell", "")))) {
        EXPECT_LE(verdict.findings.places.size(), kMostPlaces) << verdict.demand.rule->name;
        const bool gap = verdict.demand.rule->name == "gap", line_width = verdict.demand.rule->name == "line-width";
        EXPECT_FALSE(gap && verdict.findings.complete) << "the page is full of gaps, and only so many are told";
        EXPECT_FALSE(line_width && verdict.findings.places.size() != kMostPlaces);
    }
}

}  // namespace
}  // namespace tactics
