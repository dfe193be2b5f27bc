// SPDX-License-Identifier: Apache-2.0
// Dashes of figures as plotting tools write them.
#include "tactics/readers/svg/dash_marks.h"

#include <gtest/gtest.h>

#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "tactics/readers/svg/figure.h"
#include "tactics/readers/svg/svg.h"

namespace tactics::dash_marks_test {
namespace {

// The first ones of each kind are in files that R, Matplotlib, graphviz and gnuplot wrote; the others are made.
TEST(DashMarks, OfPlottingToolsAreKnown) {
    for (const auto& [dashes, width] : {std::pair{"1.5,4.5", "1.5"},
                                        {"1.5,2.475", "1.5"},
                                        {"1,5", "1"},
                                        {"1.0,2.0", "1.00"},
                                        {"0.75 2.25", "0.75"},
                                        {"2.0,3.5", "1.00"},
                                        {"0,4", "2"},
                                        {"2", "2"},
                                        {"3px 3px", "2px"}})
        EXPECT_EQ(marks_of(dashes, width), DashMarks::dots) << dashes;
    for (const auto& [dashes, width] : {std::pair{"6,6", "1.5"},
                                        {"5.55,2.4", "1.5"},
                                        {"5,2", "1"},
                                        {"2.5,4.0", "1.00"},
                                        {" 5,8", "2.00"},
                                        {"8.0,5.0", "1.00"},
                                        {"5", "1"},
                                        {"10.5,4.5", "1.5"},
                                        {"4,4", ""}})
        EXPECT_EQ(marks_of(dashes, width), DashMarks::dashes) << dashes;
    for (const auto& [dashes, width] :
         {std::pair{"9.6,2.4,1.5,2.4", "1.5"}, {"4.0,2.0,1.0,2.0", "1.00"}, {"1.5,4.5,6,4.5", "1.5"}})
        EXPECT_EQ(marks_of(dashes, width), DashMarks::both) << dashes;
    for (const char* none : {"", "none", "0,0", "4,x"}) EXPECT_EQ(marks_of(none, "1"), DashMarks::none) << none;
}

Drawing drawn(const std::vector<std::string>& dashes) {
    std::string body;
    int y = 10;
    for (const std::string& one : dashes) {
        y += 15;
        body += "<path fill='none' stroke='black' stroke-dasharray='" + one + "' d='M10 " + std::to_string(y) + " L90 " +
                std::to_string(y + 5) + " L150 " + std::to_string(y) + "'/>";
    }
    const std::string file =
        "<svg xmlns='http://www.w3.org/2000/svg' width='200mm' height='100mm' viewBox='0 0 200 100'>" + body + "</svg>";
    return drawing_of_figure(read_svg(file, "figure.svg", 0, std::nullopt, SvgPurpose::figure), 200);
}

TEST(DashMarks, TellLinesApart) {
    const Drawing drawing = drawn({"none", "5,3", "1,3", "6,2,1,2", "5,2"});
    ASSERT_EQ(drawing.strokes.size(), 5u);
    using Look = std::pair<Role, LineClass>;
    const Look looks[] = {{Role::line, LineClass::normal},
                          {Role::dash, LineClass::normal},
                          {Role::dots, LineClass::thick},
                          {Role::dash, LineClass::thick},
                          {Role::dash, LineClass::normal}};
    for (std::size_t i = 0; i < std::size(looks); ++i)
        EXPECT_EQ((Look{drawing.strokes[i].role, drawing.strokes[i].line}), looks[i]) << i;
}

// Their marks say nothing then, and dashes are followed best.
TEST(DashMarks, ThatAreAllAlikeAreDashes) {
    for (const char* dashes : {"5,3", "1,3", "6,2,1,2"})
        for (const Stroke& stroke : drawn({dashes, "none", dashes}).strokes) {
            EXPECT_NE(stroke.role, Role::dots);
            EXPECT_EQ(stroke.line, LineClass::normal);
        }
}

}  // namespace
}  // namespace tactics::dash_marks_test
