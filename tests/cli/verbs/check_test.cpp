// SPDX-License-Identifier: Apache-2.0
// `tactics check` as a person and as a script see it.
#include <gtest/gtest.h>

#include <algorithm>

#include "cli/help/catalogue.h"
#include "cli/verbs/check_page.h"
#include "tactics/rules/rule.h"
#include "tests/cli/picture.h"
#include "tests/cli/tool.h"

namespace tactics::check_test {
namespace {

using namespace tests;

std::size_t lines_in(const std::string& text) { return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')); }

std::string page(const std::string& body) {
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"210mm\" height=\"297mm\" viewBox=\"0 0 210 297\" fill=\"none\" "
           "stroke=\"#000\" "
           "stroke-linecap=\"round\">" +
           body + "</svg>";
}

// Two lines 2 mm apart from edge to edge.
std::string narrow_page() { return page("<path d=\"M20 50h100M20 53h100\"/>"); }
// That many of them, far from each other.
std::string many_gaps(int count) {
    std::string body;
    for (int i = 0; i < count; ++i) body += "<path d=\"M20 " + std::to_string(30 + 12 * i) + "h100m0 3h-100\"/>";
    return page(body);
}

TEST(Check, TellsOnALineWhereWhatAndHowToMendIt) {
    const Folder folder;
    write_bytes(folder / "page.svg", narrow_page());
    const Ending ending = run_tactics(folder, {"check", "page.svg"});
    EXPECT_EQ(ending.code, 0) << ending.err;
    EXPECT_EQ(ending.err, "");
    EXPECT_TRUE(ending.out.starts_with("page.svg: ")) << ending.out;
    EXPECT_TRUE(holds(
        ending.out,
        " mm right, 50.5 mm down: a gap of 2 mm between two lines, least is 3.2 mm; move them apart or join them (gap, hard)\n"))
        << ending.out;
    EXPECT_TRUE(ending.out.ends_with("page.svg: 1 place breaks a hard rule, 0 places break others; see tactics help check\n"))
        << ending.out;
    write_bytes(folder / "good.svg", page("<path d=\"M20 50h100M20 60h100\"/>"));
    EXPECT_EQ(run_tactics(folder, {"check", "good.svg"}).out, "good.svg: no rule is broken\n");
    EXPECT_EQ(
        run_tactics(folder, {"check", "-"}, page("")).out,
        "standard input: note: nothing on this page is to be felt: no line or area is darker than half grey; draw in black\n"
        "standard input: no rule is broken\n");
}

TEST(Check, EndsWith3OnlyIfStrictAndAHardRuleIsBroken) {
    const Folder folder;
    write_bytes(folder / "hard.svg", narrow_page());
    write_bytes(folder / "soft.svg", page("<path d=\"M20 50h5\"/>"));
    EXPECT_EQ(run_tactics(folder, {"check", "hard.svg"}).code, 0);
    EXPECT_EQ(run_tactics(folder, {"check", "hard.svg", "--strict"}).code, 3);
    const Ending soft = run_tactics(folder, {"check", "soft.svg", "--strict"});
    EXPECT_EQ(soft.code, 0);
    EXPECT_TRUE(holds(soft.out, "(line-length)\n")) << soft.out;
    EXPECT_EQ(run_tactics(folder, {"check", "soft.svg", "hard.svg", "--strict"}).code, 3);
    // What could not be read weighs more, and does not stop the others.
    const Ending missing = run_tactics(folder, {"check", "missing.svg", "hard.svg", "--strict"});
    EXPECT_EQ(missing.code, 2);
    EXPECT_TRUE(holds(missing.err, "missing.svg: ")) << missing.err;
    EXPECT_TRUE(holds(missing.out, "hard.svg: 1 place breaks a hard rule")) << missing.out;
}

TEST(Check, CountsWhatItDoesNotTell) {
    const Folder folder;
    write_bytes(folder / "page.svg", many_gaps(15));
    const std::string told = run_tactics(folder, {"check", "page.svg"}).out;
    EXPECT_EQ(lines_in(told), 12u) << told;
    EXPECT_TRUE(holds(told, "page.svg: and 5 more (gap, hard); --most all shows them\n")) << told;
    EXPECT_EQ(lines_in(run_tactics(folder, {"check", "page.svg", "--most", "all"}).out), 16u);
    EXPECT_EQ(lines_in(run_tactics(folder, {"check", "page.svg", "--most", "0"}).out), 2u);
}

TEST(Check, TakesLimitsMediaAndRulesOfTheUser) {
    const Folder folder;
    write_bytes(folder / "page.svg", narrow_page());
    const auto count = [&](std::vector<std::string> words) {
        words.insert(words.begin(), {"check", "page.svg", "--most", "0"});
        const Ending ending = run_tactics(folder, words);
        EXPECT_EQ(ending.code, 0) << ending.err;
        return lines_in(ending.out);  // a line a broken rule, and the last
    };
    EXPECT_EQ(count({}), 2u);
    EXPECT_EQ(count({"--set", "gap.least=1.5mm"}), 1u);
    EXPECT_EQ(count({"--set", "gap.least=0.05in"}), 1u);
    EXPECT_EQ(count({"--rule", "crossings"}), 1u);
    EXPECT_EQ(count({"--margin", "25mm"}), 3u);
    EXPECT_EQ(count({"--medium", "embosser"}), 4u) << "gap, merging dots, and lines thinner than a dot";
}

TEST(Check, RefusesWhatItDoesNotKnow) {
    const Folder folder;
    write_bytes(folder / "page.svg", narrow_page());
    const auto refusal = [&](std::vector<std::string> words) {
        words.insert(words.begin(), "check");
        const Ending ending = run_tactics(folder, words);
        EXPECT_EQ(ending.code, 1);
        EXPECT_EQ(ending.out, "");
        EXPECT_EQ(lines_in(ending.err), 1u) << ending.err;
        return ending.err;
    };
    EXPECT_EQ(refusal({}), "tactics: check: no page is named; for example: tactics check page.svg\n");
    EXPECT_EQ(refusal({"page.svg", "--rule", "gaps"}),
              "tactics: --rule: there is no rule \"gaps\" (gap?); see tactics list rules\n");
    EXPECT_EQ(refusal({"page.svg", "--set", "gap.most=3"}), "tactics: --set 1: gap has no setting \"most\"; it has least\n");
    EXPECT_TRUE(holds(refusal({"page.svg", "--set", "gap.least=500"}), "is out of range; it is 0.1 to 50 mm"));
    EXPECT_TRUE(holds(refusal({"page.svg", "--set", "nothing.least=5"}), "nothing"));
    EXPECT_TRUE(holds(refusal({"page.svg", "--rule", "gap", "--set", "paper.most=50"}), "would do nothing"));
    EXPECT_TRUE(holds(refusal({"page.svg", "--rule", "merging-dots"}), "is not about medium swell"));
    EXPECT_TRUE(holds(refusal({"page.svg", "--format", "xml"}), "it is text, json, sarif or junit"));
    EXPECT_TRUE(holds(refusal({"page.svg", "--most", "-1"}), "whole number"));
    EXPECT_TRUE(holds(refusal({"page.svg", "--mark", "marked.doc"}), ".svg, .png or .pdf"));
    EXPECT_TRUE(holds(refusal({"page.svg", "other.svg", "--mark", "m.svg"}), "one page"));
    EXPECT_TRUE(holds(refusal({"page.svg", "--mark", "./page.svg"}), "would replace the page itself"));
}

TEST(Check, TellsWhereAFileIsWrong) {
    const Folder folder;
    write_bytes(folder / "page.svg", "<svg width='10mm' height='10mm'>\n<g>\n</svg>");
    const Ending ending = run_tactics(folder, {"check", "page.svg"});
    EXPECT_EQ(ending.code, 2);
    EXPECT_TRUE(ending.err.starts_with("tactics: page.svg:3: this is not well-formed XML (mismatched tag, column "))
        << ending.err;
    write_bytes(folder / "empty.svg", "");
    EXPECT_EQ(run_tactics(folder, {"check", "empty.svg"}).code, 2);
    EXPECT_EQ(run_tactics(folder, {"check", "."}).code, 2);
}

// The place of a gap as JSON, SARIF and JUnit have it, read by Python.
TEST(Check, SpeaksToPrograms) {
    if (!has_tool("python3")) GTEST_SKIP() << "python3 is missing";
    const Folder folder;
    write_bytes(folder / "a <b>&\".svg", many_gaps(15));
    write_bytes(folder / "good.svg", page(""));
    const Words files = {"a <b>&\".svg", "good.svg", "missing.svg"};
    const auto read_with = [&](const std::string& format, const std::string& script) {
        Words words = {"check", "--format", format};
        words.insert(words.end(), files.begin(), files.end());
        const Ending ending = run_tactics(folder, words);
        EXPECT_EQ(ending.code, 2);
        write_bytes(folder / "read.py", script);
        const Ending python = run_tool(folder, {"python3", "read.py"}, ending.out);
        EXPECT_EQ(python.code, 0) << format << python.err;
    };
    read_with(
        "json",
        "import sys, json\n"
        "a, good, missing = map(json.loads, sys.stdin)\n"
        "assert a['file'] == 'a <b>&\".svg' and a['hard'] == 15 and a['others'] == 0 and a['page_width_mm'] == 210, a\n"
        "gap = next(r for r in a['rules'] if r['rule'] == 'gap')\n"
        "assert gap['hard'] and gap['least'] == 3.2 and gap['unit'] == 'mm' and gap['complete'] and len(gap['findings']) == 15\n"
        "first = gap['findings'][0]\n"
        "assert abs(first['measured'] - 2) < 1e-6 and abs(first['y_mm'] - 30.5) < 1e-6 and abs(first['other_y_mm'] - 32.5) < "
        "1e-6\n"
        "assert good['hard'] == 0 and 'missing.svg' in missing['error']\n");
    read_with("sarif",
              "import sys, json\n"
              "log = json.load(sys.stdin)\n"
              "run = log['runs'][0]\n"
              "ids = [r['id'] for r in run['tool']['driver']['rules']]\n"
              "assert log['version'] == '2.1.0' and 'gap' in ids and len(ids) == len(set(ids))\n"
              "assert len(run['results']) == 15\n"
              "for r in run['results']:\n"
              "    assert r['ruleId'] == 'gap' and r['level'] == 'error' and 'a gap of 2 mm' in r['message']['text']\n"
              "    assert r['locations'][0]['physicalLocation']['artifactLocation']['uri'] == 'a%20%3Cb%3E%26%22.svg'\n"
              "call = run['invocations'][0]\n"
              "assert call['executionSuccessful'] is False and 'missing.svg' in "
              "call['toolExecutionNotifications'][0]['message']['text']\n");
    read_with(
        "junit",
        "import sys\n"
        "import xml.etree.ElementTree as tree\n"
        "suites = tree.fromstring(sys.stdin.buffer.read()).findall('testsuite')\n"
        "assert [s.get('failures') for s in suites] == ['1', '0', '0'] and [s.get('errors') for s in suites] == ['0', '0', '1']\n"
        "assert suites[0].get('name') == 'a <b>&\".svg'\n"
        "for s in suites: assert len(s.findall('testcase')) == int(s.get('tests'))\n"
        "assert suites[0].find('testcase[@name=\"gap\"]/failure').text.count('a gap of 2 mm') == 15\n");
    EXPECT_EQ(run_tactics(folder, {"check", "--json", "good.svg"}).out,
              run_tactics(folder, {"check", "--format", "json", "good.svg"}).out);
}

TEST(Check, MarksThePlaces) {
    const Folder folder;
    write_bytes(folder / "page.svg", many_gaps(12));
    const std::string told = run_tactics(folder, {"check", "page.svg", "--mark", "marked.svg"}).out;
    EXPECT_TRUE(holds(told, "page.svg: mark 10: ")) << told;
    const std::string svg = bytes_of(folder / "marked.svg");
    std::size_t rings = 0;
    for (auto at = svg.find("stroke=\"#d00\""); at != std::string::npos; at = svg.find("stroke=\"#d00\"", at + 1)) ++rings;
    EXPECT_EQ(rings, 10u);
    EXPECT_TRUE(holds(svg, "cy=\"31.5\"")) << "the middle of the first gap";
    EXPECT_TRUE(holds(svg, "<g id=\"marks\""));
    EXPECT_EQ(run_tactics(folder, {"check", "page.svg", "--mark", "marked.png"}).code, 0);
    EXPECT_TRUE(bytes_of(folder / "marked.png").starts_with("\x89PNG"));
}

// A page in the formats that check reads is the same page, to a hundredth of a millimetre: a PDF of anybody's, as this one is
// once something stands behind its end.
TEST(Check, ReadsTheSameFromPdfAndSvg) {
    if (!has_tool("pdftocairo")) GTEST_SKIP() << "pdftocairo is missing";
    const Folder folder;
    write_bytes(folder / "disc.tiff", disc_picture());
    ASSERT_EQ(run_tactics(folder, {"convert", "disc.tiff", "-o", "page.svg", "-o", "page.pdf", "--filter", "sobel", "--filter",
                                   "threshold", "--filter", "trace", "--title", "A disc of no size"})
                  .code,
              0);
    const std::string as_written = bytes_of(folder / "page.pdf");
    write_bytes(folder / "ours.pdf", as_written);
    write_bytes(folder / "page.pdf", as_written + "%\n");
    PageWish wish;
    wish.medium = &find_medium("swell", "");
    const Page svg = page_of(folder / "page.svg", wish).page, pdf = page_of(folder / "page.pdf", wish).page;
    EXPECT_NEAR(pdf.width, svg.width, 1e-3);
    ASSERT_GT(svg.strokes.size(), 0u);
    ASSERT_EQ(pdf.strokes.size(), svg.strokes.size());
    const Page ours = page_of(folder / "ours.pdf", wish).page;
    ASSERT_EQ(ours.strokes.size(), svg.strokes.size());
    EXPECT_EQ(distance(ours.strokes[0].points[0], svg.strokes[0].points[0]), 0);
    EXPECT_EQ(ours.title, "A disc of no size") << "which only its SVG tells";
    for (std::size_t i = 0; i < svg.strokes.size(); ++i) {
        EXPECT_NEAR(pdf.strokes[i].width, svg.strokes[i].width, 1e-3);
        ASSERT_EQ(pdf.strokes[i].points.size(), svg.strokes[i].points.size());
        for (std::size_t k = 0; k < svg.strokes[i].points.size(); ++k)
            EXPECT_NEAR(distance(pdf.strokes[i].points[k], svg.strokes[i].points[k]), 0, 0.01);
    }
    ASSERT_EQ(pdf.braille.size(), 1u);
    EXPECT_EQ(pdf.braille[0].cells, svg.braille.at(0).cells);
    EXPECT_NEAR(distance(pdf.braille[0].first_dot, svg.braille[0].first_dot), 0, 0.01);
    write_bytes(folder / "broken.pdf", "%PDF-1.4\nthis is none");
    EXPECT_TRUE(holds(run_tactics(folder, {"check", "broken.pdf"}).err, "pdftocairo cannot read this PDF"));
    const Ending none = run_tool(folder, {"env", "PATH=", TACTICS_PROGRAM, "check", "page.pdf"});
    EXPECT_EQ(none.code, 2);
    EXPECT_TRUE(holds(none.err, "install poppler-utils")) << none.err;
}

TEST(Check, TakesAPictureAsConvertWouldDrawIt) {
    const Folder folder;
    write_bytes(folder / "disc.tiff", disc_picture());
    const Ending ending =
        run_tactics(folder, {"check", "disc.tiff", "--recipe", "photo", "--set", "outlines.line=300mm", "--json"});
    EXPECT_EQ(ending.code, 0) << ending.err;
    EXPECT_TRUE(holds(ending.out, "recipe photo, medium swell")) << ending.out;
    EXPECT_FALSE(holds(ending.out, "\"strokes\":0,")) << ending.out;
}

TEST(Check, RulesAreListedAndExplained) {
    const Folder folder;
    EXPECT_EQ(find_group("rules")->entries().size(), rules().size());
    for (const Rule* rule : rules()) {
        const std::string name(rule->name), help = run_tactics(folder, {"help", name}).out;
        EXPECT_TRUE(holds(help, "Source: " + std::string(rule->source)) && holds(help, "Confidence in the number: ")) << help;
        EXPECT_EQ(holds(help, "Treat it as a hint"), rule->confidence != Confidence::good) << help;
        // Its example is one that can be typed.
        const auto from = help.find("tactics check ");
        ASSERT_NE(from, std::string::npos);
        write_bytes(folder / "page.svg", page(""));
        const Ending typed = run_tool(folder, {"sh", "-c", std::string(TACTICS_PROGRAM) + help.substr(from + 7)});
        EXPECT_EQ(typed.code, 0) << typed.err;
    }
}

}  // namespace
}  // namespace tactics::check_test
