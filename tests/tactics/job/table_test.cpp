// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <sstream>
#include <string>

#include "tactics/error.h"
#include "tactics/job/table_histogram.h"
#include "tactics/job/table_surface.h"
#include "tests/cli/tool.h"

namespace tactics::table_test {
namespace {

struct Read {
    Plot plot;
    std::vector<Phrase> notes;
};

Read read(std::string_view text, const TableWish& wish = {}) {
    Source source = memory_source({reinterpret_cast<const unsigned char*>(text.data()), text.size()}, "t");
    Read result;
    result.plot = plot_of(source, wish, result.notes);
    return result;
}

std::string refusal(std::string_view text, const TableWish& wish = {}) {
    try {
        read(text, wish);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

/// All that is in a plot, as text.
std::string told(const Plot& plot) {
    std::ostringstream text;
    text.precision(17);
    text << plot.title << "|" << plot.x.name << "|" << plot.y.name << "|" << plot.z.name;
    for (const PlotCurve& curve : plot.curves) {
        text << "\ncurve " << curve.name;
        for (std::size_t i = 0, gap = 0; i < curve.points.size(); ++i) {
            if (gap < curve.gaps.size() && curve.gaps[gap] == i) text << " gap", ++gap;
            text << " (" << curve.points[i].x << " " << curve.points[i].y << ")";
        }
    }
    for (const PlotMark& mark : plot.marks) text << "\nmark " << mark.name << " " << mark.x << " " << mark.y << " " << mark.z;
    for (const PlotSurface& surface : plot.surfaces) {
        text << "\nsurface";
        for (const double x : surface.x) text << " " << x;
        text << " by";
        for (const double y : surface.y) text << " " << y;
        text << ":";
        for (const double z : surface.z) text << " " << (std::isnan(z) ? "gap" : std::to_string(z));
    }
    return text.str();
}

std::string shown(std::string_view text, const TableWish& wish = {}) { return told(read(text, wish).plot); }

TEST(Table, GapsAreGapsAndPointsBetweenThemAreRings) {
    const Read gaps = read("x,y\n0,1\n1,2\n2,\n3,NaN\n4,5\n5,na\n6,7\n7,8\n,9\n8,9\n");
    EXPECT_EQ(told(gaps.plot), "y against x|x|y|\ncurve  (0 1) (1 2) gap (4 5) gap (6 7) (7 8) (8 9)\nmark  4 5 0");
    ASSERT_EQ(gaps.notes.size(), 2u);
    EXPECT_EQ(gaps.notes[0].english(), "1 row has no number for the chart and is left out");
    EXPECT_EQ(gaps.notes[1].english(), "3 rows have no number in y; the curve has a gap there");
    EXPECT_EQ(shown("x,y,g\n0,1,a\n0,2,b\n1,,a\n1,3,b\n2,4,a\n3,5,a\n", {.group = "g"}),
              "y against x|x|y|\ncurve a (0 1) gap (2 4) (3 5)\ncurve b (0 2) (1 3)\nmark  0 1 0");
    EXPECT_EQ(shown("x y\n0 1\n1 2\n\n2 3\n3 4\n"), "y against x|x|y|\ncurve  (0 1) (1 2) gap (2 3) (3 4)")
        << "an empty line, as gnuplot has it";
    EXPECT_EQ(shown("x,y\n1,2\n1,2\n1,2\n"), "y against x|x|y|\nmark  1 2 0") << "all points are one";
    EXPECT_EQ(shown("x,y\n1,2\n1,3\n0,3\n"), "y against x|x|y|\ncurve  (1 2) (1 3) (0 3)") << "upright, and back";
}

// The same rows in seven ways.
TEST(Table, ColumnsThatAreNotShownAreTold) {
    const auto left_out = [](std::string_view text, const TableWish& wish = {}) {
        std::string all;
        for (const std::string& note : in_language(read(text, wish).notes, "en"))
            if (note.find(" is shown, and not ") != std::string::npos) all += note.substr(0, note.find(';'));
        return all;
    };
    EXPECT_EQ(left_out("t,a,b,word,c,d,e\n0,1,2,x,3,4,5\n1,2,3,y,4,5,6\n"),
              "of its columns of numbers a is shown, and not b, c, d and 1 more");
    EXPECT_EQ(left_out("t,a,b\n0,1,2\n1,2,3\n"), "of its columns of numbers a is shown, and not b");
    EXPECT_EQ(left_out("t,a,b\n0,1,2\n1,2,3\n", {.group = "b"}), "");
    EXPECT_EQ(left_out("t,a,b\n0,1,2\n1,2,3\n", {.y = "b"}), "");  // who names one has chosen
    EXPECT_EQ(left_out("t,a,word\n0,1,x\n1,2,y\n"), "");
}

TEST(Table, TheWayOfWritingChangesNothing) {
    const std::string plain = shown("t (s),F\n1.5,2\n-2.5,5.25\n4,NaN\n5e0,3\n");
    EXPECT_EQ(plain, "F against t|t (s)|F|\ncurve  (1.5 2) (-2.5 5.25) gap (5 3)\nmark  5 3 0");
    for (const char* same : {"t (s);F\r\n1,5;2\r\n-2,5;5,25\r\n4;\r\n5;3", "t (s)\tF\n1.5\t2\n-2.5\t5.25\n4\t\n5\t3\n",
                             "[{\"t (s)\":1.5,\"F\":2},{\"F\":5.25,\"t (s)\":-2.5},\n{\"t (s)\":4,\"F\":null},{\"t "
                             "(s)\":5,\"F\":3.0,\"more\":{\"a\":[1]}}]",
                             "[[\"t (s)\",\"F\"],[1.5,2],[-2.5,5.25],[4,null],[5,3]]",
                             "{\"about\":\"a test\",\"t (s)\":[1.5,-2.5,4,5],\n\"F\":[2,5.25,NaN,3]}",
                             "\xEF\xBB\xBF {\"F\":[2,5.25,null,3],\"t (s)\":[1.5,-2.5,4,5]}"})
        EXPECT_EQ(shown(same, {.x = "t", .y = "F"}), plain) << same;
}

TEST(Table, JsonIsReadInItsForms) {
    EXPECT_EQ(shown("[1, 4, 9.5]"), "column 1 against row|row|column 1|\ncurve  (1 1) (2 4) (3 9.5)");
    EXPECT_EQ(shown("[[0,1],[1,null],[2,5],[3,6]]"), "y against x|x|y|\ncurve  (0 1) gap (2 5) (3 6)\nmark  0 1 0");
    EXPECT_EQ(shown("[[0,0,1],[1,0,2],[0,1,3],[1,1,null]]"),
              "z over x and y|x|y|z\nsurface 0 1 by 0 1: 1.000000 2.000000 3.000000 gap");
    EXPECT_EQ(shown("[[0,0,1],[1,0.5,2],[0.25,1,3]]"), "z over x and y|x|y|z\nmark  0 0 1\nmark  1 0.5 2\nmark  0.25 1 3");
    EXPECT_EQ(shown("{\"z\":[[1,2],[3,null],[5,6]],\"x\":[10,20],\"y\":[3,2,1]}"),
              "Heights|x|y|z\nsurface 10 20 by 1 2 3: 5.000000 6.000000 3.000000 gap 1.000000 2.000000");
    EXPECT_TRUE(read("[{\"day\":\"2024-02-29\",\"v\":1},{\"day\":\"2024-03-01\",\"v\":2}]").plot.x.dates);
}

TEST(Table, WhatIsWrongInJsonIsToldWithLineAndLetter) {
    const auto expect = [](std::string_view json, const std::string& message) {
        const std::string told = refusal(json);
        EXPECT_NE(told.find(message), std::string::npos) << json << "\n" << told;
    };
    expect("[[1,2],\n[3,4", "t:2:5: it ends in the middle");
    expect("[[1,2],\n[3 4]]", "t:2:");
    expect("[[1,2],{\"x\":3}]", "its rows are not of one kind");
    expect("[[1,2],\n[3,4,5]]", "t:2:7: there are 3 values for 2 in the row before");
    expect("[[1,2],\n[3]]", "t:2:3: there are 1 values for 2 in the row before");
    expect("{\"x\":[1,2],\"y\":[1,2,3]}", "t, row 3: one of its columns ends here");
    expect("{\"x\":[1,2],\"y\":[1,\"a\"]}", "t, row 2: y is \"a\", which is no number");
    expect("{\"x\":{\"a\":1}}", "\"x\" is an object");
    // Rows belong to z alone.
    expect("{\"x\":[[1,2],[3,null]]}", "t has no column of numbers for it");
    expect("[{\"x\":1,\"y\":[2]},{\"x\":2,\"y\":3}]", "t:1: y is \"[...]\", which is no number");
    expect("{\"z\":[[1,2],3],\"x\":[1,2],\"y\":[1,2]}", "z has rows and numbers");
    expect("[]", "there is no row in it");
    expect("{\"z\":[[1,2],[3]],\"x\":[1,2],\"y\":[1,2]}", "has 1 heights for 2 of x");
    expect("{\"z\":[[1,2],[3,4]],\"x\":[1,1],\"y\":[1,2]}", "rise or fall all the way");
    expect("[[1,Infinity],[2,3]]", "which no axis reaches");
    expect("[\"" + std::string(100'000, 'a') + "\"]", "a value is longer than 65536 bytes");
    std::string deep = "[[";
    for (int i = 0; i < 100'000; ++i) deep += '[';
    expect(deep, "it is nested more than 32 deep");
}

// Cell by cell, as somebody would who has all the time in the world.
std::string naive(const std::string& csv) {
    std::istringstream lines(csv);
    std::string line, text;
    std::getline(lines, line);
    const auto comma = line.find(',');
    text = line.substr(comma + 1) + " against " + line.substr(0, comma) + "|" + line.substr(0, comma) + "|" +
           line.substr(comma + 1) + "|\ncurve ";
    std::vector<std::string> words;
    bool gap = false, before = false;
    std::string rings;
    std::string last;
    while (std::getline(lines, line)) {
        const auto at = line.find(',');
        const std::string x = line.substr(0, at), y = line.substr(at + 1);
        if (y.empty()) {
            gap = before;
            continue;
        }
        std::ostringstream point;
        point.precision(17);
        point << " (" << std::stod(x) << " " << std::stod(y) << ")";
        text += (gap ? " gap" : "") + point.str();
        gap = false;
        before = true;
    }
    return text;
}

TEST(Table, ReadsWhatANaiveReaderReads) {
    std::mt19937 random(17);
    for (int round = 0; round < 30; ++round) {
        std::ostringstream csv;
        csv.precision(17);
        csv << "a,b\n";
        const int rows = 2 + static_cast<int>(random() % 3000);
        for (int i = 0; i < rows; ++i) {
            csv << i * 0.25 << ",";
            if (i % 50 != 7 || i + 1 == rows) csv << (static_cast<double>(random()) - 2e9) / 1024;
            csv << "\n";
        }
        std::string read = shown(csv.str());
        read = read.substr(0, read.find("\nmark"));
        EXPECT_EQ(read, naive(csv.str())) << round;
    }
}

TEST(Table, PointsOfAGridAreASurfaceInAnyOrder) {
    std::vector<std::string> rows;
    for (int y = 0; y < 5; ++y)
        for (int x = 0; x < 7; ++x)
            if (x != 3 || y != 2)
                rows.push_back(std::to_string(x * x) + "," + std::to_string(-y) + "," + std::to_string(10 * y + x));
    std::mt19937 random(1);
    std::string first;
    for (int round = 0; round < 5; ++round) {
        std::shuffle(rows.begin(), rows.end(), random);
        std::string csv = "x,y,h\n";
        for (const std::string& row : rows) csv += row + "\n";
        const Read surface = read(csv, {.z = "h"});
        if (first.empty()) first = told(surface.plot);
        EXPECT_EQ(told(surface.plot), first);
        ASSERT_EQ(surface.plot.surfaces.size(), 1u);
        const PlotSurface& found = surface.plot.surfaces[0];
        for (std::size_t row = 0; row < 5; ++row)
            for (std::size_t column = 0; column < 7; ++column) {
                const double y = 4 - static_cast<double>(row), x = static_cast<double>(column);
                if (x == 3 && y == 2)
                    EXPECT_TRUE(std::isnan(found.at(column, row)));
                else
                    EXPECT_EQ(found.at(column, row), 10 * y + x);
            }
        EXPECT_EQ(surface.notes.back().english(), "nothing is known of 1 of the 35 places of the surface");
    }
    EXPECT_TRUE(read("x,y,h\n0,0,1\n1,0,2\n0,1,3\n1,1,4\n0,0,5\n", {.z = "h"}).plot.spatial) << "a place twice";
}

TEST(Table, AMatrixIsASurface) {
    const std::string surface = "Heights|x|y|z\nsurface 1 2 4 by 10 20: 5.000000 6.500000 7.000000 8.000000 gap 9.000000";
    EXPECT_EQ(shown(",1,2,4\n10,5,6.5,7\n20,8,,9\n"), surface);
    EXPECT_EQ(shown("y\\x;4;2;1\n20;9;;8\n10;7;6,5;5\n"), surface) << "falling, with commas";
    EXPECT_EQ(shown("3 1 2 4\n10 5 6.5 7\n20 8 NaN 9\n", {.matrix = true}), surface) << "a nonuniform matrix of gnuplot";
    EXPECT_EQ(shown("5 6.5 7\n8 NaN 9\n", {.matrix = true}),
              "Heights|column|row|z\nsurface 1 2 3 by 1 2: 5.000000 6.500000 7.000000 8.000000 gap 9.000000");
    EXPECT_EQ(shown("[[5,6.5,7],[8,null,9]]", {.matrix = true}), shown("5 6.5 7\n8 NaN 9\n", {.matrix = true}));
    EXPECT_EQ(read(",1,2\n1,3,4\n2,5,6\n", {.x = "x", .y = "y"}).plot.surfaces.size(), 0u);
    EXPECT_TRUE(read("month,2019,2020\n1,2,3\n1,3,4\n").plot.surfaces.empty()) << "the first column does not rise";
}

TEST(Table, AHistogramCountsEachValueOnce) {
    std::mt19937 random(9);
    std::normal_distribution<double> normal(3, 2);
    for (const int bins : {0, 1, 7, 100}) {
        std::string csv = "v\n";
        for (int i = 0; i < 500; ++i) csv += std::to_string(normal(random)) + "\n";
        const Plot plot = read(csv, {.histogram = bins}).plot;
        ASSERT_EQ(plot.curves.size(), 1u);
        const PlotCurve& curve = plot.curves[0];
        EXPECT_EQ(curve.joined, Joining::bars);
        double sum = 0;
        for (const PlotPoint& point : curve.points) sum += point.y;
        EXPECT_EQ(sum, 500);
        EXPECT_EQ(curve.points.back().y, 0);
        if (bins > 0) {
            EXPECT_EQ(curve.points.size(), static_cast<std::size_t>(bins) + 1);
        }
    }
    EXPECT_EQ(shown("v\n1\n2\n2\n3\n", {.histogram = 2}), "How often v is where|v|count|\ncurve  (1 1) (2 3) (3 0)");
    EXPECT_EQ(shown("v\n5\n5\n", {.histogram = 9}), "How often v is where|v|count|\ncurve  (4.5 2) (5.5 0)");
}

// By the paper's own words: the width is twice the span of the middle half over the cube root of the number of values.
TEST(Table, BinsAreAsWideAsFreedmanAndDiaconisSay) {
    std::vector<double> even;
    for (int i = 0; i < 1000; ++i) even.push_back(i);
    EXPECT_EQ(bins_for(even), 10) << "999 over 2 * 500 / 10";
    std::vector<double> equal(100, 4.0);
    equal.push_back(9);
    EXPECT_EQ(bins_for(equal), 8) << "1 + log2 101, rounded up";
    std::vector<double> far(100'000, 0.0);
    for (std::size_t i = 0; i < far.size(); ++i) far[i] = static_cast<double>(i % 100);
    far.push_back(1e9);
    EXPECT_EQ(bins_for(far), kMostChosenBins);
    std::vector<double> one = {3};
    EXPECT_EQ(bins_for(one), 1);
}

TEST(Table, WhatDoesNotGoTogetherIsRefused) {
    EXPECT_NE(refusal("a,b\n1,2\n", {.y = "b", .histogram = 0}).find("histogram: it shows one column"), std::string::npos);
    EXPECT_NE(refusal("a,b\n1,2\n", {.points = true, .matrix = true}).find("matrix: it has all rows"), std::string::npos);
    std::string to_and_fro = "x,y\n";
    for (int i = 0; i < 20'002; ++i) to_and_fro += std::to_string(i % 2) + "," + std::to_string(i) + "\n";
    EXPECT_NE(refusal(to_and_fro).find("x changes direction more than 10000 times; sort the rows by it"), std::string::npos);
}

// What other programs write is what they meant.
TEST(Table, FilesOfPythonAreReadAsTheyWereMeant) {
    if (!tests::has_tool("python3")) GTEST_SKIP() << "python3 is not installed";
    const tests::Folder folder;
    const auto made = tests::run_tool(
        folder, {"python3", "-c",
                 "import csv, json, math\n"
                 "rows = [[i / 8, math.sin(i)] for i in range(200)]\n"
                 "rows[50][1] = None\n"
                 "with open('t.csv', 'w', newline='') as f:\n"
                 "    w = csv.writer(f, quoting=csv.QUOTE_ALL); w.writerow(['a \"q\", (s)', 'b']); w.writerows(rows)\n"
                 "with open('t.tsv', 'w', newline='') as f:\n"
                 "    w = csv.writer(f, dialect='excel-tab'); w.writerow(['a \"q\", (s)', 'b']); w.writerows(rows)\n"
                 "json.dump([{'a \"q\", (s)': x, 'b': y} for x, y in rows], open('t.json', 'w'), indent=1)\n"
                 "json.dump({'a \"q\", (s)': [x for x, y in rows], 'b': [math.nan if y is None else y for x, y in rows]},"
                 " open('c.json', 'w'))\n"});
    ASSERT_EQ(made.code, 0) << made.err;
    const std::string plain = shown(tests::bytes_of(folder / "t.csv"));
    EXPECT_TRUE(plain.starts_with("b against a \"q\",|a \"q\", (s)|b|\ncurve  (0 0) (0.125 0.8414709848078965)"))
        << plain.substr(0, 200);
    EXPECT_EQ(std::count(plain.begin(), plain.end(), '('), 200) << "199 points, and a unit";
    for (const char* same : {"t.tsv", "t.json", "c.json"}) EXPECT_EQ(shown(tests::bytes_of(folder / same)), plain) << same;
}

bool says(const Read& read, std::string_view words) {
    return std::any_of(read.notes.begin(), read.notes.end(),
                       [&](const Phrase& note) { return note.english().find(words) != std::string::npos; });
}

TEST(Table, RowsInAnyOrderOfXAreNoted) {
    std::mt19937 random(7);
    std::vector<int> order(60);
    std::iota(order.begin(), order.end(), 0);
    std::string sorted = "x,y\n", path = "x,y\n", shuffled = "x,y\n";
    for (const int i : order) {
        sorted += std::to_string(i) + "," + std::to_string(i % 7) + "\n";
        path += std::to_string(std::cos(0.3 * i)) + "," + std::to_string(std::sin(0.3 * i)) + "\n";
    }
    std::shuffle(order.begin(), order.end(), random);
    for (const int i : order) shuffled += std::to_string(i) + ",1\n";
    const char* const words = "rows are joined in their order, and x changes direction";
    EXPECT_TRUE(says(read(shuffled), words));
    EXPECT_FALSE(says(read(sorted), words));
    EXPECT_FALSE(says(read(path), words));
    TableWish points;
    points.points = true;
    EXPECT_FALSE(says(read(shuffled, points), words));
}

TEST(Table, HeightsThatAreDrawnAsACurveAreNoted) {
    std::string grid = "east,north,height\n", three = "depth,heat,salt\n", set = "time,set,heat\n", rows;
    for (int i = 0; i < 30; ++i) {
        grid += std::to_string(i % 6) + "," + std::to_string(i / 6) + "," + std::to_string(i * i) + "\n";
        three += std::to_string(i) + "," + std::to_string(i * i) + "," + std::to_string(90 - i) + "\n";
        set += std::to_string(i) + "," + std::to_string(20 + i / 15) + "," + std::to_string(i % 7) + "\n";
        rows += std::to_string(0.5 * i) + "," + std::to_string(i % 5) + "," + std::to_string(i % 3) + "," +
                std::to_string(i % 4) + "\n";
    }
    EXPECT_TRUE(says(read(grid), "if height is the height over east and north, name it by " + spelled("z")));
    TableWish heights;
    heights.z = "height";
    EXPECT_FALSE(says(read(grid, heights), "is the height over"));
    EXPECT_FALSE(says(read(three), "is the height over"));
    EXPECT_FALSE(says(read(set), "is the height over"));
    EXPECT_TRUE(says(read(rows), "if its rows are heights, use " + spelled("matrix")));
    EXPECT_FALSE(says(read(three), "if its rows are heights"));
}

}  // namespace
}  // namespace tactics::table_test
