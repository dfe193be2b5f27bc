// SPDX-License-Identifier: Apache-2.0
// `tactics evaluate --study subject` as the user meets it, and with a search of another's.
#include "studies/subject.h"

#include <gtest/gtest.h>

#include "filters/list.h"
#include "tests/studies/evaluating.h"

namespace tactics::subject_test {
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
    EXPECT_TRUE(holds(table.err, "1 of 1 pictures has no object that 3 people agree on")) << table.err;
    EXPECT_TRUE(holds(table.out, "\nthreshold method=fixed        -          -          -            -        0  0\n"))
        << table.out;
}

// Whoever looks for subjects gets the picture once and each hint, and is scored by what he answers.
TEST_F(EvaluateSubject, AnySearchIsAskedWithABoxAndAPoint) {
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
    std::vector<std::string> maps;
    for (int person = 1; person <= 4; ++person)
        maps.push_back((folder / ("set/gt/a_gt" + std::to_string(person) + ".png")).string());
    StudyRequest request;
    request.subjects = pair_up({(folder / "set/images/a.png").string()}, std::move(maps)).subjects;
    request.sheet.paper = find_paper("a4", "the test");
    request.sheet.medium = &find_medium("swell", "the test");
    Candidate cut;
    cut.name = "cut";
    cut.chain.base = parse_recipe("threshold", "the test", filters());
    cut.settings = {""};
    cut.recipes = {assemble(cut.chain, *cut.chain.base)};
    request.candidates = {cut};
    const StudyFindings findings = study_subject(request, {}, search);
    EXPECT_TRUE(findings.problems.empty());
    EXPECT_EQ(looked, 1);
    ASSERT_EQ(hints.size(), 2u);
    EXPECT_EQ(hints[0].box, (std::array<int, 4>{kLeft, kTop, kRight, kBottom}));
    EXPECT_FALSE(hints[0].point.has_value());
    ASSERT_TRUE(hints[1].point.has_value());
    EXPECT_TRUE(inside((*hints[1].point)[0], (*hints[1].point)[1]));
    // The whole picture taken: the object is 28000 of its 120000 pixels.
    EXPECT_TRUE(holds(findings.csv, "\r\ncut,0.233,0.000,0.233,0.000,1,0\r\n")) << findings.csv;
}

}  // namespace
}  // namespace tactics::subject_test
