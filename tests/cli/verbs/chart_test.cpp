// SPDX-License-Identifier: Apache-2.0
// `tactics chart` as the user meets it: a table of figures becomes a page.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <map>
#include <random>

#include "tests/cli/tool.h"
#include "tests/patterns.h"

namespace tactics::chart_test {
namespace {

using namespace tests;

struct At {
    double x = 0, y = 0;
};

class ChartCommand : public testing::Test {
protected:
    Ending chart(const std::string& csv, Words words) {
        words.insert(words.begin(), {"chart", "-"});
        return run_tactics(folder, words, csv);
    }
    /// The page of these figures, words in print only.
    std::string svg(const std::string& csv, Words words = {}) {
        words.insert(words.end(), {"-o", "svg:-", "--braille", "none"});
        const Ending ending = chart(csv, words);
        EXPECT_EQ(ending.code, 0) << ending.err;
        return ending.out;
    }
    /// Where paths of that kind begin.
    static std::vector<At> begins(const std::string& svg, const std::string& kind) {
        std::vector<At> places;
        for (const tests::Fit& path : tests::all_fits(svg, kind + "[^>]* d=\"M([-0-9.]+) ([-0-9.]+)"))
            places.push_back({std::stod(path[1]), std::stod(path[2])});
        return places;
    }
    static bool shows(const std::string& svg, const std::string& words) { return holds(svg, ">" + words + "</text>"); }
    Folder folder;
};

TEST_F(ChartCommand, PutsRowsWhereTheyBelong) {
    const std::vector<At> discs =
        begins(svg("a (m),b\n1,30\n10,20\n100,10\n", {"--points", "--log-x"}), "class=\"tactics-symbol\"");
    ASSERT_EQ(discs.size(), 3u);
    std::map<double, double> placed;
    for (const At& disc : discs) placed[disc.x] = disc.y;
    std::vector<At> sorted;
    for (const auto& [x, y] : placed) sorted.push_back({x, y});
    ASSERT_EQ(sorted.size(), 3u);
    EXPECT_NEAR(sorted[1].x - sorted[0].x, sorted[2].x - sorted[1].x, 0.02) << "1, 10, 100 are equally far apart";
    EXPECT_NEAR(sorted[1].y - sorted[0].y, sorted[2].y - sorted[1].y, 0.02);
    EXPECT_GT(sorted[2].y, sorted[0].y) << "less is lower";
    const std::vector<At> linear = begins(svg("a (m),b\n1,30\n10,20\n100,10\n", {"--points"}), "class=\"tactics-symbol\"");
    ASSERT_EQ(linear.size(), 3u);
    EXPECT_NEAR(std::abs(linear[2].x - linear[1].x) / std::abs(linear[1].x - linear[0].x), 10, 0.1);
}

// Where the ticks that are left lie too close for their words, two of closer ticks lie farther apart.
TEST_F(ChartCommand, HasRoomForDates) {
    for (const std::string ends : {"2024-01-15,2024-03-15", "2024-01-31,2024-02-01", "2024-02-10,2024-06-20",
                                   "2023-12-31,2025-01-01", "2024-03-01,2024-03-08", "1999-07-04,2024-07-04"})
        for (const std::string language : {"en", "de", "fr"}) {
            const Ending made = chart("day,level\n" + ends.substr(0, 10) + ",1\n" + ends.substr(11) + ",2\n",
                                      {"--language", language, "-o", "svg:-"});
            ASSERT_EQ(made.code, 0) << ends << language << made.err;
            EXPECT_EQ(run_tactics(folder, {"check", "-", "--strict"}, made.out).code, 0) << ends << language;
        }
}

// No span of days is refused on A4, however it is turned, and its words keep apart and out of the margin.
TEST_F(ChartCommand, DrawsAnySpanOfDays) {
    using std::chrono::sys_days;
    std::mt19937 random(23);
    const auto text = [](sys_days at) {
        const std::chrono::year_month_day date(at);
        char words[16];
        std::snprintf(words, sizeof words, "%04d-%02u-%02u", int{date.year()}, unsigned{date.month()}, unsigned{date.day()});
        return std::string(words);
    };
    int turned = 0;
    for (int round = 0; round < 24; ++round) {
        const sys_days first = sys_days(std::chrono::year(2015) / 1 / 1) + std::chrono::days(random() % 4000);
        // From 10 days to a year: the spans of which few round values have room.
        const sys_days last = first + std::chrono::days(std::lround(10 * std::pow(1.17, round)));
        const std::string csv = "day,level\n" + text(first) + ",1\n" + text(last) + ",2\n";
        for (const std::string way : {"auto", "portrait", "landscape"}) {
            const Ending made = chart(csv, {"--orientation", way, "-o", "svg:-"});
            ASSERT_EQ(made.code, 0) << csv << way << made.err;
            EXPECT_EQ(run_tactics(folder, {"check", "-", "--strict"}, made.out).code, 0) << csv << way;
            turned += way == "auto" && holds(made.out, "width=\"297mm\"") ? 1 : 0;
        }
    }
    EXPECT_GT(turned, 0) << "where upright paper has no room for round values";
    EXPECT_LT(turned, 24);
}

TEST_F(ChartCommand, NamesAxesCurvesAndMarks) {
    const std::string page =
        svg("method,tool,time (s),F,note\n,new,1,0.5,\nbest,new,2,0.625,x\n,old,1,0.25,\n,old,2,0.375,\n,other,1.5,0.3,\n",
            {"--group", "tool", "--label", "method", "--caption", "Times"});
    for (const char* words : {"F against time", "time (s)", "F", "new", "old", "a best", "b other", "a", "b", "Times"})
        EXPECT_TRUE(shows(page, words)) << words;
    EXPECT_FALSE(shows(page, "c"));
    const std::string six =
        svg("g,x,y\na,0,1\na,9,1\nb,0,2\nb,9,2\nc,0,3\nc,9,3\nd,0,4\nd,9,4\ne,0,5\ne,9,5\nf,0,6\nf,9,6\n", {"--group", "g"});
    EXPECT_TRUE(shows(six, "f f") && shows(six, "f")) << "more curves than kinds of lines have letters";
    EXPECT_TRUE(shows(svg("2019,2020\n1,2\n2,3\n", {"--x", "2019", "--y", "2020"}), "2020 against 2019"))
        << "years that were named";
    EXPECT_TRUE(shows(svg("month,2020\n1,2\n2,3\n"), "2020 against month"));
    const std::string other = svg("a,b,c\n1,2,3\n2,3,1\n", {"--x", "c", "--y", "a", "--title", "Mine"});
    for (const char* words : {"Mine", "c", "a"}) EXPECT_TRUE(shows(other, words)) << words;
    EXPECT_FALSE(shows(other, "b"));
}

TEST_F(ChartCommand, TakesTablesAsTheyAreWritten) {
    const std::string plain = svg("a,b\n1,2\n2,5\n");
    for (const char* same : {"\xEF\xBB\xBF"
                             "a,b\r\n1,2\r\n\r\n2,5",
                             "a\tb\n1\t2\n2\t5\n", "a;b\n1;2\n2;5\n", "\"a\", \"b\"\n 1 ,\"2\"\n2,5\n\n"})
        EXPECT_EQ(svg(same), plain) << same;
    EXPECT_TRUE(shows(svg("n,\"a, \"\"b\"\" (mm)\",b\nx,1,2\nx,2,5\n"), "a, &quot;b&quot; (mm)"));
    write_bytes(folder / "t.csv", "a,b\n1,2\n2,5\n");
    const Ending ending = run_tactics(folder, {"chart", "t.csv", "-o", "t.pdf", "-o", "t.brf"});
    EXPECT_EQ(ending.code, 0) << ending.err;
    EXPECT_TRUE(bytes_of(folder / "t.pdf").starts_with("%PDF"));
    EXPECT_TRUE(bytes_of(folder / "t.brf").ends_with("\f"));
    const Ending gaps = chart("a,b\n1,2\n,3\n2,5\n", {"-o", "svg:-", "--braille", "none"});
    EXPECT_EQ(gaps.out, plain);
    EXPECT_TRUE(holds(gaps.err, "1 row has no number for the chart and is left out")) << gaps.err;
}

// convert, check and describe take a table as they take a picture; chart says more of its columns.
TEST_F(ChartCommand, ATableIsASourceLikeAnyOther) {
    write_bytes(folder / "t.csv", "a,b\n1,2\n2,5\n,3\n");
    ASSERT_EQ(run_tactics(folder, {"chart", "t.csv", "-o", "chart.pdf", "-o", "chart.brf", "-q"}).code, 0);
    const Ending made = run_tactics(folder, {"convert", "t.csv", "-o", "page.pdf", "-o", "page.brf", "-r", "photo"});
    ASSERT_EQ(made.code, 0) << made.err;
    EXPECT_TRUE(holds(made.err, "t.csv: 1 row has no number for the chart and is left out")) << made.err;
    EXPECT_TRUE(holds(made.err, "t.csv: it is a table, so --recipe, --filter, --detail")) << made.err;
    for (const char* end : {".pdf", ".brf"})
        EXPECT_EQ(bytes_of(folder / ("page" + std::string(end))), bytes_of(folder / ("chart" + std::string(end)))) << end;
    const Ending checked = run_tactics(folder, {"check", "t.csv"});
    EXPECT_EQ(checked.code, 0) << checked.err;
    EXPECT_TRUE(holds(checked.out + checked.err, "this is a table, checked as convert would draw it (medium swell)"))
        << checked.out;
    EXPECT_TRUE(holds(run_tactics(folder, {"describe", "t.csv"}).out, "Title: b against a."));
    const Ending bare = run_tactics(folder, {"convert", "t.csv", "--bare", "-o", "bare.png", "--json"});
    EXPECT_EQ(bare.code, 0) << bare.err;
    EXPECT_GT(bytes_of(folder / "bare.png").size(), 1000u);
}

TEST_F(ChartCommand, SaysWhatIsWrongAndWhere) {
    const auto refused = [&](const std::string& csv, const Words& more, int code, std::string_view told) {
        Words words{"-o", "c.svg"};
        words.insert(words.end(), more.begin(), more.end());
        const Ending ending = chart(csv, words);
        EXPECT_EQ(ending.code, code) << csv;
        EXPECT_TRUE(holds(ending.err, told)) << ending.err;
        EXPECT_EQ(std::count(ending.err.begin(), ending.err.end(), '\n'), 1) << ending.err;
        EXPECT_FALSE(std::filesystem::exists(folder / "c.svg"));
    };
    const std::string good = "a,b,c\n1,2,x\n2,5,y\n";
    refused(good, {"--x", "aa"}, 1, "--x: standard input has no column \"aa\"");
    refused(good, {"--x", "aa"}, 1, "it has \"a\", \"b\", \"c\"");
    refused(good, {"--y", "c"}, 2, "standard input:2: c is \"x\", which is no number");
    refused("a,b\nx,y\n", {}, 1, "--x: standard input has no column of numbers for it");
    refused("t;s\n1.5;2,5\n", {}, 2, "standard input:2: there is \"2,5\", and \"1.5\" in line 2; write all numbers with a point");
    refused("t;s\n1;2\n2;2,5\n", {"--decimal", "point"}, 2,
            "standard input:3: s is \"2,5\", which is no number; write a point and no comma: 2.5");
    refused("t;s\n1;2,512\n", {}, 2, "standard input:2: \"2,512\" may be 2.512 or a whole number; say --decimal comma");
    refused("t;s\n1;2,512\n", {"--decimal", "point"}, 2, "s is \"2,512\", with a mark between thousands; write it without: 2512");
    refused("t;s\n1,5;1.234,5\n", {}, 2, "s is \"1.234,5\", with a mark between thousands; write it without: 1234,5");
    refused("t;s\n1.5;1,234,567.25\n", {"--y", "s"}, 2, "with a mark between thousands; write it without: 1234567.25");
    refused("a,b\n1,2\n2,inf\n", {}, 2, "standard input:3: b is \"inf\", which no axis reaches");
    refused("a,b\n1.2.2024,2\n2.3.2024,3\n", {}, 2, "standard input:3: is \"2.3.2024\" day.month or month/day?");
    refused("a,b\n2024-04-30,2\n2024-04-31,3\n", {}, 2, "standard input:3: a is \"2024-04-31\", and there is no such day");
    refused("a,b\n1400-04-30,2\n", {}, 2, "our calendar began on 15 October 1582");
    refused("a,b\n1,2\n", {"--dates", "YDM"}, 1, "--dates: it cannot be \"YDM\"");
    refused("a,b\n2024-04-30,2\n", {"--log-x"}, 1, "--log-x: a has dates");
    refused("a,b\n1,2\n", {"--points", "--steps"}, 1, "--steps: points are not joined");
    refused(
        "\xFF\xFE"
        "a",
        {}, 2, "it is text in UTF-16");
    refused("a;b\n1;2,5,5\n", {"--y", "b"}, 2, "standard input:2: b is \"2,5,5\", which is no number; write it like 0.53");
    refused("1;30,5\n2;20.5\n", {}, 2, "write all numbers with a point, or all with a comma");
    refused("1,30,p\n10,20,q\n", {}, 2, "there is \"1\" and \"30\", which are numbers");
    // A long word is cut at whole letters.
    std::string word = "a";
    while (word.size() < 1000) word += "\u00E4";
    refused("a,b\n1," + word + "\n", {"--y", "b"}, 2, "b is \"" + word.substr(0, 79) + "...\", which is no number");
    refused("a," + word + "\n1,x\n", {"--y", word}, 2, word.substr(0, 79) + "... is \"x\"");
    refused("a,b" + word + "\n1,2\n", {"--y", "z"}, 1, "it has \"a\", \"b" + word.substr(0, 79) + "...\"");
    std::string many;
    for (int i = 0; i < 200; ++i) many += (i > 0 ? ",column " : "column ") + std::to_string(i);
    refused(many + "\n1" + std::string(199, ',') + "\n", {"--y", "z"}, 1, "\", ...\n");
    refused("a,b\n1,2\n3\n", {}, 2, "standard input:3: there are 1 values for 2 columns");
    refused("a,b\n1,2\n\"3,4\n", {}, 2, "standard input:3: a quote is not closed");
    refused("a,b\n1,\"2\"3\n", {}, 2, "standard input:2: something stands between");
    refused("a,a\n1,2\n", {}, 2, "standard input:1: two columns are called \"a\"");
    refused("a,b\n0,2\n1,3\n", {"--log-x"}, 2, "standard input:2: a is \"0\", and a logarithmic axis");
    refused("a,b\n1,1e300\n", {}, 2, "standard input:2: b is \"1e300\", too large");
    refused("a,b\n1,1e-7\n2,2e-7\n", {}, 2, "the numbers of b are too small");
    refused("a,b\n", {}, 2, "the table has names of columns and no rows");
    refused("\n\n", {}, 2, "there is no line in it");
    refused("", {}, 2, "standard input: ");
    refused("a,b,c\n1,1,p\n2,2,q\n3,3,r\n", {"--points", "--group", "c"}, 1, "--points: a finger tells two groups");
    refused(good, {"--view", "front"}, 1, "--view: it cannot be \"front\"");
    refused(good, {"--levels", "2"}, 1, "--levels: it cannot be \"2\"; it is auto, or a whole number from 3 to 20");
    refused(good, {"--section", "2"}, 1, "--section: it cannot be \"2\"; it is an axis with values");
    refused(good, {"--section", "x=1,y=2"}, 1, "--section: sections at x and at y do not share axes");
    refused(good, {"--section", "x=1", "--view", "contours"}, 1, "--section: only --view sections has them");
    refused(good, {"--levels", "5", "--view", "sections"}, 1, "--levels: only --view contours has them");
    refused(good, {"-o", "set/"}, 1, "this is a folder");
    refused(good, {"--paper", "100x90mm"}, 1, "the chart does not fit on this paper");
    refused(std::string(2'000'000, 'a'), {}, 2, "standard input:1: the line is longer than 1048576 bytes");
    EXPECT_TRUE(holds(run_tactics(folder, {"chart", "t.csv"}).err, "say where to write it: -o chart.pdf"));
    EXPECT_TRUE(holds(run_tactics(folder, {"chart", "none.csv", "-o", "c.svg"}).err, "none.csv: "));
}

// The same page for every notation of the file.
TEST_F(ChartCommand, TheSameDataAreTheSamePageHoweverTheyAreWritten) {
    const std::string plain = svg("t (s),F\n1.5,2\n2.5,5.25\n4,NaN\n5,3\n6.5,2.5\n");
    for (const char* same :
         {"t (s);F\n1,5;2\n2,5;5,25\n4;\n5;3\n6,5;2,5\n", "t (s)\tF\n1,5\t2\n2,5\t5,25\n4\t-\n5\t3\n6,5\t2,5\n",
          "\"t (s)\",F\n\"1,5\",2\n\"2,5\",\"5,25\"\n4,N/A\n5,3\n\"6,5\",\"2,5\"\n",
          "# made by hand\n\"t (s)\" F\n1.5 2\n 2.5  5.25\n4 nan\n5 3 \n6.5 2.5\n# end\n",
          "\"t (s)\" \"F\"\n\"1\" 1.5 2\n\"2\" 2.5 5.25\n\"3\" 4 NA\n\"4\" 5 3\n\"5\" 6.5 2.5\n"})
        EXPECT_EQ(svg(same, {"--x", "t (s)", "--y", "F"}), plain) << same;
}

TEST_F(ChartCommand, AMillionRowsAreAPage) {
    std::string csv = "a,b\n";
    for (int i = 0; i < 1'000'000; ++i) csv += std::to_string(i) + "," + std::to_string(i / 1000 % 70) + "\n";
    const Ending ending = chart(csv, {"-o", "c.svg", "--braille", "none"});
    EXPECT_EQ(ending.code, 0) << ending.err;
    EXPECT_LT(bytes_of(folder / "c.svg").size(), 500'000u);
    EXPECT_TRUE(
        holds(chart(csv, {"-o", "c.svg", "--points"}).err, "there are more than 10000 points to be marked; keep every tenth"));
}

TEST_F(ChartCommand, BarsAreNamedAndWriteNumbersAsTheLanguageDoes) {
    const std::string table = "town,rain (mm)\nBonn,1.5\nTrier,2\n";
    const std::string page = svg(table, {"--bars", "grouped"});
    for (const char* words : {"Bonn", "Trier", "1.5", "rain (mm)", "town", "rain by town"})
        EXPECT_TRUE(shows(page, words)) << words;
    const std::string german = svg(table, {"--bars", "grouped", "--language", "de"});
    EXPECT_TRUE(shows(german, "1,5"));
    EXPECT_FALSE(shows(german, "1.5"));
    EXPECT_TRUE(holds(german, "lang=\"de\""));
    EXPECT_EQ(chart(table, {"--bars", "round", "-o", "svg:-"}).code, 1);
    EXPECT_EQ(chart(table, {"--error", "rain", "-o", "svg:-"}).code, 1) << "errors are of bars";
}

TEST_F(ChartCommand, JsonSaysWhatIsDrawnAndWhere) {
    const Ending bars = chart("n,v,w\na,1,2\nb,,-4\n", {"--bars", "grouped", "-o", "svg:x.svg", "--json"});
    ASSERT_EQ(bars.code, 0) << bars.err;
    EXPECT_EQ(bars.err, "");
    EXPECT_TRUE(holds(bars.out, R"("bars":{"direction":"upright","stacked":false,"categories":["a","b"],"series":[)"
                                R"({"name":"v","values":[1,null]},{"name":"w","values":[2,-4]}]})"))
        << bars.out;
    EXPECT_TRUE(holds(bars.out, R"("x":{"name":"n"},"y":{"name":"","low":-4,)")) << bars.out;
    const Ending curve = chart("t,v\n0,1\n10,3\n", {"-o", "svg:x.svg", "--json"});
    ASSERT_EQ(curve.code, 0) << curve.err;
    EXPECT_TRUE(holds(curve.out, R"("curves":[{"name":"","joined":"straight","points":[[0,1],[10,3]]}])")) << curve.out;
    // The axes' places are those of the page: the curve's first point in the file is where they say.
    const auto number = [&](const std::string& axis, const std::string& member) {
        const auto at = curve.out.find("\"" + member + "\":", curve.out.find("\"" + axis + "\":{")) + member.size() + 3;
        return std::stod(curve.out.substr(at));
    };
    const std::vector<At> line = begins(run_tactics(folder, {"chart", "-", "-o", "svg:-", "-q"}, "t,v\n0,1\n10,3\n").out,
                                        "<path data-tactics-n=\"[0-9]+\" stroke-width=\"1\"");
    ASSERT_EQ(line.size(), 1u);
    EXPECT_NEAR(line[0].x, number("x", "from"), 0.02);
    EXPECT_NEAR(line[0].y, number("y", "from"), 0.02);
    EXPECT_EQ(chart("t,v\n0,1\n10,3\n", {"-o", "svg:-", "--json"}).code, 1) << "both would stand on standard output";
}

}  // namespace
}  // namespace tactics::chart_test
