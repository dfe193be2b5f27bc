// SPDX-License-Identifier: Apache-2.0
// `tactics evaluate --study regions` as the user meets it.
#include <gtest/gtest.h>

#include "tests/studies/evaluating.h"

namespace tactics::regions_test {
namespace {

using namespace tests;

class EvaluateRegions : public testing::Test, public OutlinedRectangle {
protected:
    EvaluateRegions() : OutlinedRectangle(2) {}
};

TEST_F(EvaluateRegions, TheSameRegionsCoverAll) {
    const Ending table = study("regions", cut_and({"-q"}));
    EXPECT_EQ(table.code, 0) << table.err;
    EXPECT_TRUE(table.out.starts_with(
        "recipe                  covering  covering OIS  covering best    PRI  PRI OIS     VI  VI OIS  pictures"))
        << table.out;
    EXPECT_TRUE(
        holds(table.out, "\nthreshold method=fixed     1.000         1.000          1.000  1.000    1.000  0.000   0.000 "))
        << table.out;
    EXPECT_TRUE(
        holds(table.out, "\npeople                     1.000             -              -  1.000        -  0.000       - "))
        << table.out;
    EXPECT_TRUE(holds(table.out, "\nsimplest person            1.000 ")) << table.out;
    // Lines of a drawing enclose regions, too.
    const Ending drawn = study("regions", {"-q", "-r", "sobel"});
    EXPECT_TRUE(holds(drawn.out, "\nsobel               0.9")) << drawn.out;
}

// One of two sees more on the right: his rectangle is 28000 + 1400 of 120000 pixels.
TEST_F(EvaluateRegions, AnotherSizeIsCoveredInProportion) {
    add_person(2, [](int x, int y) {
        const auto wider = [](int column, int row) { return inside(column, row) || inside(column - 10, row); };
        const bool here = wider(x, y);
        return wider(x + 1, y) != here || wider(x, y + 1) != here || wider(x + 1, y + 1) != here;
    });
    const double covered = (28000 + 90600.0 * 90600 / 92000) / 120000;
    const Ending json = study("regions", cut_and({"-q", "--json"}));
    EXPECT_TRUE(holds(json.out, "\"covering_ods\":" + std::to_string((1 + covered) / 2).substr(0, 7))) << json.out << covered;
    EXPECT_TRUE(holds(json.out, R"({"study":"regions","pictures":1,"problems":[]})")) << json.out;
}

TEST_F(EvaluateRegions, DotsAreLeftOutAndWhatDoesNotFitIsRefused) {
    const Ending dots = study("regions", {"-q", "-r", "kmeans", "-s", "kmeans.k=2"});
    EXPECT_EQ(dots.code, 0) << dots.err;
    EXPECT_TRUE(holds(dots.out, "\nkmeans              0.9") || holds(dots.out, "\nkmeans              1.0")) << dots.out;
    EXPECT_EQ(study("regions", {"-q", "-r", "none"}).code, 2);
    EXPECT_EQ(study("regions", cut_and({"--chart", "c.svg"})).code, 1);
    EXPECT_EQ(study("regions", cut_and({"--sweep", "threshold.level=1,2"})).code, 1);
    const Ending other = study("region", kCut);
    EXPECT_EQ(other.code, 1);
    EXPECT_TRUE(holds(other.err, "(regions?)")) << other.err;
    EXPECT_TRUE(study("regions", cut_and({"-q", "--csv", "-"})).out.starts_with("recipe,covering,covering OIS,"));
}

}  // namespace
}  // namespace tactics::regions_test
