// SPDX-License-Identifier: Apache-2.0
// What is advised of a drawing that is not fit to be felt.
#include "tactics/job/mending.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tactics/error.h"
#include "tactics/layout/place.h"

namespace tactics::mending_test {
namespace {

Sheet a4() {
    Sheet sheet;
    sheet.paper = {"", "", 210, 297};
    sheet.medium = &find_medium("swell", "test");
    return sheet;
}

// Lines side by side, 2.5 mm apart on one sheet: every second has to go there, and none on four.
Drawing hatched() {
    Drawing drawing;
    drawing.width = 160;
    drawing.height = 220;
    for (int i = 0; i < 40; ++i) drawing.strokes.push_back({{{10 + 2.5 * i, 20}, {10 + 2.5 * i, 200}}});
    return drawing;
}

std::string advice(const Sheet& sheet, bool finer) {
    Mended mended = mend_for(*sheet.medium, place_on(sheet, hatched().width / hatched().height).drawing.width, hatched(), false);
    EXPECT_LT(mended.told.kept, kLegible);
    advise(sheet, mended, finer);
    return mended.told.advice.english();
}

TEST(Advice, OfADrawingThatIsScaledIsWhatMendingItThereKeeps) {
    Sheet larger = a4();
    larger.tiles = {2, 2};
    const double width = place_on(larger, hatched().width / hatched().height).drawing.width;
    const double kept = repair(scaled_to(hatched(), width), *larger.medium).kept;
    ASSERT_GE(kept, kLegible);
    const std::string told = advice(a4(), false);
    EXPECT_NE(
        told.find("On 2x2 sheets (" + spelled("tiles") + " 2x2) " + std::to_string(std::lround(100 * kept)) + " % would be"),
        std::string::npos)
        << told;
}

// On a larger sheet such a picture has more lines than on this one, of which nothing is known yet.
TEST(Advice, OfAPictureThatIsFinerThanItsDrawingPromisesNothing) {
    const std::string told = advice(a4(), true);
    EXPECT_NE(told.find("More sheets (" + spelled("tiles") + " 2x2) may help"), std::string::npos) << told;
    EXPECT_EQ(told.find("would be"), std::string::npos) << told;
}

}  // namespace
}  // namespace tactics::mending_test
