// SPDX-License-Identifier: Apache-2.0
// A model as a source, as the user meets it.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/cli/converting.h"

namespace tactics::model_test {
namespace {

using namespace tests;

constexpr char kTable[] =
    "#VRML V2.0 utf8\n"
    "DEF Table Transform { children [\n"
    "  DEF Top Transform { translation 0 0.72 0 children Shape { geometry Box { size 1.2 0.04 0.8 } } }\n"
    "  DEF Leg1 Transform { translation -0.55 0.35 -0.35 children Shape { geometry Box { size 0.05 0.7 0.05 } } }\n"
    "  DEF Leg2 Transform { translation  0.55 0.35 -0.35 children Shape { geometry Box { size 0.05 0.7 0.05 } } }\n"
    "  DEF Leg3 Transform { translation -0.55 0.35  0.35 children Shape { geometry Box { size 0.05 0.7 0.05 } } }\n"
    "  DEF Leg4 Transform { translation  0.55 0.35  0.35 children Shape { geometry Box { size 0.05 0.7 0.05 } } }\n"
    "] }\n";

class ModelCommand : public Convert {
protected:
    void SetUp() override {
        Convert::SetUp();
        write_bytes(folder / "table.wrl", kTable);
    }
};

TEST_F(ModelCommand, ATableIsFoldedOutWithItsNames) {
    const Ending ending = convert({"table.wrl", "-o", "table.svg", "--json"});
    ASSERT_EQ(ending.code, 0) << ending.err;
    EXPECT_TRUE(holds(ending.out, "\"flattened\":1")) << ending.out;
    for (const char* path : {"Table/Top", "Table/Leg1", "Table/Leg4"}) EXPECT_TRUE(holds(ending.out, path)) << ending.out;
    const std::string svg = bytes_of(folder / "table.svg");
    EXPECT_TRUE(holds(svg, "Leg1")) << "a screen reader finds no leg";
    const Ending said = convert({"table.wrl", "-o", "table.pdf"});
    EXPECT_TRUE(holds(said.err, "from above: 4 slender parts laid flat")) << said.err;
    EXPECT_EQ(convert({"table.wrl", "-o", "again.svg", "-q"}).code, 0);
    EXPECT_EQ(svg, bytes_of(folder / "again.svg"));
}

TEST_F(ModelCommand, APartAloneAndViewsAndHeights) {
    EXPECT_EQ(convert({"table.wrl", "-o", "top.svg", "-q", "--object", "Top"}).code, 0);
    EXPECT_FALSE(holds(bytes_of(folder / "top.svg"), "Leg1"));
    EXPECT_EQ(convert({"table.wrl", "-o", "same.svg", "-q", "--part", "Table/Top"}).code, 0) << "as some call it, too";
    EXPECT_EQ(bytes_of(folder / "same.svg"), bytes_of(folder / "top.svg"));
    EXPECT_EQ(convert({"table.wrl", "-o", "views.svg", "-q", "--model", "views"}).code, 0);
    EXPECT_EQ(convert({"table.wrl", "-o", "heights.svg", "-q", "--model", "heights"}).code, 0);
    const Ending wrong = convert({"table.wrl", "-o", "no.svg", "--object", "Tpo"});
    EXPECT_EQ(wrong.code, 1);
    EXPECT_TRUE(holds(wrong.err, "Table/Top")) << wrong.err;
}

// A ridge, with z or with y upwards, in a file that has no names: it is a terrain.
TEST_F(ModelCommand, WhichWayIsUpMattersToHeightsToo) {
    const std::string faces = "f 1 2 5\nf 1 5 4\nf 2 3 6\nf 2 6 5\n";
    write_bytes(folder / "z.obj", "v 0 0 0\nv 50 0 30\nv 100 0 0\nv 0 80 0\nv 50 80 30\nv 100 80 0\n" + faces);
    write_bytes(folder / "y.obj", "v 0 0 0\nv 50 30 0\nv 100 0 0\nv 0 0 -80\nv 50 30 -80\nv 100 0 -80\n" + faces);
    for (const Words& heights : {Words{}, Words{"--model", "heights"}}) {
        Words z = {"z.obj", "-o", "z.svg", "-q"}, y = {"y.obj", "-o", "y.svg", "-q", "--fold", "up=y"};
        z.insert(z.end(), heights.begin(), heights.end());
        y.insert(y.end(), heights.begin(), heights.end());
        ASSERT_EQ(convert(z).code, 0);
        ASSERT_EQ(convert(y).code, 0);
        EXPECT_EQ(bytes_of(folder / "z.svg"), bytes_of(folder / "y.svg"));
    }
    EXPECT_EQ(convert({"y.obj", "-o", "no.svg", "--model", "heights", "--fold", "up=y fold=no"}).code, 1);
}

TEST_F(ModelCommand, ASmoothTerrainIsNotAnEmptyPage) {
    std::string text, faces;
    for (int i = 0; i < 40; ++i)
        for (int j = 0; j < 40; ++j) {
            text += "v " + std::to_string(i) + " " + std::to_string(j) + " " +
                    std::to_string(3 * std::sin(i / 8.0) * std::cos(j / 9.0)) + "\n";
            const int a = 40 * i + j + 1;
            if (i == 39 || j == 39) continue;
            for (const int c : {a + 40, a + 41})
                faces += "f " + std::to_string(a) + " " + std::to_string(c) + " " + std::to_string(c == a + 40 ? a + 41 : a + 1) +
                         "\n";
        }
    write_bytes(folder / "waves.obj", text + faces);
    const Ending ending = convert({"waves.obj", "-o", "waves.svg"});
    EXPECT_EQ(ending.code, 0);
    EXPECT_FALSE(holds(ending.err, "nothing")) << ending.err;
}

// Python's own reading of both files: what the list says lies where the SVG has it.
constexpr char kCheck[] = R"py(
import json, re, sys
import xml.etree.ElementTree as tree

def rings(d):
    all, at = [], (0.0, 0.0)
    for ring in d.split('z'):
        numbers = [float(n) for n in re.findall(r'-?(?:[0-9]+\.?[0-9]*|\.[0-9]+)', ring)]
        points = []
        start = at
        for i in range(0, len(numbers) - 1, 2):
            at = (numbers[i], numbers[i + 1]) if not points else (at[0] + numbers[i], at[1] + numbers[i + 1])
            points.append(at)
        if points:
            all.append(points)
            at = points[0]
    return all

def within(rings, x, y):
    turns = 0
    for ring in rings:
        for (ax, ay), (bx, by) in zip(ring, ring[1:] + ring[:1]):
            if (ay > y) != (by > y) and x < ax + (y - ay) / (by - ay) * (bx - ax):
                turns += 1 if by > ay else -1
    return turns != 0

svg = '{http://www.w3.org/2000/svg}'
page, = json.load(open(sys.argv[1]))['pages']
paths = [e for e in tree.parse(sys.argv[2]).iter(svg + 'path') if e.get('class') == 'tactics-region']
drawn = [o for o in page['objects'] if o['drawn']]
assert len(paths) == len(drawn) and drawn, (len(paths), len(drawn))
for path, one in zip(paths, drawn):
    assert path.find(svg + 'title').text == one['name'], one
    assert path.find(svg + 'desc').text == one['description'], one
    assert path.get('data-path') == one['path'] and path.get('role') == 'img' and path.get('tabindex') == '0'
    assert within(rings(path.get('d')), one['x_mm'], one['y_mm']), one
    assert one['left_mm'] <= one['x_mm'] <= one['left_mm'] + one['width_mm'], one
    assert any(line.startswith(one['name'] + ', ' + one['place']) for line in page['lines']), one
for one in page['objects']:
    assert one['drawn'] or any(one['name'] in line and 'Not drawn' in line for line in page['lines']), one
print(' '.join(sorted(one['path'] for one in page['objects'])))
)py";

TEST_F(ModelCommand, TheListAndTheRegionsAgreeWithEachOther) {
    if (!has_tool("python3")) GTEST_SKIP() << "python3 is missing";
    write_bytes(folder / "check.py", kCheck);
    std::string more = kTable;
    more +=
        "DEF OB_Cup_001 Transform { translation 0.2 0.79 0 children DEF ME_Mesh Shape { geometry Cylinder { radius 0.06 height "
        "0.1 } } }\n"
        "DEF Pin Transform { translation 0 0.741 0.2 children Shape { geometry Box { size 0.002 0.002 0.002 } } }\n";
    write_bytes(folder / "laid.wrl", more);
    for (const char* model : {"fold-out", "views"}) {
        const Ending ending = convert(
            {"laid.wrl", "-q", "--model", model, "-o", "laid.svg", "-o", "laid.json", "-o", "laid.txt", "-o", "laid.pdf"});
        ASSERT_EQ(ending.code, 0) << ending.err;
        const Ending python = run_tool(folder, {"python3", "check.py", "laid.json", "laid.svg"});
        EXPECT_EQ(python.code, 0) << python.err;
        for (const char* path : {"Table/Top", "Table/Leg1", "Pin", "OB_Cup_001"})
            EXPECT_TRUE(holds(python.out, path)) << python.out;
        const std::string words = bytes_of(folder / "laid.txt");
        EXPECT_TRUE(holds(words, "\nCup, ")) << words;
        EXPECT_TRUE(holds(words, "Not drawn, too small to be felt at this size: Pin")) << words;
    }
    // Once more through the program: the same regions, and nothing drawn of them.
    ASSERT_EQ(convert({"laid.svg", "-q", "-o", "again.svg"}).code, 0);
    EXPECT_TRUE(holds(bytes_of(folder / "again.svg"), "<title id=\"region-1-title\">"));
}

TEST_F(ModelCommand, DescribeListsTheParts) {
    const Ending words = run_tactics(folder, {"describe", "table.wrl"}),
                 json = run_tactics(folder, {"describe", "table.wrl", "--json"});
    EXPECT_TRUE(holds(words.out, "What it shows:\n")) << words.out;
    EXPECT_TRUE(holds(words.out, "4 slender parts on it laid flat outward")) << words.out;
    EXPECT_TRUE(holds(json.out, "\"objects\":[{\"name\":\"")) << json.out;
    EXPECT_TRUE(holds(json.out, "\"counts\":{\"flattened\":1}")) << json.out;
}

TEST_F(ModelCommand, SettingsAreChecked) {
    EXPECT_EQ(convert({"table.wrl", "-o", "no.svg", "--model", "folded"}).code, 1);
    EXPECT_EQ(convert({"table.wrl", "-o", "no.svg", "--fold", "flta=0.2"}).code, 1);
    EXPECT_EQ(convert({"table.wrl", "-o", "no.svg", "--fold", "Nobody: fold=no"}).code, 1);
    write_bytes(folder / "likes", "# of a reader\ncost-flatten = 1\n\nplane = front\n");
    EXPECT_EQ(convert({"table.wrl", "-o", "front.svg", "-q", "--reader", "likes"}).code, 0);
    write_bytes(folder / "likes", "cost-flatten = 1\ncost = 3\n");
    const Ending wrong = convert({"table.wrl", "-o", "no.svg", "--reader", "likes"});
    EXPECT_EQ(wrong.code, 1);
    EXPECT_TRUE(holds(wrong.err, "likes:2")) << wrong.err;
}

}  // namespace
}  // namespace tactics::model_test
