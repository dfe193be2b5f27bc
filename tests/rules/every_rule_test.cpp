// SPDX-License-Identifier: Apache-2.0
// For every rule a page that just passes and one that just fails. A rule without such a pair fails here.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "filters/list.h"
#include "print/format.h"
#include "tactics/error.h"
#include "tactics/readers/svg/svg.h"
#include "tests/rules/pages.h"
#include "tests/rules/rule_pages.h"

namespace tactics::every_rule_test {
namespace {

using namespace tests;

TEST(RulePages, AreForTheRulesOfTheList) {
    EXPECT_EQ(rule_pages().size(), rules().size());
    for (const auto& [name, page] : rule_pages()) EXPECT_NE(find_rule(name), nullptr) << name;
}

TEST(EveryRule, HasAPageThatJustPassesAndOneThatJustFails) {
    for (const Rule* rule : rules()) {
        const auto page = rule_pages().find(std::string(rule->name));
        ASSERT_NE(page, rule_pages().end()) << rule->name << " has no pair of pages";
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
            EXPECT_FALSE(found.places[0].message.english().empty());
        }
    }
}

// Written down, a page breaks the rule as much as before: what its lines are for and what its braille says is written, too. Not
// so its margins.
TEST(EveryRule, FindsTheSameInTheFileOfItsPage) {
    const Format& svg = *find_format("svg");
    const Medium& medium = find_medium("swell", "");
    for (const Rule* rule : rules()) {
        const auto limit = limit_of(*rule, medium);
        if (!limit || rule->name == "margin") continue;
        const bool least = rule->limit.name == "least", whole = rule->limit.type == Option::Type::whole;
        const double step = whole ? 1 : rule->limit.unit == "mm" ? 0.05 : std::max(0.02, *limit / 100);
        for (const bool passes : {true, false}) {
            const Page page =
                rule_pages().at(std::string(rule->name))(whole && passes ? *limit : *limit + (least == passes ? step : -step));
            const Page read = read_svg(svg.encode(page, Settings(svg.options)), "page.svg", 0, std::nullopt).page;
            EXPECT_EQ(findings_of(read, std::string(rule->name), *limit).places.size(), passes ? 0u : 1u) << rule->name;
        }
    }
}

// A file of another maker does not say what its lines are for: rules that must know are silent.
TEST(EveryRule, SaysNothingOfRolesThatNobodyTells) {
    for (const std::string rule : {"dash-length", "dash-gaps", "symbol-size", "symbol-gap", "arrow-gap", "lead-width",
                                   "short-leads", "lead-arrows", "tick-length", "tick-sides"}) {
        const Rule& asked = *find_rule(rule);
        Page page = rule_pages().at(rule)(asked.limit.fallback + (asked.limit.name == "least" ? -1 : 1));
        EXPECT_FALSE(findings_of(page, rule).places.empty()) << rule;
        for (PageStroke& stroke : page.strokes) stroke.role = Role::line;
        for (Area& area : page.areas) area.role = Role::line;
        EXPECT_TRUE(findings_of(page, rule).places.empty()) << rule;
    }
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
        EXPECT_FALSE(rule->summary.empty() || rule->mend.text.empty() || rule->source.empty() || rule->check == nullptr)
            << rule->name;
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
    Dice chance(7);
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
    Dice chance(3);
    Page page = blank_page(297, 420);
    for (int i = 0; i < 100'000; ++i)
        add_line(page, wandering_line(chance, {chance.between(10, 287), chance.between(10, 410)}, 3, 3), 0.2);
    for (std::size_t i = 0; i < page.strokes.size(); ++i)
        page.strokes[i].role = i % 2 == 0 ? Role::line : static_cast<Role>(i / 2 % 7);
    for (int i = 0; i < 30; ++i) page.braille.push_back({{20, 20 + 12.0 * i}, std::vector<std::uint8_t>(40, 0x3f)});
    for (const Verdict& verdict : check_page(page, demands_of(find_medium("swell", "")))) {
        EXPECT_LE(verdict.findings.places.size(), kMostPlaces) << verdict.demand.rule->name;
        const bool gap = verdict.demand.rule->name == "gap", line_width = verdict.demand.rule->name == "line-width";
        EXPECT_FALSE(gap && verdict.findings.complete) << "the page is full of gaps, and only so many are told";
        EXPECT_FALSE(line_width && verdict.findings.places.size() != kMostPlaces);
    }
}

}  // namespace
}  // namespace tactics::every_rule_test
