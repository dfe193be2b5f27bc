// SPDX-License-Identifier: Apache-2.0
// A model as a source, as the user meets it.
#include <gtest/gtest.h>

#include "tests/cli/converting.h"

namespace tactics {
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
    EXPECT_EQ(convert({"table.wrl", "-o", "views.svg", "-q", "--model", "views"}).code, 0);
    EXPECT_EQ(convert({"table.wrl", "-o", "heights.svg", "-q", "--model", "heights"}).code, 0);
    const Ending wrong = convert({"table.wrl", "-o", "no.svg", "--object", "Tpo"});
    EXPECT_EQ(wrong.code, 1);
    EXPECT_TRUE(holds(wrong.err, "Table/Top")) << wrong.err;
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
}  // namespace tactics
