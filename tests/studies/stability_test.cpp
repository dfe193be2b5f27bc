// SPDX-License-Identifier: Apache-2.0
// `tactics evaluate --study stability` as the user meets it.
#include <gtest/gtest.h>

#include "tests/studies/evaluating.h"

namespace tactics::stability_test {
namespace {

using namespace tests;
namespace fs = std::filesystem;
// White with a black square in the middle.
std::string square(int size) {
    constexpr int kWidth = 200, kHeight = 160;
    return png(kWidth, kHeight,
               [size](int x, int y) { return std::abs(x - kWidth / 2) <= size / 2 && std::abs(y - kHeight / 2) <= size / 2; });
}

// White along the sides of that square.
std::string outline_of_square(int size) {
    constexpr int kWidth = 200, kHeight = 160;
    return png(kWidth, kHeight,
               [size](int x, int y) { return std::max(std::abs(x - kWidth / 2), std::abs(y - kHeight / 2)) != size / 2; });
}

class EvaluateStability : public testing::Test {
protected:
    EvaluateStability() {
        fs::create_directories(folder / "set");  // without contour maps
        write_bytes(folder / "set/a.png", square(60));
        write_bytes(folder / "set/b.png", square(100));
    }
    Ending study(Words words) {
        words.insert(words.begin(), {"evaluate", "set", "--study", "stability"});
        return run_tactics(folder, words);
    }
    Folder folder;
};

TEST_F(EvaluateStability, ASquareHoldsAndAFixedThresholdLosesItInTheDark) {
    const Ending table = study({"-r", "sobel-kmeans", "-r", "sobel", "--csv", "t.csv"});
    EXPECT_EQ(table.code, 0) << table.err;
    EXPECT_TRUE(holds(table.out, "recipe")) << table.out;
    EXPECT_TRUE(holds(table.out, "JPEG 70  JPEG 50  noise 10")) << table.out;
    EXPECT_TRUE(holds(table.out, "faint disc")) << table.out;
    const std::string csv = bytes_of(folder / "t.csv");
    const auto row = [&](std::string_view name) {
        const auto from = csv.find("\n" + std::string(name) + ",");
        return csv.substr(from + 1, csv.find("\r", from) - from - 1);
    };
    EXPECT_FALSE(holds(row("sobel-kmeans"), ",0.00")) << csv;
    EXPECT_TRUE(row("sobel-kmeans").ends_with(",1.00,1.00")) << csv;  // start and worst start
    EXPECT_TRUE(row("sobel").ends_with(",0.00,1.00,,")) << csv;       // dark 0.1, bright; nothing is left to chance
}

TEST_F(EvaluateStability, GivesTheSameWithAnyNumberOfWorkers) {
    const Ending one = study({"-r", "photo", "-r", "auto", "--json", "-j", "1"});
    const Ending many = study({"-r", "photo", "-r", "auto", "--json", "-j", "7"});
    EXPECT_EQ(one.code, 0) << one.err;
    EXPECT_EQ(one.out, many.out);
    EXPECT_TRUE(holds(one.out, R"("change":"dark 0.1")")) << one.out;
    EXPECT_TRUE(holds(one.out, R"("worst_picture":")")) << one.out;
    EXPECT_TRUE(holds(one.out, R"({"picture":"flat","ink":0})")) << one.out;
}

TEST_F(EvaluateStability, TellsHowManyPagesPeopleWouldFindWorse) {
    // People drew the outline of the first square; of what a fixed threshold draws of it nothing is left in the dark.
    fs::create_directories(folder / "people");
    write_bytes(folder / "people/a_gt1.png", outline_of_square(60));
    write_bytes(folder / "people/a_gt2.png", outline_of_square(60));
    write_bytes(folder / "people/a_gt3.png", outline_of_square(60));
    const Ending ending = study({"-r", "sobel", "--truth", "people", "--json"});
    EXPECT_TRUE(holds(ending.out, R"("change":"shift","f":)")) << ending.out;
    const auto dark = ending.out.substr(ending.out.find(R"("change":"dark 0.1")"));
    EXPECT_TRUE(holds(dark.substr(0, dark.find('}')), R"("p3_change":-1,"p3_worst_change":-1,"p3_worse":1,"p3_pictures":1)"))
        << dark;
    const auto shift = ending.out.substr(ending.out.find(R"("change":"shift")"));
    EXPECT_TRUE(holds(shift.substr(0, shift.find('}')), R"("p3_worse":0,"p3_pictures":1)")) << shift;
    const Ending table = study({"-r", "sobel", "--truth", "people"});
    EXPECT_TRUE(holds(table.out, "sobel, worse by 0.05   0 of 1")) << table.out;
}

TEST_F(EvaluateStability, RefusesWhatDoesNothing) {
    const Ending unknown = run_tactics(folder, {"evaluate", "set", "--study", "stabilty"});
    EXPECT_EQ(unknown.code, 1);
    EXPECT_TRUE(holds(unknown.err, "stability?")) << unknown.err;
    const Ending swept = study({"--sweep", "kmeans.k=2,3"});
    EXPECT_EQ(swept.code, 1);
    EXPECT_TRUE(holds(swept.err, "leave it out")) << swept.err;
}

TEST_F(EvaluateStability, NamesWhatCannotBeComparedAndGoesOn) {
    write_bytes(folder / "set/c.png", square(80).substr(0, 60));
    const Ending ending = study({"-r", "sobel", "-r", "none"});
    EXPECT_EQ(ending.code, 2);
    EXPECT_TRUE(holds(ending.err, "c.png")) << ending.err;
    EXPECT_TRUE(holds(ending.err, "recipe none: set/a.png: it draws neither lines nor regions")) << ending.err;
    EXPECT_TRUE(holds(ending.out, "\nsobel ")) << ending.out;
}

// As convert does, with the same words.
TEST_F(EvaluateStability, ReadsWhatHostileFilesBreakOnlyWhenAllowed) {
    fs::copy_file(fs::path(TACTICS_SOURCE_DIR) / "tests/fuzz/corpus/read/psd", folder / "set/c.psd");
    const Ending asked = study({"-r", "sobel"});
    if (holds(asked.err, "OpenImageIO")) GTEST_SKIP() << "OpenImageIO is not here";
    EXPECT_EQ(asked.code, 2);
    EXPECT_TRUE(holds(asked.err, "set/c.psd: ")) << asked.err;
    EXPECT_TRUE(holds(asked.err, "add --allow psd")) << asked.err;
    const Ending allowed = study({"-r", "sobel", "--allow", "psd"});
    EXPECT_EQ(allowed.code, 0) << allowed.err;
    EXPECT_FALSE(holds(allowed.err, "c.psd")) << allowed.err;
    const Ending wrong = study({"--allow", "jpeg"});
    EXPECT_EQ(wrong.code, 1);
    EXPECT_EQ(wrong.err, run_tactics(folder, {"convert", "set/a.png", "-o", "a.pdf", "--allow", "jpeg"}).err);
}

}  // namespace
}  // namespace tactics::stability_test
