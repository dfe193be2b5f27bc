// SPDX-License-Identifier: Apache-2.0
// `tactics evaluate --study subject` as the user meets it, and with a search of another's.
#include "cli/verbs/evaluate_subject.h"

#include <gtest/gtest.h>

#include "tests/cli/evaluating.h"

namespace tactics {
namespace {

using namespace tests;

class EvaluateSubject : public testing::Test, public OutlinedRectangle {
protected:
    EvaluateSubject() : OutlinedRectangle(4) {}
};

TEST_F(EvaluateSubject, FindsWhatAllAgreeOn) {
    const Ending table = study("subject", cut_and({"-q"}));
    EXPECT_EQ(table.code, 0) << table.err;
    EXPECT_TRUE(table.out.starts_with("recipe                  box IoU  box found  point IoU  point found  objects  failed"))
        << table.out;
    EXPECT_TRUE(holds(table.out, "\nthreshold method=fixed    1.000      1.000      1.000        1.000        1  0\n"))
        << table.out;
    EXPECT_TRUE(holds(table.out, "\nsimplest person           1.000      1.000      1.000        1.000        1  0\n"))
        << table.out;
    EXPECT_TRUE(holds(table.out, "\nthe box alone             1.000      1.000          -            -        1  0\n"))
        << table.out;
    EXPECT_TRUE(holds(study("subject", cut_and({"-q", "--json"})).out, R"("box_iou":[1.0000],"point_iou":[1.0000])"));
}

TEST_F(EvaluateSubject, APictureWithoutAgreementIsToldAndIsNoFailure) {
    std::filesystem::remove(folder / "set/gt/a_gt3.png");
    std::filesystem::remove(folder / "set/gt/a_gt4.png");
    const Ending table = study("subject", kCut);
    EXPECT_EQ(table.code, 0) << table.err;
    EXPECT_TRUE(holds(table.err, "1 of 1 pictures have no object that 3 people agree on")) << table.err;
    EXPECT_TRUE(holds(table.out, "\nthreshold method=fixed        -          -          -            -        0  0\n"))
        << table.out;
}

// Whoever looks for subjects gets the picture once and each hint, and is scored by what he answers.
TEST_F(EvaluateSubject, AnySearchIsAskedWithABoxAndAPoint) {
    Given given(find_command("evaluate")->flags);
    int looked = 0;
    std::vector<SubjectHint> hints;
    const SubjectSearch search = [&](Recipe, Image image, int width, int height) -> SubjectFinder {
        ++looked;
        EXPECT_GT(image.width, 0);
        return [&hints, width, height](const SubjectHint& hint) {
            hints.push_back(hint);
            return std::vector<std::uint8_t>(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 1);
        };
    };
    given.words = {(folder / "set").string()};
    given.add("--study", "subject");
    given.add("--quiet", "");
    given.add("--filter", "threshold");
    given.add("--csv", (folder / "t.csv").string());
    const EvaluateRequest request = plan_evaluation(given, real_disk());
    testing::internal::CaptureStdout();
    EXPECT_EQ(run_subject_study(request, search), 0);
    testing::internal::GetCapturedStdout();
    EXPECT_EQ(looked, 1);
    ASSERT_EQ(hints.size(), 2u);
    EXPECT_EQ(hints[0].box, (std::array<int, 4>{kLeft, kTop, kRight, kBottom}));
    EXPECT_FALSE(hints[0].point.has_value());
    ASSERT_TRUE(hints[1].point.has_value());
    EXPECT_TRUE(inside((*hints[1].point)[0], (*hints[1].point)[1]));
    // The whole picture taken: the object is 28000 of its 120000 pixels.
    EXPECT_TRUE(holds(bytes_of(folder / "t.csv"), "\r\nthreshold,0.233,0.000,0.233,0.000,1,0\r\n")) << bytes_of(folder / "t.csv");
}

}  // namespace
}  // namespace tactics
